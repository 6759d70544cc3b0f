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
    BlockKind kind{};
    Real scale = 1;        // 0..1: it grows when the level begins
    Real heat = 0;         // 0..1: just hit
    Real glow = 0;         // 0..1: worth hitting
    std::uint32_t key = 0; // makes each block's grain its own
    std::span<const CrackLine> cracks{};
};

/// World corners of an outline; a round one becomes a polygon.
std::vector<Vec2> cornersOf(const kodo::Convex& outline, const kodo::Transform& place);

/// The rim of what is painted.
struct Rim {
    Real width = Real(0.06); // m
    Color color{};
};

/// Filled as if the light came from above.
void paintLit(Canvas& canvas, std::span<const Vec2> corners, Color color, Rim rim);

/// An outline of a body that stands at `place`.
void paintBlock(Canvas& canvas, const kodo::Convex& outline, const kodo::Transform& place,
                const BlockLook& look);

} // namespace apart
