// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include "base/state_stream.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// Data that a solver reads and writes in every pass: 32 bytes (float) per body.
struct BodyVelocity {
    Vec2 velocity;            // m/s, of the centre of mass
    Real angularVelocity = 0; // rad/s
    Real invMass = 0;         // 1/kg; 0: immovable (static, kinematic, frozen or motion lock)
    Vec2 deltaPosition;       // m, since the start of the step
    Real deltaAngle = 0;      // rad, since the start of the step
    Real invInertia = 0;      // 1/(kg m^2); 0: cannot rotate

    /// Clears the displacement and keeps the velocity.
    void clearDisplacement() {
        deltaPosition = {};
        deltaAngle = 0;
    }
    bool unmoved() const { return deltaPosition == Vec2{} && deltaAngle == 0; }
    /// Bound (m) of the displacement of any point of the body.
    Real way(Real rotationReach) const {
        return length(deltaPosition) + std::abs(deltaAngle) * rotationReach;
    }
    /// Clears velocity and displacement.
    void stop() {
        velocity = {};
        angularVelocity = 0;
        clearDisplacement();
    }
    /// True if neither impulses nor torques can move the body.
    bool locked() const { return invMass == 0 && invInertia == 0; }
    void visitState(StateStream& stream) { // masses follow from geometry and flags
        auto& [ownVelocity, spin, ownInvMass, way, turn, ownInvInertia] = *this;
        stream(ownVelocity, spin, way, turn);
    }
};

/// World velocity (m/s) of the point at an arm (m) from the centre of mass [Thesis06, eq. 4.5].
inline Vec2 velocityAt(const BodyVelocity& motion, Vec2 arm) {
    return motion.velocity + cross(motion.angularVelocity, arm);
}

/// Applies an impulse (N s) and an angular one (N m s), with the masses of a pass. A locked body is
/// not written: islands share it, and an infinite impulse in one of them times 0 would be NaN in
/// all.
inline void applyImpulse(BodyVelocity& motion, Real invMass, Vec2 impulse, Real invInertia,
                         Real angular) {
    if (invMass != 0 || invInertia != 0) {
        motion.velocity += invMass * impulse;
        motion.angularVelocity += invInertia * angular;
    }
}

/// Applies an impulse (N s) at the end of an arm (m).
inline void applyImpulse(BodyVelocity& motion, Vec2 arm, Vec2 impulse) {
    applyImpulse(motion, motion.invMass, impulse, motion.invInertia, cross(arm, impulse));
}

/// Constant over a step; from forces and fields.
struct Acceleration {
    Vec2 linear;      // m/s^2
    Real angular = 0; // rad/s^2
    /// m/s^2: sum of the magnitudes of all forces per mass, including forces that cancel out.
    /// Finite, so that 0 times it is 0.
    Real forcePerMass = 0;
};

/// Ranges of mass and acceleration over the awake bodies.
struct LoadRange {
    Real maxInvMass = 0; // 1/kg, as the next
    Real minInvMass = std::numeric_limits<Real>::max();
    /// (m/s^2)^2, as the next, which includes bodies that can only rotate.
    Real maxAccelerationSquared = 0;
    Real minAccelerationSquared = std::numeric_limits<Real>::max();
    bool driven = false; // some are locked, and move
};

/// Four consecutive numbers as a SIMD vector. Each lane computes the same bits as a scalar.
using Four = Real __attribute__((vector_size(4 * sizeof(Real)), aligned(sizeof(Real)), may_alias));

/// Velocity x, y, angular velocity, 1/mass.
inline Four& speeds(BodyVelocity& motion) {
    static_assert(offsetof(BodyVelocity, velocity) == 0 &&
                  offsetof(BodyVelocity, deltaPosition) == sizeof(Four));
    return reinterpret_cast<Four&>(motion);
}
inline const Four& speeds(const BodyVelocity& motion) {
    return reinterpret_cast<const Four&>(motion);
}
/// Displacement x, y, angle, 1/inertia.
inline Four& moves(BodyVelocity& motion) {
    static_assert(sizeof(BodyVelocity) == 2 * sizeof(Four));
    return reinterpret_cast<Four&>(motion.deltaPosition);
}
inline const Four& moves(const BodyVelocity& motion) {
    return reinterpret_cast<const Four&>(motion.deltaPosition);
}
/// Acceleration x, y, angular acceleration, forcePerMass.
inline const Four& rates(const Acceleration& acceleration) {
    static_assert(sizeof(Acceleration) == sizeof(Four));
    return reinterpret_cast<const Four&>(acceleration);
}

} // namespace KODO_PRECISION
} // namespace kodo
