// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/contacts/contact.hpp>

#include <array>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// A contact as the passes of Propagation see it.
struct PropagationRow {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t contact; // place in the list it came from
    std::size_t count;     // of points, 1 or 2
    Vec2 normal;
    struct Point {
        Real leverA; // cross(armA, normal)
        Real leverB; // cross(armB, normal)
        Real gap;    // m, at the start of the part; < 0 in overlap
    };
    Point points[2];
    std::array<Real, 2> impulse; // N s so far, by point, >= 0
    std::array<Real, 2> parting; // kg m so far, of separation, >= 0
    Real tangentLeverA;          // of both points' mean, since they share one friction
    Real tangentLeverB;
    Real friction; // N s so far
    Real staticFriction;
    Real kineticFriction;
    Real rollingLever;   // m; 0 without rolling resistance
    Real rolling;        // N m s so far
    std::uint32_t level; // of the higher of its bodies; see ShockLevels

    Real load() const; // N s, of all passes, both points
};

/// What a pass may do to the two bodies of a row: a frozen one has no inverse mass.
struct RowMasses {
    Real invMassA;
    Real invInertiaA;
    Real invMassB;
    Real invInertiaB;

    /// Per N s, for an impulse with these levers [Thesis06, eq. 4.9, the denominator].
    Real response(Real leverA, Real leverB) const {
        return invMassA + invMassB + leverA * leverA * invInertiaA + leverB * leverB * invInertiaB;
    }
};

/// How a separation moves a body, apart from its velocity.
struct Parting {
    Vec2 move;     // m
    Real turn = 0; // rad
};

/// A row without impulses.
PropagationRow makeRow(const Contact& contact, std::uint32_t place);

/// One visit: normal impulses, then friction and rolling within what the normal impulses so far
/// allow. `share` is 1 + e with the restitution e of the pass, which is negative or 0:
///
///   J = -(1 + e) (v_n + max(gap, 0) / h) / k,  k = response,  sum of J >= 0
///   |sum of friction| <= mu sum of J                  [Thesis06, eq. 4.9, 4.10; Guendelman03]
///
/// The sums are clamped and not the impulses, so friction depends neither on e nor on the number of
/// passes, as it does in the thesis (4.3.3). A gap may be closed within h, and no more.
void solveRow(PropagationRow& row, Bodies& bodies, const RowMasses& masses, Real share, Real invH);

/// Settings of a separation (m).
struct PartingLimits {
    Real allowed; // overlap that stays
    Real most;    // overlap taken away at once
};

/// One visit that parts overlapping bodies as impulses would, but moves them instead of giving them
/// velocity, so that no energy comes of it but that of being lifted [Thesis06, 6.1]:
///
///   sum >= 0,  n . (move_b - move_a) >= min(-allowed - gap, most)   for gap < 0
void partRow(PropagationRow& row, std::vector<Parting>& parting, const RowMasses& masses,
             const PartingLimits& limits);

} // namespace kodo::inline KODO_PRECISION
