// SPDX-License-Identifier: MIT
// Reports on sleeping and waking.
#include <gtest/gtest.h>

#include "field_scene.hpp"

namespace field {
namespace {

// A static body stays awake for ever after the dynamic body that slid on it is destroyed.
// https://github.com/erincatto/box2d/issues/450
TEST(FieldSleep, NothingIsAwakeAfterTheOnlyMovingBodyIsRemoved) {
    World world = underGravity();
    const BodyId ground = addGround(world);
    const BodyId box =
        world.add({.shape = kodo::Box{1, 1}, .position = {0, Real(0.5)}, .velocity = {5, 0}});
    run(world, Real(0.5));
    ASSERT_EQ(kodo::stepStats(world).bodies, 1u);
    world.remove(box);
    world.step(kDt);
    EXPECT_EQ(kodo::stepStats(world).bodies, 0u);
    EXPECT_EQ(kodo::stepStats(world).contacts, 0u);
    EXPECT_EQ(world[ground].flags() & kodo::kColliding, 0u);
}

// After a joint is removed, the sleeping body that it held hangs in the air.
// https://github.com/dimforge/rapier.js/issues/142
TEST(FieldSleep, ASleepingBodyFallsWhenItsJointIsRemoved) {
    World world = underGravity();
    const BodyId hook = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
    const BodyId ball = world.add({.shape = kodo::Circle{Real(0.5)}, .position = {0, -2}});
    const kodo::JointId slider = world.add(
        kodo::PrismaticJoint{.ends = {.a = hook, .b = ball, .anchorA = {0, -2}}, .axis = {1, 0}});
    run(world, 3);
    ASSERT_TRUE(world[ball].isAsleep());
    world.remove(slider);
    run(world, 1);
    EXPECT_NEAR(world[ball].position().y, -7, 0.1);
}

// A joint that is created between a sleeping body and another stays passive: its motor does
// nothing. https://github.com/defold/defold/issues/5405
TEST(FieldSleep, ASleepingBodyObeysAJointThatIsAddedToIt) {
    World world; // without gravity, as in the report
    const BodyId base = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
    const BodyId wheel = world.add({.shape = kodo::Circle{Real(0.5)}, .position = {0, 2}});
    run(world, 3);
    ASSERT_TRUE(world[wheel].isAsleep());
    world.add(kodo::RevoluteJoint{
        .ends = {.a = base, .b = wheel, .anchorA = {0, 2}}, .motorSpeed = 3, .motorTorque = 10});
    run(world, 1);
    EXPECT_NEAR(world[wheel].angularVelocity(), 3, 1e-3);
}

// A body that passes near a sleeping one, without a touch, wakes it.
// https://github.com/erincatto/box2d/issues/547
TEST(FieldSleep, ABodyThatPassesWithoutATouchDoesNotWake) {
    World world = underGravity();
    addGround(world);
    const BodyId box = addSleepingBox(world);
    ASSERT_TRUE(world[box].isAsleep());
    // A diagonal bar whose bounding box covers the sleeper, while its shape stays 0.3 m away.
    const BodyId bar = world.add({.shape = kodo::Box{4, Real(0.1)},
                                  .position = {Real(1.4), Real(1.9)},
                                  .rotation = kodo::Rot::fromAngle(Real(-0.785)),
                                  .velocity = {0, 0},
                                  .type = BodyType::Kinematic});
    world[bar].setVelocity({Real(0.2), Real(0.2)});
    for (int i = 0; i < 60; ++i) {
        world.step(kDt);
        ASSERT_TRUE(world[box].isAsleep()) << "step " << i;
    }
}

// The motor is reversed just before the island falls asleep; the island sleeps and ignores it.
// https://github.com/erincatto/box2d/issues/367
TEST(FieldSleep, AReversedMotorActsInEveryPhaseOfTheSleepCount) {
    for (int wait = 20; wait < 60; ++wait) {
        World world = underGravity();
        const BodyId base = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
        const BodyId arm = world.add({.shape = kodo::Box{2, Real(0.2)}, .position = {1, 0}});
        kodo::RevoluteJoint pin{.ends = {.a = base, .b = arm, .anchorB = {-1, 0}},
                                .limits = kodo::Range{Real(-0.5), Real(0.5)},
                                .motorSpeed = 1,
                                .motorTorque = 100};
        const kodo::JointId id = world.add(pin);
        run(world, Real(0.5) + static_cast<Real>(wait) * kDt);
        pin.motorSpeed = -1;
        world.setJoint(id, pin);
        run(world, 2);
        EXPECT_NEAR(world[arm].rotation().angle(), -0.5, 0.02) << "after " << wait << " steps";
    }
}

// Boxes hang in the air after the row that they sleep on is removed.
// https://github.com/dimforge/nphysics/issues/154
TEST(FieldSleep, ARowOfSleepersFallsWhenTheRowBelowIsRemoved) {
    World world = underGravity();
    addGround(world);
    std::vector<BodyId> low;
    std::vector<BodyId> high;
    for (int i = 0; i < 5; ++i) {
        const auto x = static_cast<Real>(i) * Real(1.2);
        low.push_back(world.add({.shape = kodo::Box{1, 1}, .position = {x, Real(0.5)}}));
        high.push_back(world.add({.shape = kodo::Box{1, 1}, .position = {x, Real(1.5)}}));
    }
    run(world, 4);
    ASSERT_TRUE(world[high[4]].isAsleep());
    for (const BodyId id : low) {
        world.remove(id);
    }
    run(world, 2);
    for (const BodyId id : high) {
        EXPECT_NEAR(world[id].position().y, 0.5, 0.01);
    }
}

} // namespace
} // namespace field
