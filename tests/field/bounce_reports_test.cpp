// SPDX-License-Identifier: MIT
// Reports on restitution.
#include <gtest/gtest.h>

#include <cmath>

#include "field_scene.hpp"

namespace field {
namespace {

/// Four static walls around a room of 8 by 8 m.
void addWalls(World& world) {
    for (const Real side : {Real(-1), Real(1)}) {
        for (const bool upright : {false, true}) {
            world.add({.shape = upright ? kodo::Box{1, 10} : kodo::Box{10, 1},
                       .position = upright ? Vec2{side * Real(4.5), 0} : Vec2{0, side * Real(4.5)},
                       .material = kElastic,
                       .type = BodyType::Static});
        }
    }
}

// A slow ball that flies diagonally in a room with full restitution stops bouncing and glides along
// a wall. https://github.com/piqnt/planck.js/issues/217
TEST(FieldBounce, ASlowDiagonalBallKeepsItsSpeedInARoom) {
    World world;
    addWalls(world);
    const BodyId ball = world.add({.shape = kodo::Circle{Real(0.2)},
                                   .velocity = {Real(0.5), Real(0.3)},
                                   .material = kElastic});
    int turns = 0;
    Vec2 before = world[ball].velocity();
    for (int i = 0; i < 60 * 60; ++i) {
        world.step(kDt);
        const Vec2 now = world[ball].velocity();
        ASSERT_NEAR(std::abs(now.x), 0.5, 1e-4);
        ASSERT_NEAR(std::abs(now.y), 0.3, 1e-4);
        turns += now.x * before.x < 0 || now.y * before.y < 0 ? 1 : 0;
        before = now;
    }
    EXPECT_GE(turns, 5); // 30 m along x and 18 m along y, in a room of 7.6 m
}

// In a row of balls of rising restitution the last jumps higher each time, and none ever sleeps.
// https://github.com/erincatto/box2d/issues/76
TEST(FieldBounce, ARowOfRestitutionsNeverJumpsHigherAndAllButTheElasticOneSleep) {
    World world = underGravity();
    addGround(world, kElastic);
    const Real restitutions[] = {0, Real(0.1), Real(0.3), Real(0.5), Real(0.75), Real(0.9), 1};
    std::vector<BodyId> balls;
    for (const Real e : restitutions) {
        balls.push_back(world.add({.shape = kodo::Circle{Real(0.5)},
                                   .position = {static_cast<Real>(balls.size()) * 2 - 6, 5},
                                   .material = kodo::withFriction(Real(0.6), e)}));
    }
    for (int i = 0; i < 60 * 40; ++i) {
        world.step(kDt);
        for (const BodyId id : balls) {
            ASSERT_LE(world[id].position().y, 5 * 1.001) << "step " << i;
        }
    }
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
        EXPECT_TRUE(world[balls[i]].isAsleep()) << "restitution " << restitutions[i];
    }
    EXPECT_FALSE(world[balls.back()].isAsleep());
}

// Impacts differ when all bodies are moved away from x = 0.
// https://github.com/schteppe/p2.js/issues/66
TEST(FieldBounce, AnImpactIsTheSameFarFromTheOrigin) {
    const auto play = [](Real x) {
        World world = underGravity();
        addGround(world, {.restitution = Real(0.5)});
        world.add({.shape = kodo::Box{2000, 2},
                   .position = {0, -1},
                   .material = {.restitution = Real(0.5)},
                   .type = BodyType::Static});
        const BodyId box = world.add({.shape = kodo::Box{1, 1},
                                      .position = {x, 3},
                                      .rotation = kodo::Rot::fromAngle(Real(0.3)),
                                      .material = {.restitution = Real(0.5)}});
        run(world, Real(0.9)); // after the first impact
        return std::array<Real, 3>{world[box].position().x - x, world[box].velocity().y,
                                   world[box].angularVelocity()};
    };
    const auto near = play(0);
    // Coordinates of 1 km have a resolution of 0.06 mm in float.
    for (const Real x : {Real(10), Real(-300), Real(900)}) {
        const auto far = play(x);
        for (std::size_t i = 0; i < near.size(); ++i) {
            EXPECT_NEAR(far[i], near[i], 0.01) << "at " << x;
        }
    }
}

// A ball dropped from 2 m rebounds by 1 % of the height whatever its restitution is.
// https://github.com/dimforge/rapier/issues/974
TEST(FieldBounce, ADroppedBallReboundsByTheSquareOfItsRestitution) {
    for (const Real e : {Real(0.3), Real(0.5), Real(0.8), Real(0.95)}) {
        World world({.gravity = {0, Real(-9.81)}});
        addGround(world, {.restitution = 1});
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.25)},
                                       .position = {0, Real(2.25)},
                                       .material = {.restitution = e}});
        Real peak = 0;
        bool rising = false;
        for (int i = 0; i < 120; ++i) {
            world.step(kDt);
            rising = rising || world[ball].velocity().y > 0;
            if (rising && world[ball].velocity().y <= 0) {
                break;
            }
            peak = rising ? std::max(peak, world[ball].position().y - Real(0.25)) : 0;
        }
        EXPECT_NEAR(peak / 2, e * e, 0.02) << "restitution " << e;
    }
}

// A ball that meets a resting one sticks to it, with restitution 1, instead of handing its speed
// over. https://github.com/jrouwe/JoltPhysics/issues/1403
TEST(FieldBounce, ABallHandsItsSpeedToARestingOneAsleepOrAwake) {
    for (const bool asleep : {false, true}) {
        World world;
        const BodyId target = world.add({.shape = kodo::Circle{Real(0.5)}, .material = kElastic});
        run(world, asleep ? Real(3) : kDt);
        ASSERT_EQ(world[target].isAsleep(), asleep);
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.5)},
                                       .position = {0, 2},
                                       .velocity = {0, -1},
                                       .material = kElastic});
        run(world, 2);
        EXPECT_NEAR(world[target].velocity().y, -1, 1e-5);
        EXPECT_NEAR(world[ball].velocity().y, 0, 1e-5);
    }
}

} // namespace
} // namespace field
