// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/core/level.hpp>
#include <apart/core/progress.hpp>
#include <apart/core/role.hpp>
#include <kodo/kodo.hpp>

#include <cstdint>
#include <variant>

namespace apart {

// Events of one tick, in the order of evaluation. Points are in m, world; impulses in N s. A body
// named by an event may already be removed.

/// A ball hit a body. For a breakable block Cracked or Broke follows.
struct Struck {
    kodo::BodyId ball;
    kodo::BodyId other;
    Role what = Role::Wall;
    Stuff stuff = Stuff::Steel; // of a block or shard
    char letter = 0;            // BlockKind::letter of a block
    kodo::Vec2 point;
    kodo::Vec2 normal; // unit, towards the ball
    kodo::Real impulse = 0;
};
/// A block was damaged without breaking.
struct Cracked {
    kodo::BodyId block;
    std::uint32_t key = 0; // Block::key
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    kodo::Real impulse = 0;
    kodo::Real strengthLeft = 0; // share of the full strength, 0..1
};
/// A block broke.
struct Broke {
    kodo::BodyId block;
    std::uint32_t key = 0; // Block::key
    Stuff stuff = Stuff::Brick;
    Power power = Power::None;
    kodo::Vec2 point;       // of the impact
    kodo::Vec2 center;      // of the block
    kodo::Real impulse = 0; // of the impact
    int shards = 0;
    int combo = 0;  // blocks broken since the last paddle hit, including this one
    int points = 0; // added to the score
};
/// A broken block released its part.
struct Released {
    kodo::BodyId part;
    Power power = Power::Weld;
    kodo::Vec2 point;
};
/// A part was caught by the paddle. Welded, Stuck or PowerBegan follows.
struct Caught {
    kodo::BodyId part;
    Power power = Power::Weld;
    kodo::Vec2 point;
    kodo::Real impulse = 0;
};
/// A part was welded to the paddle.
struct Welded {
    kodo::Vec2 point;
    kodo::Real mass = 0; // kg, of the paddle including the part
    int parts = 0;       // parts on the paddle
};
/// A welded part came off, because impacts used up the strength of its weld. It is now a shard.
struct KnockedOff {
    kodo::BodyId shard;
    kodo::Vec2 point;
    kodo::Real impulse = 0; // of the last impact
    int parts = 0;          // parts left on the paddle
};
/// A part sticks to the paddle until its launch.
struct Stuck {
    kodo::BodyId part;
    kodo::Vec2 point;
};
/// A stuck part was launched.
struct Launched {
    kodo::BodyId part;
    kodo::Vec2 point;
};
/// A launched part was removed: it hit steel or left the field.
struct Spent {
    kodo::Vec2 point;
    bool onSteel = false;
};
/// A block broke into balls.
struct BallSplit {
    kodo::Vec2 point;
    int balls = 0; // number of new balls
};
/// A ball was served.
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
/// No breakable block is left: won. Points of the end, by source.
struct Cleared {
    int lives = 0;  // balls that are left
    int prize = 0;  // see kPrizeFactor
    int spared = 0; // Level::keep has not fallen
};
/// No life is left: lost.
struct Lost {
    int score = 0;
};

/// A shard broke.
struct ShardBroke {
    kodo::BodyId shard;
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    kodo::Real impulse = 0;
    int pieces = 0;
};
/// A block became Support::Loose, or Support::Fallen if it was standing.
struct LetGo {
    enum class Why : std::uint8_t { Fatigue, BrokeOff, Unsupported, Torn, Toppled };
    kodo::BodyId block;    // new if the block was part of a boss
    std::uint32_t key = 0; // Block::key
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point; // its centre
    Why why = Why::Fatigue;
};
/// A fallen block landed, broke up, was caught or left the field, or a loose one left it: its
/// points count.
struct Landed {
    kodo::BodyId block;
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point; // where it touched; its centre if it did not land
    int points = 0;
    kodo::Real impulse = 0; // N s, of the landing; 0: it did not land
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
/// A caught power became active, or its time was extended.
struct PowerBegan {
    Power power = Power::None;
    kodo::Vec2 point;
    std::uint32_t untilTick = 0;
};
struct PowerEnded {
    Power power = Power::None;
};
/// A ball changed its kind; its body was replaced.
struct BallChanged {
    kodo::BodyId before;
    kodo::BodyId now;
    BallKind kind = BallKind::Round;
};
/// The paddle leapt, with Power::Spring.
struct Leapt {
    kodo::Vec2 point;
};
/// The force field of the paddle started, reversed or ended (None).
struct ForceChanged {
    Force force = Force::None;
};
/// A shard was pulled into the paddle and added to the meter.
struct ShardCaught {
    Stuff stuff = Stuff::Brick;
    kodo::Vec2 point;
    kodo::Real meter = 0; // 0..1, after it
};
/// The progress clock entered another stage.
struct PatienceChanged {
    Patience patience = Patience::Calm;
};
/// A ball repeated similar paddle hits kLoopTimes; the progress clock was advanced.
struct LoopSeen {
    kodo::BodyId ball;
};

/// Blocks of a building fell or broke in one chain, which is now over. At least kLeastCollapse.
struct Collapsed {
    int blocks = 0;
    int points = 0;   // of these blocks, already in the score
    kodo::Vec2 point; // mean of the places where they landed or broke
};
/// A joint of the level broke.
struct Snapped {
    LinkKind kind = LinkKind::Pin;
    kodo::Vec2 point;
    kodo::Real force = 0; // N
};

/// A body crossed the surface of water.
struct Splashed {
    kodo::BodyId body;
    kodo::Vec2 point;     // on the surface
    kodo::Real speed = 0; // m/s, upwards
    kodo::Real mass = 0;  // kg
};
/// A block of a dam broke or fell: the water runs out.
struct Breached {
    kodo::Vec2 point; // centre of that block
};

using Event = std::variant<Struck, Cracked, Broke, Released, Caught, Welded, Stuck, Launched, Spent,
                           BallSplit, Served, BallLost, LifeLost, Cleared, Lost, KnockedOff,
                           ShardBroke, LetGo, Landed, BossDown, Bumped, PowerBegan, PowerEnded,
                           BallChanged, Leapt, ForceChanged, ShardCaught, PatienceChanged, LoopSeen,
                           Collapsed, Snapped, Splashed, Breached>;

} // namespace apart
