// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collide/manifold.hpp>
#include <kodo/shapes/convex.hpp>

namespace kodo::inline KODO_PRECISION {

/// The point of the outline of a polygon, or of a line from both sides, that is nearest to the
/// centre of a circle, seen from the polygon.
struct RoundAxis {
    Vec2 normal;             // unit, from the polygon towards the centre
    Real distance = 0;       // m, from the outline to the centre; < 0 with the centre inside
    std::size_t feature = 0; // edge i, or vertex i + number of edges
};

/// The side with the largest distance to the centre decides [Thesis06, 3.2.2]; beyond its ends the
/// corner does, by Pythagoras, as in Arvo's test of sphere and box.
RoundAxis nearestToCenter(const Convex& polygon, Vec2 center);

/// Finds the arm of circle B from its own centre, and not by way of A's, which may lie far away: so
/// no rounding gives the contact a lever that a turn of the circle would follow.
inline void armFromOwnCenter(Manifold& manifold, const Convex& circle, const Transform& b) {
    ManifoldPoint& p = manifold.points[0];
    p.armB = b.rotation * circle.vertices[0] - (circle.radius + p.separation / 2) * manifold.normal;
}

} // namespace kodo::inline KODO_PRECISION
