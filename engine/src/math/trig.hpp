// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

namespace kodo {
inline namespace KODO_PRECISION {

/// Sine and cosine of one angle, or of several in lanes.
template <typename V>
struct SinCosOf {
    V sin;
    V cos;
};

// The next four functions take a T, or lanes of T (V). They are always inlined: see math/lanes.hpp.

/// The nearest integer, ties to even. Range: |value| < 2^(digits of T) / 4.
template <std::floating_point T, typename V>
[[gnu::always_inline]] inline V nearest(V value) {
    constexpr T kOnesLast = T(1.5) / std::numeric_limits<T>::epsilon();
    return (value + kOnesLast) - kOnesLast;
}

/// The angle minus that many quarter turns. pi/2 is split into two parts; the first has so few bits
/// that its product with an integer up to 2^16 is exact.
template <std::floating_point T, typename V>
[[gnu::always_inline]] inline V afterQuarters(V angle, V quarters) {
    constexpr T kQuarterHigh = sizeof(T) == 4 ? T(1.5703125) : T(1.57079632673412561417e+00);
    constexpr T kQuarterLow =
        sizeof(T) == 4 ? T(4.83826794896619e-4) : T(6.07710050650619224932e-11);
    return (angle - quarters * kQuarterHigh) - quarters * kQuarterLow;
}

/// Taylor series for |r| <= pi/4. The remainder is below rounding after x^10 (float) or x^16
/// (double).
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

/// For every angle: reduced by whole quarter turns to |r| <= pi/4.
template <std::floating_point T, typename V>
[[gnu::always_inline]] inline SinCosOf<V> sinCosFar(V angle) {
    const V most = V{} + T(4e6); // beyond, the number of quarters would not be exact
    angle = angle > most ? most : angle;
    angle = angle < -most ? -most : angle; // NaN stays NaN
    const V quarters = nearest<T>(angle * (2 / std::numbers::pi_v<T>));
    const SinCosOf<V> near = sinCosNear<T>(afterQuarters<T>(angle, quarters));
    const V cycles = quarters * T(0.25);
    const V part = cycles - nearest<T>(cycles); // fraction of a cycle, -0.5..0.5
    const V size = part < V{} ? -part : part;
    const V quarter = V{} + T(0.25);
    const V half = V{} + T(0.5);
    const V sin = size == quarter ? near.cos : near.sin;
    const V cos = size == quarter ? near.sin : near.cos;
    const V sinOfHalf = size == half ? -sin : sin;
    const V cosOfHalf = size == half ? -cos : cos;
    return {part < V{} ? -sin : sinOfHalf, part == quarter ? -cos : cosOfHalf};
}

/// Sine and cosine from +, - and * alone, since the C library rounds differently between systems.
/// Angle in radians. For |angle| < 100 the error is at most 2 units in the last place of 1. Each
/// doubling of the angle up to 1e5 loses one more bit. Beyond 1e5 the result is only a unit vector,
/// and beyond 4e6 that of 4e6.
template <std::floating_point T>
SinCos<T> sinCos(T angle) {
    if (!((angle < 0 ? -angle : angle) <= std::numbers::pi_v<T> / 4)) {
        const SinCosOf<T> far = sinCosFar<T>(angle);
        return {far.sin, far.cos};
    }
    if (const T q = angle * angle; q < (sizeof(T) == 4 ? T(1e-7) : T(1e-16))) {
        return {angle, 1 - q / 2}; // further terms are below rounding
    }
    const SinCosOf<T> near = sinCosNear<T>(angle);
    return {near.sin, near.cos};
}

/// Arc tangent for 0 <= x <= 1. Three halvings of the angle leave x < 0.1, where the series up to
/// x^17 is exact to the rounding of a double.
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

} // namespace KODO_PRECISION
} // namespace kodo
