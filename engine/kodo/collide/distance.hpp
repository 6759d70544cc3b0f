// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/convex.hpp>

namespace kodo::inline KODO_PRECISION {

/// The two points of two outlines that are nearest to each other, in the world.
struct Nearness {
    Vec2 onA;
    Vec2 onB;
    Vec2 normal;       // unit, from a to b; zero where they overlap
    Real distance = 0; // m; 0 where they touch or overlap, and then both points are one common one
};

/// The true distance, corners against corners included, where separation() gives the width of the
/// gap along one axis alone.
///
/// The distance of the origin from the set of all b - a, by a simplex that walks towards it
/// [Ericson05, 9.5]. Lines have both sides; two planes are 0 apart.
Nearness distance(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                  const Transform& b);

/// The point of an outline nearest to a world point, which is itself if it lies inside.
Nearness distance(const Convex& shape, const Transform& t, Vec2 point);

} // namespace kodo::inline KODO_PRECISION
