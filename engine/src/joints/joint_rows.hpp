// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joint.hpp>

#include "joints/anchor.hpp"
#include "math/softness.hpp"

#include <limits>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {

/// The building blocks of joints: constraints between two bodies, solved by impulses. All geometry
/// is current within the step, in world axes.

/// Relative to the squared trace of K, without a mass: a smaller determinant is rounding error.
inline constexpr Real kSingularPoint = 16 * std::numeric_limits<Real>::epsilon();

struct AxisConstraint;

/// The angular constraint without bounds that is solved right after another constraint of the same
/// joint. With u as the change of angular speed per impulse of the other one, and L the angular
/// impulse that the angle would take now, the other impulse is
///
///   impulse = -(K - u u^T / (1/I_a + 1/I_b))^-1 (speed + u L)
///
/// The matrix is (1/m_a + 1/m_b) 1 + d d^T / (I_a + I_b), d = perp(rA) - perp(rB): both bodies
/// turn as one. In this form nothing cancels, however small one of the inertias is.
struct CoupledAngle {
    const AxisConstraint* constraint = nullptr;
    Real impulse = 0;

    /// The angular impulse that the angle would take now.
    Real missing(const BodyVelocity& a, const BodyVelocity& b, bool biased) const;
    /// The fraction of a relative rotation that the angle removes; 0 without an angle.
    Real removed(bool biased) const;
};

/// Point constraint: drives the relative velocity v_b + w_b x r_b - v_a - w_a x r_a of two anchors
/// to zero, both coordinates at once [Catto09].
struct PointConstraint {
    Vec2 armA;
    Vec2 armB;
    Vec2 error; // m, point b minus point a
    Softness softness{};
    Vec2 arc{}; // m/s, by which the tangents of both anchors leave their arcs in the substep
    Real maxImpulse = std::numeric_limits<Real>::infinity(); // N s
    CoupledAngle angle{};

    /// Applies an impulse to the bodies and adds it to the accumulated one.
    void solve(BodyVelocity& a, BodyVelocity& b, Vec2& impulse, bool biased) const;
    /// The impulse that solve would add.
    Vec2 missing(const BodyVelocity& a, const BodyVelocity& b, Vec2 impulse, bool biased) const;
    /// The relative velocity of the anchors by an impulse.
    Vec2 give(const BodyVelocity& a, const BodyVelocity& b, Vec2 impulse) const {
        return (a.invMass + b.invMass) * impulse +
               a.invInertia * cross(armA, impulse) * perp(armA) +
               b.invInertia * cross(armB, impulse) * perp(armB);
    }
    /// The impulse that removes a relative velocity of the anchors: K^-1 speed. 0 if both bodies
    /// are immovable. `turned` is CoupledAngle::removed().
    Vec2 stopping(const BodyVelocity& a, const BodyVelocity& b, Vec2 speed, Real turned = 0) const;
    /// Relative angular velocity per angular impulse (1/(kg m^2)) if the anchors stay together.
    Real hinged(const BodyVelocity& a, const BodyVelocity& b) const;
    /// The impulse that keeps the anchors together under an angular impulse (N m s) of the joint.
    Vec2 reaction(const BodyVelocity& a, const BodyVelocity& b, Real twist) const;
    /// Applies an impulse to the bodies.
    void apply(BodyVelocity& a, BodyVelocity& b, Vec2 impulse) const;
    /// Adds the impulse on b to the linear sum (N s); the angular one (N m s) stays.
    void addToSums(Vec2 impulse, Vec2& linear, Real& angular) const;
};

inline constexpr Range kUnbounded{-std::numeric_limits<Real>::infinity(),
                                  std::numeric_limits<Real>::infinity()};

inline constexpr Range kOneSided{0, kUnbounded.upper};

/// The point constraint that is solved right after an angular constraint of the same joint. Let u
/// be the change of angular speed per impulse at the point, and P the impulse that the point would
/// apply now. Then the angular impulse is
///
///   impulse = -(speed + u P) / (1/I_a + 1/I_b - u K^-1 u)
///
/// and both constraints hold after one pass, as in a direct solve of all three rows. Without this
/// term the angle uses the inertia about the centre of mass alone. With a long arm that converges
/// only after about a hundred passes.
struct CoupledPoint {
    const PointConstraint* point = nullptr;
    Vec2* impulse = nullptr;
    bool biased = false;
    /// The point belongs to an articulated tree, which is solved after all limits and motors. So
    /// each of these applies the reaction of its point at once. Else the next one would see a body
    /// that spins about its centre of mass: with long arms it gained energy without bound.
    bool held = false;
};

/// Constraint along one axis: J = (-axis, -leverA, axis, leverB). A zero axis with levers of 1 is
/// an angular constraint. The axis of a rope over pulleys is another one at a.
struct AxisConstraint {
    Vec2 axis;
    Real leverA = 0;
    Real leverB = 0;
    Real error = 0; // m or rad
    Real speed = 0; // m/s or rad/s, target
    Softness softness{};
    Range bounds = kUnbounded;   // N s or N m s
    Real borne = 0;              // the same: up to which a limit stops without giving way
    CoupledPoint beside{};       // of an angular constraint only
    CoupledAngle angle{};        // of a linear constraint only
    std::optional<Vec2> axisA{}; // of a, if it is not `axis`
    Real couple = 0; // N m s on b about its anchor, per impulse, beside the force along the axis

    /// Relative velocity per impulse, with the rows that are solved beside.
    Real give(const BodyVelocity& a, const BodyVelocity& b, bool biased) const;
    void solve(BodyVelocity& a, BodyVelocity& b, Real& impulse, bool biased) const;
    /// The impulse that solve would add.
    Real missing(const BodyVelocity& a, const BodyVelocity& b, Real impulse, bool biased) const;
    void apply(BodyVelocity& a, BodyVelocity& b, Real impulse) const;
    /// Adds the impulse on b to the linear sum (N s) or, of an angular constraint, to the angular
    /// one (N m s).
    void addToSums(Real impulse, Vec2& linear, Real& angular) const;
};

} // namespace KODO_PRECISION
} // namespace kodo
