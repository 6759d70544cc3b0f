// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

// Two-sided lines of one body that are linked.

/// True for a two-sided line that is linked with others of its body.
inline bool isJointed(const ConvexShape& shape) {
    return shape.isLine() && !shape.oneSided && !(shape.before == Vec2{} && shape.after == Vec2{});
}

/// Height (m) of a point over a jointed line, > 0 on the side of normals[1]. Beyond a vertex, over
/// the line and its neighbour: above a hilltop the larger one, above a valley the smaller one. So
/// it is beside the neighbour of a sharp bend. What lies on the neighbour of a hilltop may be below
/// it by `sink` (m).
Real heightOverJoints(const ConvexShape& line, Vec2 p, Real sink);

/// 1 if two lines are linked and go in the same direction, -1 if they go in opposite ones, 0 if
/// they are not linked.
Real directionBetween(const ConvexShape& line, const ConvexShape& next);

/// The first point on the way between two points that is beside a jointed line or one of its
/// neighbours; `to` if there is none. Farther from them other lines may bend, so that a height over
/// these three has no meaning.
Vec2 withinJoints(const ConvexShape& line, Vec2 from, Vec2 to);

} // namespace KODO_PRECISION
} // namespace kodo
