// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collide/manifold.hpp>
#include <kodo/shapes/convex.hpp>

namespace kodo::inline KODO_PRECISION {

/// Where two outlines placed at a and b are closer than `margin` (m). Between two polygons, a face
/// of A carries the contact unless one of B separates better by more than `preference` (m). A
/// one-sided line has no contact with what is behind it; the manifold says so then.
Manifold collide(const Convex& shapeA, const Transform& a, const Convex& shapeB, const Transform& b,
                 Real margin, Real preference);

/// How far apart two outlines are along the axis that separates them best; < 0 in overlap. Between
/// two polygons no more than their distance, and > 0 exactly when that is. Lines have both sides
/// here; two planes never meet.
struct Separation {
    Vec2 axis; // unit, world, from A towards B
    Real distance = 0;
};
Separation separation(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                      const Transform& b);

} // namespace kodo::inline KODO_PRECISION
