// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

/// What the state of a game is made of, beside its World.

/// Without the smallest turn at contacts no path is ever bent by a rule.
enum class Mode : std::uint8_t { Standard, Pure };
inline constexpr std::array<std::string_view, 2> kModeNames = {"standard", "pure"};

/// A block that has not come apart. Its shape is part `part` of its body, which it shares with
/// others only when it belongs to a boss.
struct Block {
    kodo::BodyId body{};
    BlockKind kind;
    kodo::Real strengthLeft = 0; // N s
    std::uint32_t key = 0;       // its name for life: row times kColumns plus column
    std::size_t part = 0;
    Hold hold = Hold::Mounted;
    kodo::Vec2 local{};          // m, its middle in the frame of the body's shape
    kodo::BodyId pin{};          // what it hangs on
    std::uint32_t looseTick = 0; // when it was let go
};

struct Obstruction {
    ObstructionKind kind = ObstructionKind::Bumper;
    kodo::BodyId body{};
    kodo::BodyId pivot{};      // of a motor's bar
    kodo::Real kick = 0;       // m/s, of a bumper
    std::uint32_t hitTick = 0; // of the last kick; 0: never
};

struct Ball {
    kodo::BodyId body;
    kodo::Vec2 heading;  // unit; where it last flew
    bool riding = false; // on the paddle, waiting for the serve
    BallKind kind = BallKind::Round;
    std::uint32_t carriedTicks = 0; // on a bar or a block that moves, since it flew fast
};

/// A piece of a broken block.
struct Shard {
    kodo::BodyId body;
    Stuff stuff = Stuff::Brick;
    std::uint32_t bornTick = 0;
    kodo::Real strengthLeft = 0; // N s
};

enum class PartState : std::uint8_t { Loose, Stuck, Launched };

/// A power-up: a body like any other until it meets the paddle. A welded one is no longer here, but
/// is a part of the paddle's body.
struct Part {
    kodo::BodyId body;
    Power power = Power::Weld;
    PartState state = PartState::Loose;
    std::uint32_t sinceTick = 0; // when its state began
    kodo::Vec2 offset;           // m, from the paddle's frame; while stuck
    kodo::Vec2 origin;           // m, world; middle of the block that it comes from
};

/// A caught power at work.
struct Effect {
    Power power = Power::None;
    std::uint32_t untilTick = 0;
    kodo::Vec2 place; // m, world; of a well
    int side = 1;     // of a wind: to the right or to the left
};

/// What rules, not contacts, have given to bodies so far (below 0: taken from them). Of everything
/// that no contact touches, what is booked here and what is seen in the world add up:
///
///   kinetic + potential energy = that of the start + all works
///
/// Gravity is not booked: what it gave is missing in the height, m kGravity y, of what falls. Nor
/// are wind, wells and motors, nor what contacts eat by friction and restitution, nor the mounts of
/// what cracks or is made of steel: they hold like walls.
struct Ledger {
    double servoWork = 0; // J, to balls, by the governor
    double fieldWork = 0; // J, by the paddle's field and magnet
    double breakWork = 0; // J, to the pieces of blocks, by the blow and by their own tension
    double kickWork = 0;  // J, by bumpers, welds that give way, and the drive of launched parts
    // By the paddle's field and magnet to what they draw, and by a pull to the mount that it tears
    // at: a mount holds like a wall, and nothing moves, but the paddle got as much back of it all.
    double fieldImpulseX = 0; // N s
    double fieldImpulseY = 0;
    // What the mounts of blocks that broke took of the blows; the pieces have the rest. In the turn
    // also what a loose block had that was to let a part go: only its pieces are heavier in the
    // middle.
    double mountImpulseX = 0; // N s
    double mountImpulseY = 0;
    double mountTurn = 0;      // N m s, about the origin
    double removedMass = 0;    // kg, of shards and parts that crumbled, fell out or were caught
    std::uint32_t bounces = 0; // of balls, off anything
    // Of these, none in Mode::Pure:
    std::uint32_t bentBounces = 0;   // turned out of the cone around the horizontal
    std::uint32_t thrownBounces = 0; // thrown off rubble that would have swallowed the ball
};

/// What holds a part on the paddle. Like a block, it gives way when blows have used its strength
/// up.
struct Weld {
    kodo::Real strengthLeft = 0; // N s
    kodo::Vec2 lastPoint{};      // of the last blow; m, world
    kodo::Real lastImpulse = 0;  // N s
    bool wing = false;           // a plate of Power::Wings
};

} // namespace apart
