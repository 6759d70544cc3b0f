// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/core/level.hpp>
#include <apart/core/progress.hpp>
#include <kodo/kodo.hpp>

#include <cstdint>
#include <variant>

namespace apart {

/// What a body is to the game: one user flag each, so `roleOf(world[id].flags())` tells it.
enum class Role : std::uint16_t {
    Wall = 1,
    Paddle = 2,
    Block = 4,
    Ball = 8,
    Shard = 16,
    Part = 32,
    Obstruction = 128,
};
constexpr kodo::Flags flagsOf(Role role) {
    return static_cast<kodo::Flags>(role);
}
constexpr Role roleOf(kodo::Flags flags) {
    return static_cast<Role>(flags & 0xbf);
}

// What happened in one tick, in the order in which it was judged. Places in m, world; impulses in
// N s. A body that an event names may be gone already.

/// A ball hit something. Blocks say more in Cracked or Broke.
struct Struck {
    kodo::BodyId ball;
    kodo::BodyId other;
    Role what = Role::Wall;
    Stuff stuff = Stuff::Steel; // of a block or shard
    kodo::Vec2 point;
    kodo::Vec2 normal; // unit, towards the ball
    kodo::Real impulse = 0;
};
/// A block was hit and holds.
struct Cracked {
    kodo::BodyId block;
    std::uint32_t key = 0; // Block::key, its name for life
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    kodo::Real impulse = 0;
    kodo::Real strengthLeft = 0; // share of the full strength, 0..1
};
/// A block came apart.
struct Broke {
    kodo::BodyId block;
    std::uint32_t key = 0; // Block::key
    Stuff stuff = Stuff::Brick;
    Power power = Power::None;
    kodo::Vec2 point;       // of the impact
    kodo::Vec2 center;      // of the block
    kodo::Real impulse = 0; // of the blow
    int shards = 0;
    int combo = 0;  // blocks broken since a ball last met the paddle, this one included
    int points = 0; // added to the score
};
/// A block let its part go.
struct Released {
    kodo::BodyId part;
    Power power = Power::Weld;
    kodo::Vec2 point;
};
/// A part met the paddle. Welded, Stuck or PowerBegan follows.
struct Caught {
    kodo::BodyId part;
    Power power = Power::Weld;
    kodo::Vec2 point;
    kodo::Real impulse = 0;
};
/// A part is now one with the paddle.
struct Welded {
    kodo::Vec2 point;
    kodo::Real mass = 0; // kg, of the paddle with it
    int parts = 0;       // parts on the paddle
};
/// A welded part came off: blows had worn its weld away. It is a shard now.
struct KnockedOff {
    kodo::BodyId shard;
    kodo::Vec2 point;
    kodo::Real impulse = 0; // of the last blow
    int parts = 0;          // parts left on the paddle
};
/// A part sticks to the paddle, and counts down to its launch.
struct Stuck {
    kodo::BodyId part;
    kodo::Vec2 point;
};
/// A stuck part fired.
struct Launched {
    kodo::BodyId part;
    kodo::Vec2 point;
};
/// A launched part ended: on steel, or out of sight.
struct Spent {
    kodo::Vec2 point;
    bool onSteel = false;
};
/// A block came apart into balls.
struct BallSplit {
    kodo::Vec2 point;
    int balls = 0; // new ones
};
/// A ball left the paddle.
struct Served {
    kodo::BodyId ball;
    kodo::Vec2 point;
    kodo::Vec2 heading; // unit
};
/// A ball fell below the field.
struct BallLost {
    kodo::Vec2 point;
    int ballsLeft = 0;
};
/// The last ball fell.
struct LifeLost {
    int livesLeft = 0;
};
/// No breakable block is left: won.
struct Cleared {
    int score = 0;
};
/// No life is left.
struct Lost {
    int score = 0;
};

/// A shard broke again.
struct ShardBroke {
    kodo::BodyId shard;
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    kodo::Real impulse = 0;
    int pieces = 0;
};
/// A block is Hold::Loose from now on.
struct LetGo {
    enum class Why : std::uint8_t { Fatigue, BrokeOff, Unsupported, Torn };
    kodo::BodyId block;    // the loose one; a part of a boss had no body of its own before
    std::uint32_t key = 0; // Block::key
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point; // its middle
    Why why = Why::Fatigue;
};
/// A loose block left the field, and counts as cleared.
struct Fell {
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    int points = 0;
};
/// The last core of the boss broke or fell.
struct BossDown {
    kodo::Vec2 point;
};
/// A bumper kicked a body.
struct Bumped {
    kodo::BodyId body;
    kodo::BodyId bumper;
    kodo::Vec2 point;
    kodo::Vec2 normal; // unit, towards the body
};
/// A caught power works from now on, or for longer than it would have.
struct PowerBegan {
    Power power = Power::None;
    kodo::Vec2 point;
    std::uint32_t untilTick = 0;
};
struct PowerEnded {
    Power power = Power::None;
};
/// A ball is of another kind now, and another body.
struct BallChanged {
    kodo::BodyId before;
    kodo::BodyId now;
    BallKind kind = BallKind::Round;
};
/// With Power::Spring: the paddle leapt.
struct Leapt {
    kodo::Vec2 point;
};
/// The paddle's field begins, turns round or ends (None).
struct ForceChanged {
    Force force = Force::None;
};
/// A shard was drawn into the paddle and fed the meter.
struct ShardCaught {
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    kodo::Real meter = 0; // 0..1, after it
};
/// The progress clock entered another stage, or fell back to Calm.
struct PatienceChanged {
    Patience patience = Patience::Calm;
};
/// A ball came to the paddle in the same way once too often; the progress clock was moved on.
struct LoopSeen {
    kodo::BodyId ball;
};

using Event =
    std::variant<Struck, Cracked, Broke, Released, Caught, Welded, Stuck, Launched, Spent,
                 BallSplit, Served, BallLost, LifeLost, Cleared, Lost, KnockedOff, ShardBroke,
                 LetGo, Fell, BossDown, Bumped, PowerBegan, PowerEnded, BallChanged, Leapt,
                 ForceChanged, ShardCaught, PatienceChanged, LoopSeen>;

} // namespace apart
