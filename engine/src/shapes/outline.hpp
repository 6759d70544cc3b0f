// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>

#include <optional>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// True if a corner lies on the line between its neighbours. Uses twice the flatness that check()
/// refuses, so that rounding there cannot decide otherwise. The point of a needle is not flat:
/// without it, that point would lie far outside.
bool isFlat(Vec2 before, Vec2 corner, Vec2 after);
void dropFlatCorners(std::vector<Vec2>& corners);

/// Area (m^2) within a closed outline; < 0 if its points go clockwise.
Real areaWithin(std::span<const Vec2> points);

/// Two edges of a closed outline, by the points at which they begin; first < second.
struct EdgePair {
    std::size_t first;
    std::size_t second;
};

/// Two edges that cross or touch, apart from neighbours at their common point; the pair with the
/// smallest `second`, then `first`.
std::optional<EdgePair> edgesThatMeet(std::span<const Vec2> points);

} // namespace KODO_PRECISION
} // namespace kodo
