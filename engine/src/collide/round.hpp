// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

#include "collide/manifold.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// The boundary point of a shape nearest to the centre of a circle, in the frame of the shape.
struct RoundAxis {
    Vec2 normal;             // unit, from the shape towards the centre
    Real distance = 0;       // m, from the boundary to the centre; < 0: the centre is inside
    std::size_t feature = 0; // edge i, or vertex i + number of edges
};

/// The side with the largest distance to the centre decides [Thesis06, 3.2.2]. Beyond its ends, the
/// distance to the corner decides, as in Arvo's test of sphere and box. Lines are two-sided. Not
/// for planes.
RoundAxis nearestToCenter(const ConvexShape& shape, Vec2 center);

/// Computes the arm of circle B from its own centre instead of A's, which may be far away. Rounding
/// then adds no lever arm and no torque.
inline void armFromOwnCenter(Manifold& manifold, const ConvexShape& circle, const Transform& b) {
    ManifoldPoint& p = manifold.points[0];
    p.armB = b.rotation * circle.vertices[0] - (circle.radius + p.separation / 2) * manifold.normal;
}

} // namespace KODO_PRECISION
} // namespace kodo
