// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

// State of a game besides its World.

/// Pure: no rule changes the path of a ball at a contact, nor its mass. Assisted: balls are slower,
/// and more of a serve is shown.
enum class Mode : std::uint8_t { Standard, Pure, Assisted };
inline constexpr std::array<std::string_view, 3> kModeNames = {"standard", "pure", "assisted"};

/// The next mode in a circle.
constexpr Mode next(Mode mode) {
    return static_cast<Mode>((static_cast<std::size_t>(mode) + 1) % kModeNames.size());
}

/// An unbroken block. Only blocks of a boss share a body; the shape of each is part `part` of it.
struct Block {
    kodo::BodyId body{};
    BlockKind kind;
    kodo::Real strengthLeft = 0; // N s
    std::uint32_t key = 0;       // constant: row * kColumns + column, or keyOfFree()
    std::size_t part = 0;
    Support support = Support::Mounted;
    kodo::Vec2 local{};          // m, its centre in the frame of the body's shape
    kodo::BodyId pin{};          // body that it hangs from
    std::uint32_t looseTick = 0; // tick at which it was let go, or fell
    kodo::Transform home{};      // of its body at the start
    std::int32_t due = 0;        // points of a fallen block, until it lands

    bool ownsBody() const { return support != Support::Boss; }
    /// True if it must still be cleared.
    bool counts() const { return kind.breakable() && support != Support::Fallen; }
};

/// Key of a free block; keys of the grid are smaller.
constexpr std::uint32_t keyOfFree(std::size_t index) {
    return static_cast<std::uint32_t>(kColumns * kMostRows) + static_cast<std::uint32_t>(index);
}

/// What a standing block rests on or hangs from at the start.
struct Carrier {
    kodo::BodyId block{};
    kodo::BodyId by{};
    kodo::Vec2 place{}; // m, of the block in the frame of `by`
};

/// Water of the level.
struct Water {
    kodo::Aabb region{};    // m; its surface is the upper side
    kodo::Real density = 0; // kg/m^2
    std::int32_t dam = -1;  // as in WaterDef
    bool open = false;      // it runs out
    kodo::Vec2 breach{};    // m, where it does

    bool isEmpty() const { return region.upper.y <= region.lower.y; }
    /// Height (m) at which the outflow ends.
    kodo::Real floor() const;
};

/// A joint of the level that holds.
struct Link {
    LinkKind kind = LinkKind::Pin;
    kodo::JointId joint{};
    kodo::Vec2 place{}; // m, world; of the joint in the last tick
};

/// Blocks of a building that fell or broke in one chain.
struct Collapse {
    std::int32_t blocks = 0;    // 0: none is going on
    std::int32_t points = 0;    // of its blocks
    std::uint32_t lastTick = 0; // of its last block
    std::int32_t landed = 0;    // of its blocks; they broke, landed or left
    kodo::Vec2 sum{};           // m, world; of the places where they did
    std::int32_t largest = 0;   // most blocks of one collapse so far
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
    kodo::Vec2 heading;  // unit; last direction of flight
    bool riding = false; // on the paddle, waiting for the serve
    bool hollow = false; // served, and not returned by a moved paddle
    BallKind kind = BallKind::Round;
    std::uint32_t carriedTicks = 0; // slow on a dynamic bar or block
};

/// A piece of a broken block.
struct Shard {
    kodo::BodyId body;
    Stuff stuff = Stuff::Brick;
    std::uint32_t bornTick = 0;
    kodo::Real strengthLeft = 0; // N s
};

enum class PartState : std::uint8_t { Loose, Stuck, Launched };

/// A power-up: a body of its own until it is caught. A welded one is a part of the paddle's body
/// and not listed here.
struct Part {
    kodo::BodyId body;
    Power power = Power::Weld;
    PartState state = PartState::Loose;
    std::uint32_t sinceTick = 0; // tick at which its state began
    kodo::Vec2 offset;           // m, in the paddle's frame; while stuck
    kodo::Vec2 origin;           // m, world; centre of the block that released it
};

/// An active power.
struct Effect {
    Power power = Power::None;
    std::uint32_t untilTick = 0;
    kodo::Vec2 place; // m, world; of a well
    int side = 1;     // of a wind: 1 to the right, -1 to the left
};

/// Work and impulse that rules, not contacts, gave to bodies so far; negative if taken from them.
/// Without contacts the balance is
///
///   kinetic + potential energy = initial energy + sum of all works
///
/// The potential energy of bodies that fall is m kGravity y. Not recorded: wind, wells, motors, and
/// losses by friction and restitution. Mounts of unbroken blocks act like walls.
struct Ledger {
    double servoWork = 0; // J, to balls, by the governor
    double fieldWork = 0; // J, by the paddle's field and magnet
    double breakWork = 0; // J, to pieces of blocks, by impact and internal stress
    double kickWork = 0;  // J, by bumpers, broken welds, and the drive of launched parts
    // Impulse of the paddle's force field and magnet on bodies, and of a pull on a mount. A mount
    // acts like a wall. The paddle receives the opposite impulse.
    double fieldImpulseX = 0; // N s
    double fieldImpulseY = 0;
    // Impulse that the mounts of broken blocks took; the pieces have the rest. mountTurn includes
    // the change of angular momentum of a loose block with a part: its mass is uniform, that of its
    // pieces is larger in the middle.
    double mountImpulseX = 0; // N s
    double mountImpulseY = 0;
    double mountTurn = 0;      // N m s, about the origin
    double removedMass = 0;    // kg, of shards, parts and loose blocks removed or caught
    std::uint32_t bounces = 0; // of balls, off any body
    // Of these; 0 in Mode::Pure.
    std::uint32_t bentBounces = 0;   // rotated out of the cone around the horizontal
    std::uint32_t thrownBounces = 0; // thrown off rubble, see throwOff()
};

/// Weld of a part on the paddle. Like a block, it breaks when impacts have used up its strength.
struct Weld {
    kodo::Real strengthLeft = 0; // N s
    kodo::Vec2 lastPoint{};      // m, world; of the last impact
    kodo::Real lastImpulse = 0;  // N s
    bool wing = false;           // a plate of Power::Wings
};

} // namespace apart
