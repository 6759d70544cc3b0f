// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// From the shortest to the longest dt, v = g t and y = g t^2 / 2 hold to the rounding of 1000
// steps.
TEST(StepLength, FreeFallIsExactAtAnyStep) {
    for (const double dt : {1e-7, 1e-5, 1e-3, 0.02, 1.0}) {
        SCOPED_TRACE(dt);
        World world({.gravity = {0, static_cast<Real>(-0.1)}});
        const BodyId ball = world.add(support::ballDef({}, Real(0.5)));
        support::run(world, 1000, static_cast<Real>(dt));
        const double t = 1000 * dt;
        EXPECT_TRUE(nearShare(world[ball].velocity().y, -0.1 * t, byPrecision(1e-4, 1e-12)));
        EXPECT_TRUE(nearShare(world[ball].position().y, -0.05 * t * t, byPrecision(3e-4, 1e-12)));
    }
}

// At any dt a box at rest stays, and a ball that falls 50 m does not tunnel. Contacts are as stiff
// as substeps allow, and substeps are refined before a contact yields by two slops. Contacts with
// static bodies are twice as stiff, which leaves half a slop. The bound is 1.25 slops (a slop is 4
// mm).
TEST(StepLength, TheFloorHoldsAtAnyStep) {
    for (const double dt : {1e-5, 1e-3, 0.02, 0.1, 0.5, 1.0}) {
        SCOPED_TRACE(dt);
        World world({.gravity = support::kEarth});
        support::addFloor(world);
        const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
        const BodyId ball = world.add(support::ballDef({5, 50}, Real(0.5)));
        support::run(world, 500, static_cast<Real>(dt));
        EXPECT_TRUE(near(world[box].position().y, 0.5, 0.005));
        EXPECT_GT(world[ball].position().y, Real(0.4));
        EXPECT_LT(world[ball].position().y, Real(50.01));
    }
}

// Without gravity, bodies that touch or overlap by less than the slop do not move by one bit.
TEST(Gravity, OfZeroMovesNothing) {
    World world;
    support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 5);
    support::run(world, 200);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_EQ(world[boxes[i]].position(), (Vec2{0, Real(0.5) + static_cast<Real>(i)}));
        EXPECT_EQ(world[boxes[i]].velocity(), Vec2{});
    }
}

// Under up to a thousand times Earth's gravity, a box stays within the slop and falls asleep. So
// does a box on top, since large forces refine the substeps.
TEST(Gravity, OfAThousandEarthsLetsBoxesFallAsleepInPlace) {
    for (const Real g : {Real(100), Real(900), Real(1e3), Real(2e3), Real(1e4)}) {
        SCOPED_TRACE(g);
        World world({.gravity = {0, -g}});
        support::addFloor(world);
        const std::vector<BodyId> boxes = support::addStack(world, 2);
        const BodyId alone = world.add(support::boxDef({5, Real(0.5)}, 1, 1));
        support::run(world, 300);
        EXPECT_TRUE(near(world[alone].position().y, 0.5L, world.tolerances().slop));
        EXPECT_TRUE(near(world[boxes[1]].position().y, 1.5L, 3 * world.tolerances().slop));
        for (const BodyId id : {boxes[0], boxes[1], alone}) {
            EXPECT_LT(length(world[id].velocity()), Real(0.01));
            EXPECT_NE(world[id].flags() & kAsleep, 0u);
        }
    }
}

// No speed up to the limit is reduced: the distance is v t.
TEST(Speed, IsNotReducedUpToItsLimit) {
    for (const Real speed : {Real(100), Real(1e4), Real(1e6), kMaxSpeed}) {
        SCOPED_TRACE(speed);
        World world;
        BodyDef def = support::ballDef({}, Real(0.5));
        def.velocity = {speed, 0};
        const BodyId ball = world.add(def);
        const Real dt = 1 / std::max(speed, Real(1000)); // 50 m in 50 steps, or less
        support::run(world, 50, dt);
        EXPECT_TRUE(nearShare(world[ball].position().x, static_cast<double>(speed * dt) * 50,
                              50 * support::kEpsilon));
        EXPECT_EQ(world[ball].velocity(), (Vec2{speed, 0}));
    }
}

// Beyond the limit, a setter refuses the velocity. A force that leads there freezes the body and
// reports it. Other bodies continue.
TEST(Speed, BeyondItsLimitIsRefusedOrReported) {
    World world;
    const BodyId ball = world.add(support::ballDef({}, Real(0.5)));
    const BodyId other = world.add(support::ballDef({0, 50}, Real(0.5)));
    world[other].setVelocity({1, 0});
    EXPECT_THROW(world[ball].setVelocity({Real(1.01) * kMaxSpeed, 0}), BadDefinition);
    EXPECT_THROW(world[ball].setAngularVelocity(Real(-1.01) * kMaxSpeed), BadDefinition);
    world[ball].setVelocity({kMaxSpeed, 0});
    world[ball].applyForce({Real(1e9), 0});
    world.step(support::kDt);
    ASSERT_EQ(world.frozenBodies().size(), 1u);
    EXPECT_EQ(world.frozenBodies()[0], ball);
    EXPECT_EQ(world[ball].position(), Vec2{});
    EXPECT_EQ(world[ball].velocity(), Vec2{});
    EXPECT_TRUE(near(world[other].position().x, 1.0L / 60, support::kEpsilon));
}

// A body freezes on the ground in the step in which another falls asleep. Its contact is recorded
// in that step and ends when the body is removed.
TEST(FrozenBody, KeepsItsContactWhileAnotherFallsAsleep) {
    World world({.gravity = support::kEarth});
    world.setSettings({.sleepSteps = 5});
    const BodyId floor = support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    BodyDef def = support::boxDef({5, Real(0.5)}, 1, 1);
    def.flags = kNeverSleep;
    const BodyId other = world.add(def);
    bool rested = false;
    for (int step = 0; step < 60 && !rested; ++step) {
        World copy = world;
        copy[other].applyForce({std::numeric_limits<Real>::max(), 0});
        copy[other].applyForce({std::numeric_limits<Real>::max(), 0});
        copy.step(support::kDt);
        ASSERT_EQ(copy.frozenBodies().size(), 1u);
        ASSERT_NE(support::recordOf(copy, floor, other), nullptr);
        copy.remove(other); // each Begin needs an End
        copy.step(support::kDt);
        const CollisionRecord* end = support::recordOf(copy, floor, other);
        ASSERT_TRUE(end != nullptr && end->phase == TouchPhase::End) << step;
        world.step(support::kDt);
        rested = (world[box].flags() & kAsleep) != 0;
    }
    EXPECT_TRUE(rested);
}

TEST(FrozenBody, StaysFrozenWhenItsFlagsChange) {
    World world;
    const BodyId box = world.add(support::boxDef({}, 1, 1));
    world[box].setVelocity({kMaxSpeed, 0});
    world[box].applyForce({Real(1e9), 0});
    world.step(support::kDt);
    ASSERT_NE(world[box].flags() & kFrozen, 0u);
    world[box].setFlags(1);
    world[box].applyTorque(100);
    support::run(world, 10);
    EXPECT_EQ(world[box].angularVelocity(), 0);
    world[box].setVelocity({1, 0}); // unfreezes
    world[box].applyTorque(1);
    world.step(support::kDt);
    EXPECT_GT(world[box].angularVelocity(), 0);
}

} // namespace
} // namespace kodo
