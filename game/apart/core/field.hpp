// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/event.hpp>
#include <apart/core/fracture.hpp>
#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

#include <array>

namespace apart {

// Body definitions of the objects of the game.

// User flags of bodies that gravity acts on. Wind, wells and the paddle's field act on kFalls only,
// so that a building stands.
inline constexpr kodo::Flags kFalls = 64;
inline constexpr kodo::Flags kStands = 256; // of a building, also once it has fallen

std::array<kodo::BodyDef, 3> wallDefs(); // left, right, top
kodo::BodyDef paddleDef(kodo::Real x);
/// The plates of Power::Wings, in the frame of the paddle: left, right.
std::array<kodo::Polygon, 2> wingShapes();

/// Adds a ball. `position` is the origin of its shape; its centre of mass may differ.
kodo::BodyId addBall(kodo::World& world, kodo::Vec2 position, BallKind kind);
/// Bounding radius (m) of a ball about the origin of its shape.
kodo::Real reachOf(BallKind kind);

/// True if `place` is so far outside the field that nothing returns from it.
bool isGone(kodo::Vec2 place);

kodo::Vec2 centerOf(const Cell& cell);
/// The mass of a block is the sum of the masses of its pieces.
kodo::BodyDef blockDef(const BlockKind& kind, const PlacedShape& placed);
kodo::BodyDef blockDef(const BlockKind& kind, kodo::Vec2 center); // of the grid
/// Points of a block, without a factor.
std::int32_t pointsOf(const BlockKind& kind);
/// Density (kg/m^2) of the material of a block.
kodo::Real densityOf(const BlockKind& kind);
/// Limits for all shards, also for those of broken shards.
PieceLimits shardLimits();
/// Strength (N s) of a shard with this area (m^2).
kodo::Real shardStrength(Stuff stuff, kodo::Real area);

/// A piece of a broken block, in the frame of the block.
struct Piece {
    kodo::Shape shape;
    kodo::Real density = 1;
    Role role = Role::Shard; // Shard, Part or Ball
    kodo::Mass mass;         // of shape and density
};
/// All pieces of a block of this shape after an impact at `hit`. Their masses sum to that of the
/// block. A block with a power is a rectangle.
std::vector<Piece> piecesOf(const BlockKind& kind, const kodo::Shape& shape, kodo::Vec2 hit,
                            std::uint64_t key);

/// Body of a Shard or Part; `frame` is that of the block.
kodo::BodyDef pieceDef(const Piece& piece, const PieceMotion& motion, const kodo::Transform& frame);

// Obstructions. The bar of a motor turns about a pivot, a separate body.
kodo::BodyDef obstructionDef(const ObstructionDef& def);
/// The corners (m) of ground that has an outline.
std::vector<kodo::Vec2> outlineOf(const ObstructionDef& ground);
/// The same ground as convex polygons, for pictures.
kodo::Shape solidOf(const ObstructionDef& ground);
kodo::BodyDef pinDef(kodo::Vec2 place);
kodo::BodyDef pivotDef(kodo::Vec2 place);

} // namespace apart
