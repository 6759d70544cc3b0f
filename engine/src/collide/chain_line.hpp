// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

// Sine of the turn up to which a chain vertex counts as flush. Normals there may deviate by that
// angle.
inline constexpr Real kFlush = Real(1e-3);

/// Unit vector from the first vertex of a line to the second one.
inline Vec2 alongOf(const ConvexShape& line) {
    return -perp(line.normals[1]);
}

/// Turn from one unit direction to another one, counter-clockwise positive: its sine up to a right
/// angle; beyond, a number that rises on to 2 for half a turn. Back along the same line counts as
/// half a turn clockwise, -2: a chain goes on around the end of a line on its other side.
inline Real turnBetween(Vec2 from, Vec2 to) {
    const Real sine = cross(from, to);
    if (dot(from, to) >= 0) {
        return sine;
    }
    return sine > 0 ? 2 - sine : -2 - sine;
}

/// turnBetween() of the lines that meet at a vertex: < 0: convex (hilltop), > 0: concave (valley).
inline Real turnAt(const ConvexShape& line, std::size_t end) {
    return end == 0 ? turnBetween(line.before, alongOf(line))
                    : turnBetween(alongOf(line), line.after);
}

/// True if no other line of the chain begins at vertex `end`, 0 or 1.
inline bool isFree(const ConvexShape& line, std::size_t end) {
    return (end == 0 ? line.before : line.after) == Vec2{};
}

/// The vertex, 0 or 1, to which a direction points along the line.
inline std::size_t endTowards(const ConvexShape& line, Vec2 direction) {
    return dot(direction, alongOf(line)) < 0 ? 0 : 1;
}

/// True for a line that is linked with others of its body: part of a chain.
inline bool isLinked(const ConvexShape& shape) {
    return shape.isLine() && !(shape.before == Vec2{} && shape.after == Vec2{});
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
