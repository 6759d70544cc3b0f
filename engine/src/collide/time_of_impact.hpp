// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

namespace kodo {
inline namespace KODO_PRECISION {

/// Path of a body through one step: constant velocity and angular velocity. After `stopAt`,
/// translation by `push` only.
struct MotionPath {
    Transform start;     // of the centre of mass
    Vec2 deltaPosition;  // m, over the whole step
    Real deltaAngle = 0; // rad, over the whole step
    Real stopAt = 1;     // fraction of the step after which its own motion ends
    Vec2 push{};         // m per whole step: translation after stopAt

    Vec2 positionAt(Real fraction) const {
        const Real t = fraction < stopAt ? fraction : stopAt;
        return start.position + t * deltaPosition + (fraction - t) * push;
    }
    Transform at(Real fraction) const {
        const Real t = fraction < stopAt ? fraction : stopAt;
        return {positionAt(fraction), turned(start.rotation, t * deltaAngle)};
    }
};

/// Time of impact: the fraction (0..1) of the step after which two separated shapes first come
/// within `target` (m); 1 or more if they never do.
///
/// Conservative advancement [Mirtich96]: the closing speed along each axis has an upper bound from
/// velocities and rotation. The best axis determines the free part of the step; see
/// SeparationBound.
///
/// A one-sided line is hit only from its front. A chain of lines has no ghost impacts at its
/// vertices.
///
/// `from`: fraction before which the shapes are known not to come so near, or do not count.
///
/// Accuracy: half of `target`. With `target` < 0, the result is when touching shapes reach that
/// overlap.
Real timeOfImpact(const ConvexShape& shapeA, const MotionPath& a, const ConvexShape& shapeB,
                  const MotionPath& b, Real target, Real from = 0);

/// For a shape whose middle is in front of a one-sided line and its neighbours, even if it touches
/// or overlaps it: the fraction of the step after which its middle has come down to slop / 4 over
/// the line, or with `corners` one of its corners, which count for shapes thinner than `slop` (m)
/// anyway; 1 or more if none does. Points that start within `slop` may come down to -slop: the
/// contact holds them.
Real timeBehind(const ConvexShape& line, const MotionPath& a, const ConvexShape& other,
                const MotionPath& b, Real slop, bool corners);

} // namespace KODO_PRECISION
} // namespace kodo
