// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "contacts/contact_set.hpp"

#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// A body of a pair that may meet.
struct MovingBody {
    std::uint32_t body;
    Real rotationReach; // m, of its shape; see ConvexShape
    Real stopAt = 1;    // fraction of the step
};

/// Bound (m) of the motion of two shapes towards each other within the step. It is small for bodies
/// that move together.
Real relativeMotion(const Bodies& bodies, const MovingBody& movingA, const MovingBody& movingB);

/// Bound (m) of the motion of b towards a against `normal` (from A to B).
Real motionAgainst(const Bodies& bodies, Vec2 normal, const MovingBody& movingA,
                   const MovingBody& movingB);

/// Separation (m) at the start of the step of a pair without a sensor.
Real gapOf(const Bodies& bodies, const ContactSet& contactSet, std::uint32_t slot,
           const Tolerances& tolerances);

/// True for a touching pair that the solver did not hold: with restitution, since it may touch at
/// another point (Departure::BetweenImpacts), or since it seemed to pass (removePassing()).
bool isUnheld(const Bodies& bodies, const ContactSet& contactSet, std::uint32_t slot, Real slop);
/// Fraction of the step after which the touching points of such a pair have left, by twice `near`
/// (m). No value if they do not leave.
std::optional<Real> departureTime(const Bodies& bodies, const ContactSet& contactSet,
                                  std::uint32_t slot, Real near, Real slop);

} // namespace KODO_PRECISION
} // namespace kodo
