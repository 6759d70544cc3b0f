// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/event.hpp>
#include <apart/core/fracture.hpp>
#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

#include <array>

namespace apart {

/// What the things of the game are made of, as definitions of bodies.

// A further user flag, of what falls.
inline constexpr kodo::Flags kFalls = 64;

std::array<kodo::BodyDef, 3> wallDefs(); // left, right, top
kodo::BodyDef paddleDef(kodo::Real x);
/// The plates of Power::Wings, in the frame of the paddle: left, right.
std::array<kodo::Polygon, 2> wingShapes();

/// A ball about `position`, the middle of its outline; that of its mass may lie beside it.
kodo::BodyId addBall(kodo::World& world, kodo::Vec2 position, BallKind kind);
/// From the middle of a ball's outline to its farthest point (m).
kodo::Real reachOf(BallKind kind);

/// So far outside the field that it has left it for good?
bool isGone(kodo::Vec2 place);

kodo::Vec2 centerOf(const Cell& cell);
/// A block weighs what its pieces will.
kodo::BodyDef blockDef(const BlockKind& kind, kodo::Vec2 center);
/// How many kg a square metre of a block weighs.
kodo::Real densityOf(const BlockKind& kind);
/// Limits for the shards of a whole block, and for theirs.
PieceLimits shardLimits();
/// Of a shard with this area (m^2), in N s.
kodo::Real shardStrength(Stuff stuff, kodo::Real area);

/// A piece of a broken block, in the frame of the block.
struct Piece {
    kodo::Shape shape;
    kodo::Real density = 1;
    Role role = Role::Shard; // Shard, Part or Ball
    kodo::Mass mass;         // of shape and density
};
/// All pieces of a block of this kind after a blow at `hit`. Their masses add up to the block's.
std::vector<Piece> piecesOf(const BlockKind& kind, kodo::Vec2 hit, std::uint64_t key);

/// Of a Shard or Part; `frame` is that of the block.
kodo::BodyDef pieceDef(const Piece& piece, const PieceMotion& motion, const kodo::Transform& frame);

// What stands in the way. A motor's bar turns about a pivot, a body of its own.
kodo::BodyDef obstructionDef(const ObstructionDef& def);
kodo::BodyDef pinDef(kodo::Vec2 place);
kodo::BodyDef pivotDef(kodo::Vec2 place);

} // namespace apart
