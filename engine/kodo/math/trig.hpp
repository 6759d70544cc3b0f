// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/real.hpp>

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

namespace kodo::inline KODO_PRECISION {

/// The sine and the cosine of one angle.
template <std::floating_point T>
struct SinCos {
    T sin;
    T cos;
};

/// Sines and cosines of several angles side by side, or of one.
template <typename V>
struct SinCosOf {
    V sin;
    V cos;
};

// The next four are for a T, or for several side by side (V), and therefore always in line: see
// math/lanes.hpp.

/// The nearest whole number; of two the even one. For |value| below a quarter of 2 to the digits of
/// a T.
template <std::floating_point T, typename V>
[[gnu::always_inline]] inline V nearest(V value) {
    constexpr T kOnesLast = T(1.5) / std::numeric_limits<T>::epsilon();
    return (value + kOnesLast) - kOnesLast;
}

/// What is left of an angle without so many whole quarter turns. pi/2 comes in two parts; the first
/// has so few bits that multiplying it by up to 2^16 is exact.
template <std::floating_point T, typename V>
[[gnu::always_inline]] inline V afterQuarters(V angle, V quarters) {
    constexpr T kQuarterHigh = sizeof(T) == 4 ? T(1.5703125) : T(1.57079632673412561417e+00);
    constexpr T kQuarterLow =
        sizeof(T) == 4 ? T(4.83826794896619e-4) : T(6.07710050650619224932e-11);
    return (angle - quarters * kQuarterHigh) - quarters * kQuarterLow;
}

/// For |r| <= pi/4: the Taylor series, which ends below the rounding of a float after x^10, of a
/// double after x^16.
template <std::floating_point T, typename V>
[[gnu::always_inline]] inline SinCosOf<V> sinCosNear(V r) {
    const V q = r * r;
    const auto with = [&](auto tailS, auto tailC) -> SinCosOf<V> { // from r^9 and q^5 on
        return {r + r * q * (T(-1) / 6 + q * (T(1) / 120 + q * (T(-1) / 5040 + q * tailS))),
                1 + q * (T(-1) / 2 +
                         q * (T(1) / 24 + q * (T(-1) / 720 + q * (T(1) / 40320 + q * tailC))))};
    };
    constexpr T kS = T(1) / 362880;
    constexpr T kC = T(-1) / 3628800;
    if constexpr (sizeof(T) == 4) {
        return with(kS, kC);
    } else {
        return with(
            kS + q * (T(-1) / 39916800 + q * (T(1) / 6227020800 + q * (T(-1) / 1307674368000))),
            kC + q * (T(1) / 479001600 + q * (T(-1) / 87178291200 + q * (T(1) / 20922789888000))));
    }
}

/// For every angle: by whole quarter turns to |r| <= pi/4.
template <std::floating_point T, typename V>
[[gnu::always_inline]] inline SinCosOf<V> sinCosFar(V angle) {
    const V most = V{} + T(4e6); // beyond, they would not be whole
    angle = angle > most ? most : angle;
    angle = angle < -most ? -most : angle; // what is no number stays none
    const V quarters = nearest<T>(angle * (2 / std::numbers::pi_v<T>));
    const SinCosOf<V> near = sinCosNear<T>(afterQuarters<T>(angle, quarters));
    const V cycles = quarters * T(0.25);
    const V part = cycles - nearest<T>(cycles); // of a cycle, -0.5..0.5
    const V size = part < V{} ? -part : part;
    const V quarter = V{} + T(0.25);
    const V half = V{} + T(0.5);
    const V sin = size == quarter ? near.cos : near.sin;
    const V cos = size == quarter ? near.sin : near.cos;
    const V sinOfHalf = size == half ? -sin : sin;
    const V cosOfHalf = size == half ? -cos : cos;
    return {part < V{} ? -sin : sinOfHalf, part == quarter ? -cos : cosOfHalf};
}

/// Sine and cosine from + - * alone, since the functions of the C library round differently from
/// one system to the next. Angle in radians; within 2 units in the last place of 1 for |angle| <
/// 100, losing one bit of it for each doubling beyond, up to 1e5. From there on the two are a unit
/// vector and little more, and beyond 4e6 that of 4e6.
template <std::floating_point T>
SinCos<T> sinCos(T angle) {
    if (!((angle < 0 ? -angle : angle) <= std::numbers::pi_v<T> / 4)) {
        const SinCosOf<T> far = sinCosFar<T>(angle);
        return {far.sin, far.cos};
    }
    if (const T q = angle * angle; q < (sizeof(T) == 4 ? T(1e-7) : T(1e-16))) {
        return {angle, 1 - q / 2}; // the rest is below their rounding
    }
    const SinCosOf<T> near = sinCosNear<T>(angle);
    return {near.sin, near.cos};
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
