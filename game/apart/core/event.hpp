// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
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
};
constexpr kodo::Flags flagsOf(Role role) {
    return static_cast<kodo::Flags>(role);
}
constexpr Role roleOf(kodo::Flags flags) {
    return static_cast<Role>(flags & 0x3f);
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
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    kodo::Real impulse = 0;
    kodo::Real strengthLeft = 0; // share of the full strength, 0..1
};
/// A block came apart.
struct Broke {
    kodo::BodyId block;
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
/// A part met the paddle. Welded or Stuck follows.
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

using Event = std::variant<Struck, Cracked, Broke, Released, Caught, Welded, Stuck, Launched, Spent,
                           BallSplit, Served, BallLost, LifeLost, Cleared, Lost, KnockedOff>;

} // namespace apart
