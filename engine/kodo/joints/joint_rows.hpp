// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joints/joint.hpp>
#include <kodo/math/softness.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {

/// The building blocks of joints: constraints between two bodies, solved by impulses. All geometry
/// is of this very moment within the step, in world axes.

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
    void push(Motion& a, Motion& b, Vec2 impulse) const;
    void sumUp(Vec2 impulse, Vec2& pushes, Real& turns) const;
};

inline constexpr Range kUnbounded{-std::numeric_limits<Real>::infinity(),
                                  std::numeric_limits<Real>::infinity()};

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

    void solve(Motion& a, Motion& b, Real& impulse, bool biased) const;
    void push(Motion& a, Motion& b, Real impulse) const;
    void sumUp(Real impulse, Vec2& pushes, Real& turns) const;
};

} // namespace kodo::inline KODO_PRECISION
