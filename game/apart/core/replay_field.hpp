// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace apart {

/// Quantity of an expectation of a replay: a value of the state after the tick, a value of the last
/// event of a kind, or the number of events of a kind so far. game/replays.md lists all.
enum class Field : std::uint8_t {
    // Values of the state.
    BlocksLeft,
    Score,
    Lives,
    Combo,
    Balls,
    Shards,
    Parts,       // loose, stuck or launched
    PaddleParts, // welded to the paddle
    PaddleX,     // 1/1000 m
    PaddleMass,  // 1/1000 kg
    Tilt,        // 1/1000 rad, of the paddle
    Lift,        // 1/1000 m, of the paddle
    BallX,       // 1/1000 m, of the first ball; 0 without one
    BallY,
    BallSpeed,   // 1/1000 m/s
    LooseBlocks, // Support::Loose
    Meter,       // 1/1000
    Effects,     // number of active powers
    Wind,        // 1/1000 m/s
    BentBounces, // see Ledger
    LargestFall, // most blocks of one collapse so far
    Result,      // playing won lost
    BallKind,    // round heavy lopsided egg rough
    Patience,    // calm glowing shaking failing
    MomentumX,   // 1/1000 kg m/s, of all balls and shards
    MomentumY,
    PieceMomentumX, // 1/1000 kg m/s, of all shards
    PieceMomentumY,
    PieceSpin,  // 1/1000 kg m^2/s, of all shards, about their centre of mass
    PieceSpeed, // 1/1000 m/s, of the fastest shard
    PieceMass,  // 1/1000 kg, of the heaviest shard
    PieceX,     // 1/1000 m, centre of mass of the heaviest shard; 0 without one
    PieceY,
    PieceMassAll,  // 1/1000 kg, of all shards
    MountImpulseX, // 1/1000 N s, see Ledger
    MountImpulseY,
    MountTurn,     // 1/1000 N m s
    FieldImpulseX, // 1/1000 N s
    FieldImpulseY,
    ServoWork, // 1/1000 J, see Ledger
    FieldWork,
    BreakWork,
    KickWork,
    RemovedMass, // 1/1000 kg
    Bounces,
    ThrownBounces,
    PowerTicks, // ticks that the power that ends first is still active; 0: none
    PaddleHits, // of balls; a serve is one
    Prize,      // points, if the game were won now
    ServeX,     // 1/1000, x/y of the direction of the next serve
    // Values of the last event; 0 before the first.
    HitImpulse, // 1/1000 N s, of Struck
    HitX,       // 1/1000 m
    HitY,
    CrackImpulse, // 1/1000 N s, of Cracked
    CrackBlock,   // Block::key
    BreakImpulse, // 1/1000 N s, of Broke
    BreakX,       // 1/1000 m, point of the impact
    BreakY,
    BreakBlock,   // Block::key
    BreakPieces,  // shards of the block
    PieceImpulse, // 1/1000 N s, of ShardBroke
    PieceBroken,  // pieces of it
    CollapseSize, // blocks, of Collapsed
    SnapForce,    // 1/1000 N, of Snapped
    PowerName,    // of PowerBegan, PowerEnded does not change it; a name of a power
    FirstEvent,
};
inline constexpr std::size_t kStateFields = static_cast<std::size_t>(Field::HitImpulse);
inline constexpr std::size_t kValueFields = static_cast<std::size_t>(Field::FirstEvent);
inline constexpr std::size_t kEventKinds = std::variant_size_v<Event>;
inline constexpr std::array<std::string_view, kValueFields + kEventKinds> kFieldNames = {
    "blocksLeft", "score", "lives", "combo", "balls", "shards", "parts", "paddleParts", "paddleX",
    "paddleMass", "tilt", "lift", "ballX", "ballY", "ballSpeed", "looseBlocks", "meter", "effects",
    "wind", "bentBounces", "largestFall", "result", "ballKind", "patience", "momentumX",
    "momentumY", "pieceMomentumX", "pieceMomentumY", "pieceSpin", "pieceSpeed", "pieceMass",
    "pieceX", "pieceY", "pieceMassAll", "mountImpulseX", "mountImpulseY", "mountTurn",
    "fieldImpulseX", "fieldImpulseY", "servoWork", "fieldWork", "breakWork", "kickWork",
    "removedMass", "bounces", "thrownBounces", "powerTicks", "paddleHits", "prize", "serveX",
    // Of the last event.
    "hitImpulse", "hitX", "hitY", "crackImpulse", "crackBlock", "breakImpulse", "breakX", "breakY",
    "breakBlock", "breakPieces", "pieceImpulse", "pieceBroken", "collapseSize", "snapForce",
    "power",
    // In the order of Event's alternatives.
    "struck", "cracked", "broke", "released", "caught", "welded", "stuck", "launched", "spent",
    "ballSplit", "served", "ballLost", "lifeLost", "cleared", "lost", "knockedOff", "shardBroke",
    "letGo", "landed", "bossDown", "bumped", "powerBegan", "powerEnded", "ballChanged", "leapt",
    "forceChanged", "shardCaught", "patienceChanged", "loopSeen", "collapsed", "snapped",
    "splashed", "breached"};
/// Names of the values of a field; empty for a numeric field.
std::span<const std::string_view> valueNames(Field field);

/// Values of all fields, tick by tick.
class FieldValues {
public:
    /// To be called after each tick.
    void note(const Game& game);
    std::int64_t valueOf(const Game& game, Field field) const;

private:
    void set(Field field, kodo::Real value);
    void set(Field field, std::int64_t value);

    std::array<std::int64_t, kValueFields - kStateFields> last_{};
    std::array<std::int64_t, kEventKinds> counts_{};
};

} // namespace apart
