// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

// Two-sided lines of one body that share vertices.

/// True for a two-sided line that shares a vertex with others of its body.
inline bool isJointed(const ConvexShape& shape) {
    return shape.isLine() && !shape.oneSided && !(shape.before == Vec2{} && shape.after == Vec2{});
}

/// Heights (m) of a point over a jointed line, > 0 on the side of normals[1], with the neighbours
/// of each side. They differ where three lines or more meet: a point with front < 0 and back > 0 is
/// then between other lines.
struct JointHeights {
    Real front = 0;
    Real back = 0;
};

/// Heights over a jointed line. Beyond a vertex, over the line and its neighbour: above a hilltop
/// the larger one, above a valley the smaller one. So it is beside the neighbour of a sharp bend.
/// What lies on the neighbour of a hilltop may be below it by `sink` (m).
JointHeights heightOverJoints(const ConvexShape& line, Vec2 p, Real sink);

/// True if two lines of a body share a vertex, and none of the others there is between them on the
/// side of the first one: 1 for that of its normals[1], else -1.
bool areNeighbours(const ConvexShape& line, Real side, const ConvexShape& next);

/// The first point on the way between two points that is beside a jointed line or one of its
/// neighbours; `to` if there is none. Farther from them other lines may bend, so that a height over
/// these three has no meaning.
Vec2 withinJoints(const ConvexShape& line, Vec2 from, Vec2 to);

} // namespace KODO_PRECISION
} // namespace kodo
