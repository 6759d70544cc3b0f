// SPDX-License-Identifier: MIT
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>
#include <support/near.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

constexpr Real kMass = 8;

Input keys(int paddle) {
    Input input;
    input.paddle = static_cast<std::int8_t>(paddle);
    return input;
}

/// Ticks until the paddle rests at the target, or `most`.
int ticksTo(Real target, Real mass, int most) {
    Input input;
    input.target = static_cast<std::int16_t>(target * 1000);
    Real x = 0;
    Real speed = 0;
    for (int tick = 1; tick <= most; ++tick) {
        speed = drivenSpeed(input, x, speed, mass);
        x += speed * kTickSeconds;
        if (std::abs(x - target) < Real(0.001) && std::abs(speed) < Real(0.01)) {
            return tick;
        }
    }
    return most;
}

TEST(PaddleShape, IsConvexWithItsNominalWidth) {
    EXPECT_FALSE(kodo::check(kodo::Shape(paddleShape())));
    EXPECT_EQ(domeHeight(kPaddleHalfWidth), 0);
    EXPECT_GT(domeHeight(0), Real(0.3));
}

TEST(PaddleDrive, AcceleratesByForceOverMassUpToItsSpeed) {
    EXPECT_TRUE(
        near(drivenSpeed(keys(127), 0, 0, kMass), kPaddleForce / kMass * kTickSeconds, 1e-4));
    Real speed = 0;
    for (int tick = 0; tick < 100; ++tick) {
        speed = drivenSpeed(keys(127), 0, speed, kMass);
    }
    EXPECT_TRUE(near(speed, kKeySpeed, 1e-4));
    EXPECT_TRUE(near(drivenSpeed(keys(-127), 0, -kKeySpeed, kMass), -kKeySpeed, 1e-4));
}

TEST(PaddleDrive, ReachesAMouseTargetQuicklyAndStopsThere) {
    EXPECT_LE(ticksTo(1, kMass, 200), 14);  // 1 m within 0.12 s
    EXPECT_LE(ticksTo(10, kMass, 200), 50); // 10 m within 0.42 s
}

TEST(PaddleDrive, IsSlowerWhenThePaddleIsHeavier) {
    EXPECT_GT(ticksTo(10, 3 * kMass, 400), ticksTo(10, kMass, 400) + 15);
    Input far;
    far.target = 30000;
    Real speed = 0;
    for (int tick = 0; tick < 400; ++tick) {
        speed = drivenSpeed(far, 0, speed, 4 * kMass);
    }
    EXPECT_TRUE(near(speed, std::sqrt(2 * kPaddleEnergy / (4 * kMass)), 1e-3)); // m v^2 / 2 = E
}

} // namespace
