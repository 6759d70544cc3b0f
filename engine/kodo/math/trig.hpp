// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <cmath>
#include <concepts>
#include <numbers>

namespace kodo::inline KODO_PRECISION {

/// The sine and the cosine of one angle.
template <std::floating_point T>
struct SinCos {
    T sin;
    T cos;
};

/// Sine and cosine from + - * and floor alone, since the functions of the C library round
/// differently from one system to the next. Angle in radians; within 2 units in the last place of 1
/// for |angle| < 100, losing one bit of it for each doubling beyond.
///
/// The angle is brought to |r| <= pi/4 by quarter turns; there the Taylor series ends below the
/// rounding of a float after x^10, of a double after x^16.
template <std::floating_point T>
SinCos<T> sinCos(T angle) {
    // pi/2 in two parts; the first has so few bits that multiplying it by k is exact.
    constexpr T kQuarterHigh = sizeof(T) == 4 ? T(1.5703125) : T(1.57079632673412561417e+00);
    constexpr T kQuarterLow =
        sizeof(T) == 4 ? T(4.83826794896619e-4) : T(6.07710050650619224932e-11);
    const T quarters = angle * (2 / std::numbers::pi_v<T>)+T(0.5);
    const bool small = quarters >= 0 && quarters < 1; // as most angles are; floor may be a call
    const T turns = small ? T(0) : std::floor(quarters);
    const T r = (angle - turns * kQuarterHigh) - turns * kQuarterLow;
    const T q = r * r;
    if (small && q < (sizeof(T) == 4 ? T(1e-7) : T(1e-16))) {
        return {r, 1 - q / 2}; // the rest is below their rounding
    }
    T tailS = T(1) / 362880; // the series from r^9 and q^5 on, divided by what stands before it
    T tailC = T(-1) / 3628800;
    if constexpr (sizeof(T) > 4) {
        tailS += q * (T(-1) / 39916800 + q * (T(1) / 6227020800 + q * (T(-1) / 1307674368000)));
        tailC += q * (T(1) / 479001600 + q * (T(-1) / 87178291200 + q * (T(1) / 20922789888000)));
    }
    const T s = r + r * q * (T(-1) / 6 + q * (T(1) / 120 + q * (T(-1) / 5040 + q * tailS)));
    const T c =
        1 + q * (T(-1) / 2 + q * (T(1) / 24 + q * (T(-1) / 720 + q * (T(1) / 40320 + q * tailC))));
    const T quadrant = small ? T(0) : turns - 4 * std::floor(turns / 4);
    if (quadrant == 0) {
        return {s, c};
    }
    if (quadrant == 1) {
        return {c, -s};
    }
    if (quadrant == 2) {
        return {-s, -c};
    }
    return {-c, s};
}

/// Arc tangent of 0 <= x <= 1. Halving the angle three times leaves x < 0.1, where the series ends
/// below the rounding of a double after x^17.
///
///   atan(x) = 2 atan(x / (1 + sqrt(1 + x^2)))
template <std::floating_point T>
T atanOfUnit(T x) {
    for (int halving = 0; halving < 3; ++halving) {
        x = x / (1 + std::sqrt(1 + x * x));
    }
    const T q = x * x;
    T sum = 0;
    for (int n = 17; n >= 1; n -= 2) {
        sum = 1 / T(n) - q * sum;
    }
    return 8 * x * sum;
}

/// Angle of the vector (x, y) in -pi..pi, counter-clockwise from +x; 0 for the zero vector.
template <std::floating_point T>
T atan2(T y, T x) {
    const T ax = x < 0 ? -x : x;
    const T ay = y < 0 ? -y : y;
    if (ax == 0 && ay == 0) {
        return 0;
    }
    T angle = ay <= ax ? atanOfUnit(ay / ax) : std::numbers::pi_v<T> / 2 - atanOfUnit(ax / ay);
    if (x < 0) {
        angle = std::numbers::pi_v<T> - angle;
    }
    return y < 0 ? -angle : angle;
}

} // namespace kodo::inline KODO_PRECISION
