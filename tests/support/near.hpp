// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

/// Comparisons for the engine's tests, in long double. The same test runs in the float and the
/// double build.
namespace support {

/// Selects a tolerance by the precision under test.
constexpr kodo::Real byPrecision(double inFloat, double inDouble) {
    return static_cast<kodo::Real>(sizeof(kodo::Real) == 4 ? inFloat : inDouble);
}

/// Values that every definition must reject.
inline constexpr kodo::Real kInf = std::numeric_limits<kodo::Real>::infinity();
inline constexpr kodo::Real kNan = std::numeric_limits<kodo::Real>::quiet_NaN();

/// Distance from 1 to the next Real.
inline constexpr kodo::Real kEpsilon = std::numeric_limits<kodo::Real>::epsilon();

/// Usage: EXPECT_TRUE(near(actual, expected, tolerance)). False for NaN.
template <typename A, typename B, typename C>
testing::AssertionResult near(A actual, B expected, C tolerance) {
    const auto a = static_cast<long double>(actual);
    const auto b = static_cast<long double>(expected);
    const auto most = static_cast<long double>(tolerance);
    if (std::abs(a - b) <= most) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure()
           << a << " should be " << b << " but is off by " << a - b << ", more than " << most;
}

template <typename T, typename U, typename C>
testing::AssertionResult near(kodo::BasicVec2<T> actual, kodo::BasicVec2<U> expected, C tolerance) {
    const testing::AssertionResult x = near(actual.x, expected.x, tolerance);
    const testing::AssertionResult y = near(actual.y, expected.y, tolerance);
    return !x   ? testing::AssertionFailure() << "x: " << x.message()
           : !y ? testing::AssertionFailure() << "y: " << y.message()
                : testing::AssertionSuccess();
}

/// Comparison with a tolerance relative to the expected value.
template <typename A, typename B, typename C>
testing::AssertionResult nearShare(A actual, B expected, C share) {
    return near(actual, expected,
                static_cast<long double>(share) * std::abs(static_cast<long double>(expected)));
}

} // namespace support
