// SPDX-License-Identifier: MIT
#pragma once

#include "math/trig.hpp"

#include <concepts>

namespace kodo {
inline namespace KODO_PRECISION {

/// exp(-x) for x >= 0, from +, -, * and / alone, as sinCos(). The error is at most 4 units in the
/// last place. From 87 on it is 0: exp(-87) is the last that a float holds with all its digits.
///
///   exp(-x) = 2^-n exp(-r),  n = nearest(x / ln 2),  |r| <= ln(2) / 2
template <std::floating_point T>
T decay(T x) {
    if (!(x < 87)) {
        return 0;
    }
    // ln 2 in two parts; the first has so few bits that its product with n is exact.
    constexpr T kHigh = sizeof(T) == 4 ? T(0.693359375) : T(6.93147180369123816490e-01);
    constexpr T kLow = sizeof(T) == 4 ? T(-2.12194440e-4) : T(1.90821492927058770002e-10);
    constexpr int kTerms = sizeof(T) == 4 ? 8 : 14; // the remainder is below rounding
    const T n = nearest<T>(x / std::numbers::ln2_v<T>);
    const T r = (x - n * kHigh) - n * kLow;
    T sum = 1;
    for (int k = kTerms; k >= 1; --k) {
        sum = 1 - r * sum / T(k);
    }
    for (T halvings = n; halvings > 0; halvings -= 1) {
        sum *= T(0.5);
    }
    return sum;
}

} // namespace KODO_PRECISION
} // namespace kodo
