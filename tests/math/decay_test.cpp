// SPDX-License-Identifier: MIT
#include "math/decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace kodo {
namespace {

template <typename T>
void expectExponential(T most) {
    for (T x = 0; x < most; x += T(0.00390625) + x / 512) {
        const long double exact = std::exp(-static_cast<long double>(x));
        const auto found = static_cast<long double>(decay(x));
        EXPECT_NEAR(static_cast<double>(found / exact), 1,
                    4 * static_cast<double>(std::numeric_limits<T>::epsilon()))
            << x;
    }
}

// Against the exponential of long double.
TEST(Decay, IsTheExponentialOfMinusX) {
    expectExponential(86.9f);
    expectExponential(86.9);
}

TEST(Decay, OfZeroIsOneAndOfMuchIsZero) {
    EXPECT_EQ(decay(0.0f), 1);
    EXPECT_EQ(decay(0.0), 1);
    EXPECT_EQ(decay(87.0f), 0);
    EXPECT_EQ(decay(1e6), 0);
}

} // namespace
} // namespace kodo
