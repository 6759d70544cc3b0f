// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/short_list.hpp>
#include <kodo/math/aabb.hpp>
#include <kodo/shapes/shape.hpp>

#include <cstdint>

namespace kodo::inline KODO_PRECISION {

enum class OutlineKind : std::uint8_t {
    Round, // one vertex with a skin: circles, and points without one
    Sided, // at least three vertices
    Line,  // two vertices and nothing between them
    Half,  // one vertex on the surface; everything behind it is solid
};

/// The one form in which the engine keeps every primitive: a convex outline with a skin of `radius`
/// around it. A circle is one vertex with a skin; a box or polygon has none.
///
/// Vertices run counter-clockwise; edge i goes from vertex i to vertex i + 1, and normals[i] is its
/// outward unit normal. A line has two edges, back and front: normals[1] is the left hand on the
/// way from vertex 0 to vertex 1, the side that a one-sided line blocks.
struct Convex {
    static constexpr std::size_t kFew = 8; // as many as outlines of games have, as a rule
    using Points = ShortList<Vec2, kFew>;

    Points vertices;
    Points normals; // empty for a single vertex, except a plane's
    Real radius = 0;
    Real reach = 0;  // no point is farther than this from the frame's origin
    Real inside = 0; // radius of a disc around some inner point that fits: how thin the shape is
    Vec2 middle;     // centroid of the outline
    Vec2 before;     // of a one-sided line: unit direction of the line that ends at vertex 0
    Vec2 after;      // and of the one that starts at vertex 1; zero where there is none
    OutlineKind kind = OutlineKind::Round;
    bool oneSided = false;

    /// m; a turn by 1 rad about the frame's origin takes no point of the outline farther. A disc in
    /// the middle looks alike however it is turned.
    Real swing() const { return isRound() && vertices[0] == Vec2{} ? 0 : reach; }
    bool isRound() const { return kind == OutlineKind::Round; }
    bool isLine() const { return kind == OutlineKind::Line; }
    bool isPlane() const { return kind == OutlineKind::Half; }
};

/// Outline of a valid primitive, moved by -origin (the body's centre of mass, as a rule).
Convex convexOf(const Primitive& primitive, Vec2 origin);

/// Bounds of the outline placed at t. Those of a plane end on its surface where they can, and else
/// at kEndless.
Aabb boundsOfAngular(const Convex& convex, const Transform& t); // of any that is not round
inline Aabb boundsOf(const Convex& convex, const Transform& t) {
    if (!convex.isRound()) {
        return boundsOfAngular(convex, t);
    }
    const Vec2 center = t * convex.vertices[0];
    return Aabb{center, center}.grown(convex.radius);
}
inline constexpr Real kEndless = sizeof(Real) == 4 ? Real(1e12) : Real(1e20); // m

/// World point inside or on the outline placed at t? On a line only what lies exactly on it is.
bool contains(const Convex& convex, const Transform& t, Vec2 point);

} // namespace kodo::inline KODO_PRECISION
