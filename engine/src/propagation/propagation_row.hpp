// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <array>
#include <vector>

#include "lanes/contact_lane.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// A contact in the passes of Propagation.
struct PropagationRow {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t contact; // index in the list of contacts
    std::size_t count;     // points, 1 or 2
    Vec2 normal;
    struct Point {
        Real leverA; // m, cross(armA, normal)
        Real leverB; // m, cross(armB, normal)
        Real gap;    // m, at the start of the substep; < 0: overlap
    };
    Point points[2];
    std::array<Real, 2> impulse; // N s, sum so far by point, >= 0
    std::array<Real, 2> parting; // kg m, sum so far of the separation by point, >= 0
    Real tangentLeverA;          // m, for the mean of both points, which share one friction impulse
    Real tangentLeverB;
    Real friction; // N s, sum so far
    Real staticFriction;
    Real kineticFriction;
    Real surfaceSpeed;   // m/s, along perp(normal)
    Real rollingLever;   // m; 0 without rolling resistance
    Real rolling;        // N m s, sum so far
    std::uint32_t level; // the higher level of its bodies; see ShockLevels
    bool again;          // solved after the displacements: a joint holds a body, or one arrives

    Real load() const; // N s, normal impulse of all passes and both points
};

/// Inverse masses of the bodies of a row in a pass; 0 for a frozen body.
struct RowMasses {
    Real invMassA;
    Real invInertiaA;
    Real invMassB;
    Real invInertiaB;

    /// Speed (m/s) per N s, for an impulse with these levers (m) [Thesis06, eq. 4.9, the
    /// denominator].
    Real response(Real leverA, Real leverB) const {
        return invMassA + invMassB + leverA * leverA * invInertiaA + leverB * leverB * invInertiaB;
    }
};

/// Displacement of a body by the separation, apart from its velocity.
struct SeparationShift {
    Vec2 deltaPosition;  // m
    Real deltaAngle = 0; // rad
};

/// A row without impulses.
PropagationRow makeRow(const Contact& contact, std::uint32_t place);

RowMasses massesOf(const Bodies& bodies, const PropagationRow& row, bool frozenA = false,
                   bool frozenB = false);

/// Starts a row with the impulses of the step before, `before`, if its bodies move against each
/// other no faster than the forces of a substep of h (s) move them from rest. These have acted.
void warmStart(PropagationRow& row, const ContactLane& before, Bodies& bodies, Real h);

/// One visit: normal impulses, then friction and rolling within the bounds of the normal impulses
/// so far. `fraction` is 1 + e, with the restitution e <= 0 of the pass:
///
///   J = -(1 + e) (v_n + max(gap, 0) / h) / k,  k = response,  sum of J >= 0
///   |sum of friction| <= mu sum of J                  [Thesis06, eq. 4.9, 4.10; Guendelman03]
///
/// The sums are clamped, not the increments. So friction depends neither on e nor on the number of
/// passes, unlike in the thesis (4.3.3). A gap may close within h, but not become an overlap.
void solveRow(PropagationRow& row, Bodies& bodies, const RowMasses& masses, Real fraction,
              Real invH);

/// Limits of the separation (m).
struct SeparationLimits {
    Real allowed; // overlap that remains
    Real most;    // largest overlap removed at once
};

/// One visit that separates overlapping bodies as impulses would, but changes displacements instead
/// of velocities. So it adds no energy but that of lifting [Thesis06, 6.1]:
///
///   sum >= 0,  n . (delta_b - delta_a) >= min(-allowed - gap, most)   for gap < 0
void separateRow(PropagationRow& row, std::vector<SeparationShift>& parting,
                 const RowMasses& masses, const SeparationLimits& limits);

} // namespace KODO_PRECISION
} // namespace kodo
