// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joints/joint.hpp>
#include <kodo/math/softness.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {

/// The building blocks of joints: constraints between two bodies, solved by impulses. All geometry
/// is of this very moment within the step, in world axes.

/// Of a point's K: a determinant this small beside the squares it is the difference of is a
/// rounding.
inline constexpr Real kSingularPins = 16 * std::numeric_limits<Real>::epsilon();

/// Holds two points together: speed = v_b + w_b x r_b - v_a - w_a x r_a is driven to zero, both
/// coordinates at once [Catto09].
struct PointConstraint {
    Vec2 armA;
    Vec2 armB;
    Vec2 error; // m, point b minus point a
    Softness softness;
    Real maxImpulse = std::numeric_limits<Real>::infinity(); // N s

    /// Adds to the impulse so far, and pushes.
    void solve(Motion& a, Motion& b, Vec2& impulse, bool biased) const;
    /// What solve would add.
    Vec2 missing(const Motion& a, const Motion& b, Vec2 impulse, bool biased) const;
    /// The impulse that stops this speed at the points: K^-1 speed, or none if nothing can be
    /// pushed.
    Vec2 stopping(const Motion& a, const Motion& b, Vec2 speed) const;
    void push(Motion& a, Motion& b, Vec2 impulse) const;
    void sumUp(Vec2 impulse, Vec2& pushes, Real& turns) const;
};

inline constexpr Range kUnbounded{-std::numeric_limits<Real>::infinity(),
                                  std::numeric_limits<Real>::infinity()};

/// A point that is held together right after an angle is solved. The angle reckons with that: with
/// u the change of its speed for an impulse at the point, and P what the point would do by now,
///
///   impulse = -(speed + u P) / (1/I_a + 1/I_b - u K^-1 u)
///
/// so that both are right after one pass, as a block of three rows solved at once would be. Without
/// it an angle knows the small inertia of a body about its centre alone, and takes a hundred passes
/// to learn that a hinge holds it by a long arm.
struct HeldBeside {
    const PointConstraint* point = nullptr;
    Vec2 impulse;
    bool biased = false;
};

/// Acts along one axis: J = (-axis, -leverA, axis, leverB). A zero axis and levers of 1 make it
/// an angle.
struct AxisConstraint {
    Vec2 axis;
    Real leverA = 0;
    Real leverB = 0;
    Real error = 0; // m or rad
    Real speed = 0; // m/s or rad/s that is wanted
    Softness softness;
    Range bounds = kUnbounded; // N s or N m s
    HeldBeside beside{};       // of an angle only

    void solve(Motion& a, Motion& b, Real& impulse, bool biased) const;
    void push(Motion& a, Motion& b, Real impulse) const;
    void sumUp(Real impulse, Vec2& pushes, Real& turns) const;
};

} // namespace kodo::inline KODO_PRECISION
