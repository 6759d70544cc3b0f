// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

#include <algorithm>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// Relative motion of two shapes from now on, with constant velocities and angular velocities.
struct RelativePath {
    static constexpr Real kNever = 2; // fraction of a step that is never reached

    Vec2 towards;         // m per step: velocity of A relative to B; world axes
    Real deltaAngleA = 0; // rad per step
    Real deltaAngleB = 0; // rad per step
    Real turning = 0;     // m per step: upper bound of the approach by rotation alone
    Real length = 0;      // duration as a fraction of a step
    Real target = 0;      // m: separation of interest
};

/// Time bounds from separating axes along a path. `last`: until then an axis that separates the
/// shapes by more than the target still does. `first`: from then on another axis does. If first <
/// last, the shapes pass each other. With the faces as axes, a target of 0 and no rotation, the
/// bounds are exact for polygons [Ericson05, 5.5.2]. Then projections on an axis begin to overlap
/// at `last` at the latest. They cease to overlap at `first` at the earliest.
struct SeparationBound {
    Real distance = -std::numeric_limits<Real>::infinity(); // m, now; the best of the tested axes
    Real last = 0;                     // fraction of a step from now; separated at least until then
    Real first = RelativePath::kNever; // separated from then until the end of the path

    bool passes(const RelativePath& path) const { return last >= path.length || first < last; }

    /// Updates the bounds with a fixed axis (world) from A towards B. The closing speed along it is
    /// at most the relative velocity plus the bound for rotation.
    void see(Vec2 axis, Real separation, const RelativePath& path) {
        const Real closing = dot(axis, path.towards) + path.turning;
        const Real now = separation - path.target;
        const Real then = now - closing * path.length;
        distance = std::max(distance, separation);
        if (now > 0) {
            last = std::max(last, then > 0 ? path.length : now / closing);
        } else if (then > 0) {
            first = std::min(first, now / closing);
        }
    }
};

/// Bounds from all face and corner axes of two shapes, until one axis separates them over the whole
/// path. One-sided lines count as two-sided; two planes never meet.
SeparationBound separationBoundOf(const ConvexShape& shapeA, const Transform& a,
                                  const ConvexShape& shapeB, const Transform& b,
                                  const RelativePath& path);

} // namespace KODO_PRECISION
} // namespace kodo
