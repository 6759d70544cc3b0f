// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/event.hpp>
#include <apart/core/input.hpp>
#include <apart/core/level.hpp>
#include <apart/core/paddle.hpp>
#include <apart/core/progress.hpp>
#include <apart/core/things.hpp>
#include <kodo/kodo.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace apart {

/// With the inputs it determines a game.
struct Origin {
    std::shared_ptr<const Level> level;
    std::uint32_t seed = 0;
    Mode mode = Mode::Standard;
};

enum class Result : std::uint8_t { Playing, Won, Lost };
inline constexpr std::array<std::string_view, 3> kResultNames = {"playing", "won", "lost"};

struct Counts {
    std::int32_t score = 0;
    std::int32_t lives = 0;      // including the one in play
    std::int32_t combo = 0;      // blocks broken since the last paddle hit
    std::int32_t blocksLeft = 0; // breakable and not fallen
    std::int32_t blocksAtStart = 0;
    std::uint32_t serves = 0;
    std::int32_t hits = 0;      // of balls on the paddle; a serve is one
    std::uint32_t hitTick = 0;  // of the last hit
    bool blow = false;          // what is cleared counts for that hit
    std::int32_t leftAtHit = 0; // blocksLeft at that hit, or now if nothing counts for it
    std::int32_t bestBlow = 0;  // most blocks that one hit cleared, until a building is down
    std::int32_t prizeUnit = 0; // points of all blocks, times kPrizeFactor
    std::uint32_t downTick = 0; // since which the building is down; 0: it is not

    /// A ball touched the paddle, or was served, at a tick, and begins a blow or does not.
    void hit(std::uint32_t tick, bool begins = true);
    /// Compares the blocks that the last hit cleared with the best blow. To be called each tick.
    void watchBlow();
    /// Points for the best blow, if the game were won now.
    std::int32_t prize() const { return prizeUnit * bestBlow / (blocksAtStart - bestBlow + 1); }
    /// What is left of the building comes down, and no ball is needed any more.
    bool isDown() const { return downTick > 0; }
};

/// Force field of the paddle.
struct PaddleField {
    Force force = Force::None; // active one; None when the meter is empty
    kodo::Real meter = 1;      // 0..1
    kodo::Real tornSpeed = 0;  // m/s that the pull would have given a free nextToFall()
};

struct Paddle {
    kodo::BodyId body;
    kodo::Real speed = 0;      // m/s
    kodo::Real servedFrom = 0; // m, x at the last serve
    kodo::Real moved = 0;      // m, farthest from there since
    Sway sway;
    std::vector<Weld> welds;       // by part of the body, from part 1
    kodo::Vec2 serveHeading{0, 1}; // unit; of the next serve
    PaddleField field;
};

struct Boss {
    struct Impact {
        std::uint32_t key = 0;
        kodo::Vec2 point;
        kodo::Vec2 impulse;
    };
    kodo::BodyId body;
    kodo::Real home = 0;         // m; x of the middle of its oscillation
    int way = 1;                 // 1: to the right
    std::vector<Impact> impacts; // of this tick
};

/// Timed powers.
struct Powers {
    std::vector<Effect> effects;
    bool fieldsStale = false; // within a tick: the force fields of `effects` must be set again
};

/// What holds the blocks of buildings, and how they fall.
struct Buildings {
    std::vector<Link> links;
    std::vector<Carrier> carriers;
    Collapse collapse;
};

/// State of a Game. The rules (game_rules.hpp) change it; this class answers questions about it.
struct GameState {
    Origin origin;
    std::uint32_t tick = 0;
    Result result = Result::Playing;
    Counts counts;

    kodo::World world;
    std::vector<kodo::BodyId> walls;
    Paddle paddle;
    std::vector<Block> blocks;
    std::vector<Ball> balls;
    std::vector<Shard> shards;
    std::vector<Part> parts;
    std::vector<Obstruction> obstructions;
    std::vector<Water> waters;
    Buildings buildings;
    Boss boss;

    Powers powers;
    ProgressClock clock;
    Ledger ledger;
    std::vector<Event> events; // of the last tick

    int weldedParts() const { return static_cast<int>(paddle.welds.size()); }
    kodo::Real secondsLeft(Power power) const; // 0: not active
    BallKind ballKind() const;                 // of all balls in play
    PaddleKind paddleKind() const;
    kodo::Real windSpeed() const; // m/s, to the right; level and effects together
    Patience patience() const { return clock.patience(); }
    kodo::Real idleSeconds() const;  // of the progress clock, which runs faster at the end
    const Block* nextToFall() const; // its mount fails next; nullptr: none
    bool tears() const;              // a pull acts on nextToFall()
    kodo::Real tornShare() const;    // 0..1, progress of that pull
    std::optional<kodo::BodyId> livingBoss() const;
    const Block* findBlock(kodo::BodyId body, std::size_t part = 0) const; // nullptr: none
    kodo::Transform frameOf(const Block& block) const; // at the centre of the block
    Stuff stuffOf(kodo::BodyId body, std::size_t part) const;
    bool isRubble(kodo::BodyId body) const;
    bool canCarry(kodo::BodyId body) const; // dynamic bar of a motor or block
    /// First wall, block or obstruction on the straight path of a ball along `way` (m).
    std::optional<kodo::QueryHit> ahead(kodo::Vec2 from, kodo::Vec2 way) const;
    bool meetsBlock(kodo::Vec2 from, kodo::Vec2 way) const; // ahead() is breakable
    /// Length (m) of a ball's path, with its bounces off what stands still, from a point along a
    /// unit heading to the first block that counts; none if it meets none in six bounces.
    std::optional<kodo::Real> wayToBlock(kodo::Vec2 from, kodo::Vec2 heading) const;
    bool isCarried(const Block& block) const; // at its place on what carries it
    bool keeps() const;                       // Level::keep has not fallen; false without one
    bool serving() const;
    bool armed() const; // a ball in play is not hollow
    /// A hit with this ball begins a blow: it is not hollow. Under pure rules, where none is, the
    /// paddle has moved since the serve as far as would fill it.
    bool beginsBlow(const Ball& ball) const;
    bool falls() const;           // a block has fallen, and not landed yet
    kodo::Real ballSpeed() const; // m/s; target of the speed servo
    std::uint64_t hash() const;
};

} // namespace apart
