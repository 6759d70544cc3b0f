// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joint.hpp>

#include "joints/anchor.hpp"
#include "math/softness.hpp"

#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

/// The building blocks of joints: constraints between two bodies, solved by impulses. All geometry
/// is current within the step, in world axes.

/// Relative to the product of the diagonal of K: a smaller determinant is rounding error.
inline constexpr Real kSingularPoint = 16 * std::numeric_limits<Real>::epsilon();

/// Least fraction of 1 / inertia that remains after the subtraction of the point, see CoupledPoint:
/// below it the difference is rounding error.
inline constexpr Real kLeastShare = sizeof(Real) == 4 ? Real(1e-4) : Real(1e-9);

/// Point constraint: drives the relative velocity v_b + w_b x r_b - v_a - w_a x r_a of two anchors
/// to zero, both coordinates at once [Catto09].
struct PointConstraint {
    Vec2 armA;
    Vec2 armB;
    Vec2 error; // m, point b minus point a
    Softness softness;
    Vec2 arc{}; // m/s, by which the tangents of both anchors leave their arcs in the substep
    Real maxImpulse = std::numeric_limits<Real>::infinity(); // N s

    /// Applies an impulse to the bodies and adds it to the accumulated one.
    void solve(BodyVelocity& a, BodyVelocity& b, Vec2& impulse, bool biased) const;
    /// The impulse that solve would add.
    Vec2 missing(const BodyVelocity& a, const BodyVelocity& b, Vec2 impulse, bool biased) const;
    /// The impulse that removes a relative velocity of the anchors: K^-1 speed. 0 if both bodies
    /// are immovable.
    Vec2 stopping(const BodyVelocity& a, const BodyVelocity& b, Vec2 speed) const;
    /// Applies an impulse to the bodies.
    void push(BodyVelocity& a, BodyVelocity& b, Vec2 impulse) const;
    /// Adds the impulse to the linear sum (N s, on b); `turns` is the angular one (N m s).
    void addToSums(Vec2 impulse, Vec2& pushes, Real& turns) const;
};

inline constexpr Range kUnbounded{-std::numeric_limits<Real>::infinity(),
                                  std::numeric_limits<Real>::infinity()};

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
    Vec2 impulse;
    bool biased = false;
};

/// Constraint along one axis: J = (-axis, -leverA, axis, leverB). A zero axis with levers of 1 is
/// an angular constraint.
struct AxisConstraint {
    Vec2 axis;
    Real leverA = 0;
    Real leverB = 0;
    Real error = 0; // m or rad
    Real speed = 0; // m/s or rad/s, target
    Softness softness;
    Range bounds = kUnbounded; // N s or N m s
    CoupledPoint beside{};     // of an angular constraint only

    void solve(BodyVelocity& a, BodyVelocity& b, Real& impulse, bool biased) const;
    void push(BodyVelocity& a, BodyVelocity& b, Real impulse) const;
    void addToSums(Real impulse, Vec2& pushes, Real& turns) const;
};

} // namespace KODO_PRECISION
} // namespace kodo
