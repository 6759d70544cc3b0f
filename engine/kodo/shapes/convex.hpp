// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/aabb.hpp>
#include <kodo/shapes/shape.hpp>

#include <vector>

namespace kodo::inline KODO_PRECISION {

/// The one form in which the engine keeps every primitive: a convex outline with a skin of `radius`
/// around it. A circle is one vertex with a skin; a box or polygon has none.
///
/// Vertices run counter-clockwise; edge i goes from vertex i to vertex i + 1, and normals[i] is its
/// outward unit normal.
struct Convex {
    std::vector<Vec2> vertices;
    std::vector<Vec2> normals; // empty for a single vertex
    Real radius = 0;
    Real reach = 0;  // no point is farther than this from the frame's origin
    Real inside = 0; // radius of a disc around some inner point that fits: how thin the shape is

    bool isRound() const { return vertices.size() == 1; }
};

/// Outline of a valid primitive, moved by -origin (the body's centre of mass, as a rule).
Convex convexOf(const Primitive& primitive, Vec2 origin);

/// Bounds of the outline placed at t.
Aabb boundsOf(const Convex& convex, const Transform& t);

/// World point inside or on the outline placed at t?
bool contains(const Convex& convex, const Transform& t, Vec2 point);

} // namespace kodo::inline KODO_PRECISION
