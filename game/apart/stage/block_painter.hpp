// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas.hpp>
#include <apart/stage/cracks.hpp>
#include <kodo/shapes/convex.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace apart {

/// How one block looks just now.
struct BlockLook {
    Stuff stuff = Stuff::Brick;
    Power power = Power::None;
    Real scale = 1;        // 0..1: it grows when the level begins
    Real heat = 0;         // 0..1: just hit
    std::uint32_t key = 0; // makes each block's grain its own
    std::span<const CrackLine> cracks{};
};

/// World corners of an outline; a round one becomes a polygon.
std::vector<Vec2> cornersOf(const kodo::Convex& outline, const kodo::Transform& place);

/// Moved towards their middle by about that distance (m).
std::vector<Vec2> shrunk(std::span<const Vec2> corners, Real distance);

/// Filled as if the light came from above.
void paintLit(Canvas& canvas, std::span<const Vec2> corners, Color color);

void paintBlock(Canvas& canvas, const kodo::Convex& outline, const kodo::Transform& place,
                const BlockLook& look);

} // namespace apart
