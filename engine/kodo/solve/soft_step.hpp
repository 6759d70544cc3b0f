// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact.hpp>
#include <kodo/joints/joint_set.hpp>
#include <kodo/solve/settings.hpp>

#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// A contact as the passes see it. Everything is found once a step; the passes only multiply and
/// add. Arms are fixed for the step: a separation follows the motion to first order in the turn.
struct ContactRow {
    std::uint32_t a;
    std::uint32_t b;
    std::uint32_t contact; // place in the list it came from
    int count;
    bool onLocked; // one side cannot be pushed: the contact is made twice as stiff
    Vec2 normal;
    struct Point {
        Real leverA; // cross(armA, normal)
        Real leverB;
        Real mass; // kg, effective, along the normal
        Real separation;
        Real impulse;
    };
    Point points[2];
    Real tangentLeverA; // of both points' mean, since they share one friction
    Real tangentLeverB;
    Real tangentMass;
    Real friction; // N s so far
    Real staticFriction;
    Real kineticFriction;
    Real pushSpeed;    // m/s at most, to part the two
    Real rollingLever; // m; 0 without rolling resistance
    Real rollingMass;  // kg m^2
    Real rolling;      // N m s so far
};

/// The contact half of the step, in substeps [Catto24]. Each moves velocities by the forces, starts
/// from the impulses of the substep before, makes one pass that pushes overlaps apart like stiff
/// springs, moves the bodies, and makes one pass without that push, which takes its speed out
/// again.
///
///   lambda = -m (s v_n + bias) - c lambda_sum,  lambda_sum >= 0;  |friction| <= mu lambda_sum
///
/// The sums are clamped, not the increments, so a later pass may take back what an earlier one
/// overdid, and friction depends neither on restitution nor on the number of passes.
class SoftStep {
public:
    void solve(Bodies& bodies, std::span<Contact> contacts, JointSet& joints,
               const StepSettings& settings, const Tolerances& tolerances, Real dt);
    std::size_t rowCount() const { return rows_.size(); }

private:
    void makeRows(const Bodies& bodies, std::span<const Contact> contacts, const JointSet& joints,
                  const StepSettings& settings, const Tolerances& tolerances);
    void countCrowds(const Bodies& bodies, std::span<const Contact> contacts,
                     const Tolerances& tolerances);
    void store(std::span<Contact> contacts) const;

    std::vector<ContactRow> rows_;
    std::vector<std::uint8_t> held_;   // by body: something touches it
    std::vector<std::uint16_t> crowd_; // by body: how many overlap it deeply
};

} // namespace kodo::inline KODO_PRECISION
