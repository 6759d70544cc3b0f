// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/event.hpp>
#include <apart/core/fracture.hpp>
#include <kodo/kodo.hpp>

#include <array>

namespace apart {

/// What the things of the game are made of, as definitions of bodies.

// A further user flag, of what falls.
inline constexpr kodo::Flags kFalls = 64;

std::array<kodo::BodyDef, 3> wallDefs(); // left, right, top
kodo::BodyDef paddleDef(kodo::Real x);
kodo::BodyDef ballDef(kodo::Vec2 position);

kodo::Vec2 centerOf(const Cell& cell);
/// A block weighs what its pieces will.
kodo::BodyDef blockDef(const BlockKind& kind, kodo::Vec2 center);
/// Limits for the shards of a whole block.
PieceLimits shardLimits();

/// A piece of a broken block, in the frame of the block.
struct Piece {
    kodo::Shape shape;
    kodo::Real density = 1;
    Role role = Role::Shard; // Shard, Part or Ball
    kodo::Mass mass;         // of shape and density
};
/// All pieces of a block of this kind after a blow at `hit`. Their masses add up to the block's.
std::vector<Piece> piecesOf(const BlockKind& kind, kodo::Vec2 hit, std::uint64_t key);

kodo::BodyDef pieceDef(const Piece& piece, const PieceMotion& motion, kodo::Vec2 blockCenter);

} // namespace apart
