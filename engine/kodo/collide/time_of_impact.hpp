// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shapes/convex.hpp>

namespace kodo::inline KODO_PRECISION {

/// The way of a body through one step: a straight line and an even turn, and a straight line alone
/// once it has been stopped.
struct Sweep {
    Transform start; // of the centre of mass
    Vec2 move;       // m, over the whole step
    Real turn = 0;   // rad, over the whole step
    Real stopAt = 1; // share of the step after which it does not go on by itself
    Vec2 push{};     // m, over a whole step: how it is pushed along from there on

    Transform at(Real share) const {
        const Real t = share < stopAt ? share : stopAt;
        return {start.position + t * move + (share - t) * push, turned(start.rotation, t * turn)};
    }
};

/// The share (0..1) of the step after which two outlines that start apart are `target` (m) apart
/// for the first time; 1 or more when they never are.
///
/// Conservative advancement [Mirtich96]: along no axis do they close faster than a bound that their
/// motion and their turns give, so as much of the step is free as the best of all axes leaves; see
/// Outlook.
///
/// A one-sided line is hit from its front alone, and a chain of them only where it really is, not
/// on its joints.
///
/// The answer is found to half of `target`. A target below zero asks when two outlines that touch
/// come as deep as that.
Real timeOfImpact(const Convex& shapeA, const Sweep& a, const Convex& shapeB, const Sweep& b,
                  Real target);

} // namespace kodo::inline KODO_PRECISION
