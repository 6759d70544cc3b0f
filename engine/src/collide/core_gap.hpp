// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// The gap between the cores of two shapes, in the frame of A. Cores that overlap have none.
struct CoreGap {
    Vec2 onA;                // m; nearest point of A
    Vec2 normal;             // unit, from A to B; zero: no gap
    Real distance = 0;       // m
    bool ofVertices = false; // between one vertex of each, else an edge is involved
    std::size_t vertexA = 0;
    std::size_t vertexB = 0;
};

/// The shortest gap, by GJK. Neither shape is a plane. `ab`: pose of B in the frame of A.
CoreGap gapOfCores(const ConvexShape& shapeA, const ConvexShape& shapeB, const Transform& ab);

/// Rounding error (m) of the vector of a gap.
inline Real roundingOf(const ConvexShape& shapeA, const ConvexShape& shapeB) {
    constexpr Real kRounding = 4 * std::numeric_limits<Real>::epsilon();
    return kRounding * (shapeA.boundingRadius + shapeB.boundingRadius);
}

/// True if a gap is so wide that its direction does not consist of rounding errors.
inline bool isClear(const CoreGap& gap, const ConvexShape& shapeA, const ConvexShape& shapeB) {
    return gap.distance > 4 * roundingOf(shapeA, shapeB);
}

} // namespace KODO_PRECISION
} // namespace kodo
