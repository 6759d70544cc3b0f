// SPDX-License-Identifier: MIT
// The servo and the governor of the ball.
#include <apart/core/governor.hpp>
#include <apart/core/tuning.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using namespace apart;
using kodo::Real;
using kodo::Vec2;
using support::near;

TEST(SpeedServo, ChangesNothingInsideItsBand) {
    for (const Real share : {Real(1), 1 + kServoBand / 2, 1 - kServoBand / 2}) {
        const Vec2 velocity{12 * share * Real(0.6), 12 * share * Real(0.8)};
        EXPECT_EQ(servoVelocity(velocity, normalize(velocity), 12), velocity);
    }
}

TEST(SpeedServo, ReachesTheBandFromAnySpeedAndKeepsTheHeading) {
    support::RandomNumbers random(7);
    for (int trial = 0; trial < 1000; ++trial) {
        SCOPED_TRACE("seed 7, trial " + std::to_string(trial));
        const Vec2 heading = random.rotation().xAxis();
        Vec2 velocity = random.between(0.2, 80) * heading;
        for (int tick = 0; tick < 60; ++tick) {
            velocity = servoVelocity(velocity, heading, 12);
        }
        EXPECT_TRUE(near(length(velocity), 12, 12 * kServoBand * Real(1.01)));
        // 60 scalings of two floats, each with an error of half an ulp.
        EXPECT_TRUE(near(cross(normalize(velocity), heading), 0, 60 * support::kEpsilon));
    }
}

// The error falls as a geometric series.
TEST(SpeedServo, RemovesTheSameShareOfTheErrorInEachTick) {
    for (const Real start : {Real(6), Real(18)}) {
        const Vec2 heading{Real(0.6), Real(-0.8)};
        Vec2 velocity = start * heading;
        for (int tick = 1; tick <= 10; ++tick) {
            velocity = servoVelocity(velocity, heading, 12);
            const Real error = (start - 12) * std::pow(1 - kServoShare, static_cast<Real>(tick));
            // Ten scalings of floats of up to 18.
            EXPECT_TRUE(near(length(velocity), 12 + error, 2e-5)) << "tick " << tick;
        }
    }
}

TEST(SpeedServo, AcceleratesAStoppedBallAlongItsLastHeading) {
    Vec2 velocity{};
    const Vec2 heading{Real(0.6), Real(-0.8)};
    velocity = servoVelocity(velocity, heading, 12);
    EXPECT_GT(dot(velocity, heading), 1);
    EXPECT_TRUE(near(cross(velocity, heading), 0, 1e-6));
}

TEST(SmallestTurn, DoesNotChangeSteepBalls) {
    const std::array<Vec2, 1> wall{Vec2{1, 0}};
    EXPECT_EQ(turnedFromFlat({8, 6}, wall), (Vec2{8, 6}));
    EXPECT_EQ(turnedFromFlat({0, -6}, wall), (Vec2{0, -6}));
}

TEST(SmallestTurn, BringsFlatBallsToTheEdgeOfTheConeAtTheSameSpeed) {
    support::RandomNumbers random(11);
    for (int trial = 0; trial < 1000; ++trial) {
        SCOPED_TRACE("seed 11, trial " + std::to_string(trial));
        const Real side = random.below(2) == 0 ? Real(1) : Real(-1);
        const Vec2 before{side * 10, random.between(-1.3, 1.3)};
        const std::array<Vec2, 1> wall{Vec2{side, 0}};
        const Vec2 after = turnedFromFlat(before, wall);
        EXPECT_TRUE(near(length(after), length(before), 1e-5));
        EXPECT_TRUE(near(std::abs(after.y), kFlatSine * length(before), 1e-5));
        EXPECT_GE(after.y * before.y, 0); // the vertical direction is kept
        EXPECT_GT(after.x * before.x, 0);
    }
}

TEST(SmallestTurn, NeverTurnsIntoASurface) {
    const std::array<Vec2, 1> floor{Vec2{0, 1}};
    EXPECT_GT(turnedFromFlat({10, 0}, floor).y, 0); // downwards would lead to the player sooner
    const std::array<Vec2, 2> gap{Vec2{0, 1}, Vec2{0, -1}};
    EXPECT_EQ(turnedFromFlat({10, 0}, gap), (Vec2{10, 0}));
}

TEST(Rubble, ThrowsOffABallThatWouldGetStuck) {
    const std::array<Vec2, 1> ground{Vec2{0, 1}};
    const Vec2 heading{Real(0.6), Real(-0.8)};
    EXPECT_TRUE(near(throwOff({6, 1}, heading, ground, 10), Vec2{6, 8}, 1e-5));
    EXPECT_EQ(throwOff({6, 7}, heading, ground, 10), (Vec2{6, 7})); // already fast enough
}

} // namespace
