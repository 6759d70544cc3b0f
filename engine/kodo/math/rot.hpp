// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/trig.hpp>
#include <kodo/math/vec2.hpp>

namespace kodo::inline KODO_PRECISION {

/// An orientation, held as the unit vector (cos, sin) of its angle [Thesis06, 2.3.1]: turning a
/// vector costs four multiplications and never a sine.
template <std::floating_point T>
struct BasicRot {
    T c = 1;
    T s = 0;

    /// Counter-clockwise from +x, in radians.
    static BasicRot fromAngle(T radians) {
        const SinCos<T> both = sinCos(radians);
        return {both.cos, both.sin};
    }
    /// -pi..pi.
    T angle() const { return atan2(s, c); }

    constexpr BasicVec2<T> xAxis() const { return {c, s}; }
    constexpr BasicVec2<T> yAxis() const { return {-s, c}; }
    constexpr BasicRot inverse() const { return {c, -s}; }

    /// Out of this orientation: local to world [Thesis06, eq. 2.3].
    friend constexpr BasicVec2<T> operator*(BasicRot q, BasicVec2<T> v) {
        return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
    }
    /// First b, then a.
    friend constexpr BasicRot operator*(BasicRot a, BasicRot b) {
        return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
    }
    friend constexpr bool operator==(BasicRot, BasicRot) = default;
};

using Rot = BasicRot<Real>;

/// Into the orientation q: world to local.
template <std::floating_point T>
constexpr BasicVec2<T> unrotate(BasicRot<T> q, BasicVec2<T> v) {
    return {q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x};
}

/// Back to unit length.
template <std::floating_point T>
BasicRot<T> normalize(BasicRot<T> q) {
    const T scale = 1 / std::sqrt(q.c * q.c + q.s * q.s);
    return {scale * q.c, scale * q.s};
}

/// q after turning by a small or large angle (rad), back on the circle. By none it stays as it is.
/// All are off the circle by roundings, which a step of Newton's method mends.
template <std::floating_point T>
BasicRot<T> turned(BasicRot<T> q, T radians) {
    if (radians == 0) {
        return q;
    }
    const BasicRot<T> next = BasicRot<T>::fromAngle(radians) * q;
    const T missing = (1 - (next.c * next.c + next.s * next.s)) / 2;
    return {next.c + missing * next.c, next.s + missing * next.s};
}

} // namespace kodo::inline KODO_PRECISION
