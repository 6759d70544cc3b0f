// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/effects/cracks.hpp>
#include <kodo/convex_shape.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace apart {

/// The current appearance of one block.
struct BlockLook {
    BlockKind kind{};
    Real scale = 1;        // 0..1; grows at the start of the level
    Real heat = 0;         // 0..1; 1 just after a hit
    Real glow = 0;         // 0..1; highlights a block to hit
    std::uint32_t key = 0; // seed of the block's grain
    std::span<const CrackLine> cracks{};
    bool fallen = false; // rubble of a building
    float left = 1;      // opacity, 0..1
};

/// World corners of a convex shape. A circle becomes a polygon.
std::vector<Vec2> cornersOf(const kodo::ConvexShape& outline, const kodo::Transform& place);

struct Rim {
    Real width = Real(0.06); // m
    Color color{};
};

/// Filled polygon, lit from above.
void paintLit(Canvas& canvas, std::span<const Vec2> corners, Color color, Rim rim);

/// Paints one convex part of a block whose body has the mass frame `place`.
void paintBlock(Canvas& canvas, const kodo::ConvexShape& outline, const kodo::Transform& place,
                const BlockLook& look);

} // namespace apart
