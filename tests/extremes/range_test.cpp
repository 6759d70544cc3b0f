// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// dt from the shortest to the longest step: v = g t and y = g t^2 / 2 hold to rounding at all of
// them, in a thousand steps.
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

// The floor holds at any step: what lies on it stays, and what falls 50 m does not pass it.
// Contacts are springs as stiff as substeps bear, and these are divided before they give way by two
// slops; with the ground they are twice as stiff, which leaves half a slop. The bound is one and a
// quarter (a slop is 4 mm).
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

// Without gravity nothing moves that was not moved, not by one bit, however it touches or overlaps
// by less than the slop.
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

// A thousand times the Earth's: what is laid down stays there, within the slop, and comes to rest;
// so does what lies on it, since substeps are divided where forces are so large.
TEST(Gravity, OfAThousandEarthsHoldsABoxDown) {
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
            EXPECT_NE(world[id].flags() & kResting, 0u);
        }
    }
}

// No speed up to the limit is cut: the way is v t.
TEST(Speed, IsNotCappedUpToItsLimit) {
    for (const Real speed : {Real(100), Real(1e4), Real(1e6), kHighestSpeed}) {
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

// Beyond the limit a velocity is refused, and a force that leads there is reported, not cut off in
// silence. Others go on.
TEST(Speed, BeyondItsLimitIsRefusedOrReported) {
    World world;
    const BodyId ball = world.add(support::ballDef({}, Real(0.5)));
    const BodyId other = world.add(support::ballDef({0, 50}, Real(0.5)));
    world[other].setVelocity({1, 0});
    EXPECT_THROW(world[ball].setVelocity({Real(1.01) * kHighestSpeed, 0}), BadDefinition);
    EXPECT_THROW(world[ball].setAngularVelocity(Real(-1.01) * kHighestSpeed), BadDefinition);
    world[ball].setVelocity({kHighestSpeed, 0});
    world[ball].applyForce({Real(1e9), 0});
    world.step(support::kDt);
    ASSERT_EQ(world.frozenBodies().size(), 1u);
    EXPECT_EQ(world.frozenBodies()[0], ball);
    EXPECT_EQ(world[ball].position(), Vec2{});
    EXPECT_EQ(world[ball].velocity(), Vec2{});
    EXPECT_TRUE(near(world[other].position().x, 1.0L / 60, support::kEpsilon));
}

// A body that freezes on the ground in the very step in which another comes to rest keeps its
// contact: it is recorded in that step, and ends when the body goes.
TEST(Speed, ABodyMayFreezeInTheStepInWhichAnotherComesToRest) {
    World world({.gravity = support::kEarth});
    world.setSettings({.restSteps = 5});
    const BodyId floor = support::addFloor(world);
    const BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));
    BodyDef def = support::boxDef({5, Real(0.5)}, 1, 1);
    def.flags = kNeverRest;
    const BodyId other = world.add(def);
    bool rested = false;
    for (int step = 0; step < 60 && !rested; ++step) {
        World copy = world;
        copy[other].applyForce({std::numeric_limits<Real>::max(), 0});
        copy[other].applyForce({std::numeric_limits<Real>::max(), 0});
        copy.step(support::kDt);
        ASSERT_EQ(copy.frozenBodies().size(), 1u);
        ASSERT_NE(support::recordOf(copy, floor, other), nullptr);
        copy.remove(other); // what has begun ends
        copy.step(support::kDt);
        const CollisionRecord* end = support::recordOf(copy, floor, other);
        ASSERT_TRUE(end != nullptr && end->phase == TouchPhase::End) << step;
        world.step(support::kDt);
        rested = (world[box].flags() & kResting) != 0;
    }
    EXPECT_TRUE(rested);
}

// A change of flags does not let a body turn that is frozen.
TEST(Speed, AFrozenBodyStaysFrozenWhenItsFlagsChange) {
    World world;
    const BodyId box = world.add(support::boxDef({}, 1, 1));
    world[box].setVelocity({kHighestSpeed, 0});
    world[box].applyForce({Real(1e9), 0});
    world.step(support::kDt);
    ASSERT_NE(world[box].flags() & kFrozen, 0u);
    world[box].setFlags(1);
    world[box].applyTorque(100);
    support::run(world, 10);
    EXPECT_EQ(world[box].angularVelocity(), 0);
    world[box].setVelocity({1, 0}); // thaws
    world[box].applyTorque(1);
    world.step(support::kDt);
    EXPECT_GT(world[box].angularVelocity(), 0);
}

} // namespace
} // namespace kodo
