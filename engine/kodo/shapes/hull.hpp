// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/shape.hpp>

#include <span>
#include <variant>

namespace kodo::inline KODO_PRECISION {

/// The smallest convex polygon around points in any order, or why there is none: fewer than three
/// distinct points, all on one line, one that is not finite or beyond kLargest, more than
/// kMaxCorners corners.
///
/// Points inside, repeated points and points along a side are no corners. Nor is a corner so flat
/// that check() would refuse it for lying on the line of its neighbours; the outline loses no more
/// than rounding by that. Starts at the leftmost, then lowest, corner.
std::variant<Polygon, Problem> convexHull(std::span<const Vec2> points);

} // namespace kodo::inline KODO_PRECISION
