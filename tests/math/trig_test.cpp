// SPDX-License-Identifier: MIT
#include <support/near.hpp>
#include <support/random_numbers.hpp>

#include "math/trig.hpp"

#include <cmath>
#include <limits>

namespace kodo {
namespace {

using support::kEpsilon;
using support::near;

// B3, B4: the oracle is the C library in long double, whose own error is far below.
void expectSinCos(Real angle, Real tolerance) {
    const SinCos<Real> both = sinCos(angle);
    ASSERT_TRUE(near(both.sin, std::sin(static_cast<long double>(angle)), tolerance)) << angle;
    ASSERT_TRUE(near(both.cos, std::cos(static_cast<long double>(angle)), tolerance)) << angle;
}

// The documented accuracy: 2 units in the last place of 1.
TEST(SinCos, AgreesWithTheCLibraryUpToAHundredRadians) {
    for (int i = -200000; i <= 200000; ++i) {
        expectSinCos(static_cast<Real>(i) * Real(0.0005), 2 * kEpsilon);
    }
}

// The documented accuracy beyond 100 rad: one bit less for each doubling.
TEST(SinCos, LosesAtMostOneBitPerDoublingBeyondAHundredRadians) {
    support::RandomNumbers random(2);
    Real tolerance = 2 * kEpsilon;
    for (double reach = 100; reach < 50000; reach *= 2) {
        tolerance *= 2;
        for (int i = 0; i < 2000; ++i) {
            expectSinCos(random.between(-2 * reach, 2 * reach), tolerance);
        }
    }
}

TEST(SinCos, IsExactAtZeroAndForTinyAngles) {
    EXPECT_EQ(sinCos(Real(0)).sin, 0);
    EXPECT_EQ(sinCos(Real(0)).cos, 1);
    const Real tiny = Real(1e-20);
    EXPECT_EQ(sinCos(tiny).sin, tiny);
    EXPECT_EQ(sinCos(tiny).cos, 1);
}

// D2: no rotation comes of an angle that is not a number. World refuses what fromAngle() gives.
TEST(SinCos, OfAnAngleThatIsNotFiniteIsNotANumber) {
    constexpr Real kInfinite = std::numeric_limits<Real>::infinity();
    for (const Real angle : {kInfinite, -kInfinite, std::numeric_limits<Real>::quiet_NaN()}) {
        const Rot rotation = Rot::fromAngle(angle);
        EXPECT_TRUE(std::isnan(rotation.c)) << angle;
        EXPECT_TRUE(std::isnan(rotation.s)) << angle;
    }
    const Rot largest = Rot::fromAngle(std::numeric_limits<Real>::max());
    EXPECT_TRUE(near(length(largest.xAxis()), 1, 4 * kEpsilon));
}

TEST(SinCos, SineIsOddAndCosineIsEven) {
    support::RandomNumbers random(3);
    for (int i = 0; i < 10000; ++i) {
        const Real angle = random.between(0, 10);
        const SinCos<Real> plus = sinCos(angle);
        const SinCos<Real> minus = sinCos(-angle);
        EXPECT_EQ(plus.sin, -minus.sin);
        EXPECT_EQ(plus.cos, minus.cos);
    }
}

// Three halvings, a series of nine terms and a factor of 8: a few roundings of the result.
TEST(Atan2, AgreesWithTheCLibraryInAllDirections) {
    for (int i = -180000; i <= 180000; ++i) {
        const long double angle = static_cast<long double>(i) * 3.14159265358979L / 180000;
        const Real x = static_cast<Real>(3 * std::cos(angle));
        const Real y = static_cast<Real>(3 * std::sin(angle));
        const long double expected =
            std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        ASSERT_TRUE(near(kodo::atan2(y, x), expected, 4 * kEpsilon)) << x << ", " << y;
    }
}

TEST(Atan2, AcceptsVectorsOfAnyLength) {
    for (const double size : {1e-30, 1e-10, 1.0, 1e10, 1e30}) {
        const Real s = static_cast<Real>(size);
        EXPECT_TRUE(near(kodo::atan2(s, s), std::numbers::pi_v<long double> / 4, 2 * kEpsilon));
        EXPECT_TRUE(
            near(kodo::atan2(-s, -s), -3 * std::numbers::pi_v<long double> / 4, 4 * kEpsilon));
    }
}

TEST(Atan2, IsExactOnTheAxes) {
    const Real pi = std::numbers::pi_v<Real>;
    EXPECT_EQ(kodo::atan2(Real(0), Real(1)), 0);
    EXPECT_EQ(kodo::atan2(Real(1), Real(0)), pi / 2);
    EXPECT_EQ(kodo::atan2(Real(-1), Real(0)), -pi / 2);
    EXPECT_EQ(kodo::atan2(Real(0), Real(-1)), pi);
    EXPECT_EQ(kodo::atan2(Real(0), Real(0)), 0);
}

} // namespace
} // namespace kodo
