// SPDX-License-Identifier: MIT
// Reports of breakout games, played by a ball of restitution 1 and a kinematic bat.
#include <gtest/gtest.h>

#include <cmath>

#include "field_scene.hpp"

namespace field {
namespace {

BodyId addBat(World& world, Vec2 position, Vec2 velocity) {
    return world.add({.shape = kodo::Box{2, Real(0.4)},
                      .position = position,
                      .velocity = velocity,
                      .material = kElastic,
                      .type = BodyType::Kinematic});
}

bool isInside(const World& world, BodyId bat, BodyId ball, Real depth) {
    const Vec2 d = world[ball].position() - world[bat].position();
    const Vec2 out{std::max(std::abs(d.x) - 1, Real(0)),
                   std::max(std::abs(d.y) - Real(0.2), Real(0))};
    return length(out) < Real(0.15) - depth;
}

// The bat moves sideways into the ball: the ball disappears inside the bat and is flung out later.
// https://github.com/city41/breakouts/issues/36
TEST(FieldBreakout, ABatThatHitsTheBallWithItsSideNeverTakesItIn) {
    for (int i = 0; i < 40; ++i) {
        World world;
        const BodyId bat = addBat(world, {-6, 0}, {Real(4) + static_cast<Real>(i), 0});
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.15)},
                                       .position = {0, Real(0.3) - static_cast<Real>(i) / 80},
                                       .velocity = {-1, -2},
                                       .material = kElastic});
        for (int k = 0; k < 60; ++k) {
            world.step(kDt);
            ASSERT_FALSE(isInside(world, bat, ball, Real(0.06))) << "bat " << i << ", step " << k;
        }
        // Relative to the bat the speed stays: it leaves with at most 2 u + |v|.
        EXPECT_LE(length(world[ball].velocity()), 2 * (4 + i) + 2.3);
    }
}

// The ball disappears into the bat; it comes out when the bat is moved.
// https://github.com/SerenityOS/serenity/issues/4015
TEST(FieldBreakout, ABallThatFallsOnAMovingBatLeavesUpwardsInEveryPhase) {
    for (int i = 0; i < 60; ++i) {
        World world;
        const Real phase = static_cast<Real>(i) / 60;
        const BodyId bat = addBat(world, {Real(-2) + phase, 0}, {6, 0});
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.15)},
                                       .position = {0, 4 + phase},
                                       .velocity = {0, -20},
                                       .material = kElastic});
        for (int k = 0; k < 30; ++k) {
            world.step(kDt);
            ASSERT_FALSE(isInside(world, bat, ball, Real(0.01))) << "phase " << i;
        }
        EXPECT_NEAR(std::abs(world[ball].velocity().y), 20, 0.01) << "phase " << i;
    }
}

// The ball is hit by the bat and by the table in the same moment, and the game hangs.
// https://github.com/ForFunLabs/ElevenPublicBugsAndAsks/issues/255
TEST(FieldBreakout, ABallBetweenBatAndTableIsRecordedWithBothAndComesOut) {
    World world;
    const BodyId table = world.add({.shape = kodo::Box{10, 1},
                                    .position = {0, Real(-0.5)},
                                    .material = kElastic,
                                    .type = BodyType::Static});
    const BodyId ball = world.add({.shape = kodo::Circle{Real(0.15)},
                                   .position = {0, Real(0.16)},
                                   .velocity = {0, Real(-0.3)},
                                   .material = kElastic});
    const BodyId bat = addBat(world, {0, Real(0.9)}, {Real(0.5), -1});
    world[bat].setRotation(kodo::Rot::fromAngle(Real(0.05)));
    bool byBat = false;
    bool byTable = false;
    for (int i = 0; i < 60; ++i) {
        world.step(kDt);
        if (world[bat].position().y < Real(0.52)) { // 2 cm less than the ball needs
            world[bat].setVelocity({0, 0});
        }
        for (const auto& record : world.collisions(ball)) {
            byBat = byBat || (record.involves(bat) && record.totalImpulse > 0);
            byTable = byTable || (record.involves(table) && record.totalImpulse > 0);
        }
        ASSERT_TRUE(std::isfinite(world[ball].position().x));
        ASSERT_GT(world[ball].position().y, Real(0.05)) << "step " << i; // above the table
    }
    EXPECT_TRUE(byBat);
    EXPECT_TRUE(byTable);
    EXPECT_LT(length(world[ball].velocity()), 30); // a squeeze gives a few times the bat's speed
}

// A ball that is hit into the corner glides along the wall instead of returning.
// https://github.com/InfiniTimeOrg/InfiniTime/issues/1084
TEST(FieldBreakout, ABallFromTheCornerReturnsOnItsWay) {
    for (int i = 0; i < 60; ++i) {
        World world;
        for (const bool upright : {false, true}) {
            world.add({.shape = upright ? kodo::Box{1, 20} : kodo::Box{20, 1},
                       .position = upright ? Vec2{Real(5.5), 0} : Vec2{0, Real(5.5)},
                       .material = kElastic,
                       .type = BodyType::Static});
        }
        const Real shift = static_cast<Real>(i) / 600; // of the meeting point, to 10 cm
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.15)},
                                       .position = {shift, 0},
                                       .velocity = {9, 9},
                                       .material = kElastic});
        run(world, 1);
        EXPECT_NEAR(world[ball].velocity().x, -9, 1e-3) << "shift " << shift;
        EXPECT_NEAR(world[ball].velocity().y, -9, 1e-3) << "shift " << shift;
    }
}

// The ball is caught between two bricks and goes to and fro in one place.
// https://github.com/cookerlyk/Chip8/issues/8
TEST(FieldBreakout, ABallInAGapAsWideAsItselfComesOutAgain) {
    for (const Real gap : {Real(0.3), Real(0.301), Real(0.31), Real(0.35)}) {
        World world;
        for (const Real side : {Real(-1), Real(1)}) {
            world.add({.shape = kodo::Box{1, Real(0.4)},
                       .position = {side * (Real(0.5) + gap / 2), 3},
                       .material = kElastic,
                       .type = BodyType::Static});
        }
        world.add({.shape = kodo::Box{4, 1},
                   .position = {0, 4},
                   .material = kElastic,
                   .type = BodyType::Static});
        const BodyId ball = world.add(
            {.shape = kodo::Circle{Real(0.15)}, .velocity = {Real(0.02), 9}, .material = kElastic});
        run(world, 3);
        EXPECT_NEAR(length(world[ball].velocity()), 9, 0.02) << "gap " << gap;
        EXPECT_LT(world[ball].position().y, 2) << "gap " << gap;
    }
}

} // namespace
} // namespace field
