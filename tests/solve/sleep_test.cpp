// SPDX-License-Identifier: MIT
#include <scenes/in_kodo.hpp>
#include <scenes/piles.hpp>
#include <support/sleeping.hpp>

#include <memory>

namespace kodo {
namespace {

using support::addFloor;
using support::addStack;
using support::ballDef;
using support::boxDef;
using support::isAsleep;
using support::kDt;
using support::near;
using support::run;
using support::slippery;
using support::stepsUntilAsleep;

WorldDef restingAfter(int steps) {
    WorldDef def{.gravity = support::kEarth};
    def.settings.sleepSteps = steps;
    return def;
}

// O3: steps are counted, not seconds: a box without motion falls asleep after sleepSteps steps.
TEST(Sleep, BeginsAfterTheSetNumberOfCalmSteps) {
    for (const int steps : {1, 10, 30, 100}) {
        World world(restingAfter(steps));
        addFloor(world);
        const BodyId box = world.add(boxDef({3, Real(0.5)}, 1, 1));
        EXPECT_EQ(stepsUntilAsleep(world, box, 200), steps);
        EXPECT_EQ(world[box].velocity(), Vec2{});
        EXPECT_EQ(world[box].angularVelocity(), 0);
    }
}

// O3: the same steps after it wakes without moving, wherever it lies.
TEST(Sleep, BeginsAgainAfterTheSetNumberOfCalmSteps) {
    for (const int steps : {1, 10, 30}) {
        World world(restingAfter(steps));
        addFloor(world);
        const BodyId box = world.add(boxDef({3, Real(0.5)}, 1, 1));
        ASSERT_EQ(stepsUntilAsleep(world, box, 200), steps);
        for (int time = 0; time < 3; ++time) {
            world[box].wake();
            EXPECT_EQ(stepsUntilAsleep(world, box, 200), steps);
        }
    }
}

/// True if a box that starts on ice with this speed (m/s) falls asleep within 1 m.
bool restsOnIce(Real speed, int sleepSteps) {
    World world(restingAfter(sleepSteps));
    addFloor(world, slippery());
    BodyDef def = boxDef({3, Real(0.5)}, 1, 1, slippery());
    def.velocity = {speed, 0};
    const BodyId box = world.add(def);
    while (world[box].position().x < 4) {
        world.step(kDt);
        if (isAsleep(world, box)) {
            return true;
        }
    }
    return false;
}

// O3: a body in slow steady motion falls asleep only if it moves by at most a quarter of the slop
// in all calm steps. So the stop is invisible.
TEST(Sleep, TakesACreepingBodyOnlyWithinAQuarterOfTheSlop) {
    for (const int sleepSteps : {10, 30, 100}) {
        const Real place = World().tolerances().slop / 4;
        const Real limit = place / (static_cast<Real>(sleepSteps) * kDt);
        EXPECT_TRUE(restsOnIce(Real(0.8) * limit, sleepSteps)) << sleepSteps;
        EXPECT_FALSE(restsOnIce(Real(1.25) * limit, sleepSteps)) << sleepSteps;
    }
}

// O3, the energy rule: without forces only a body without motion is calm.
TEST(Sleep, WithoutForcesTakesOnlyBodiesWithoutMotion) {
    World world;
    const BodyId still = world.add(ballDef({5, 0}, 1));
    BodyDef def = ballDef({10, 0}, 1);
    def.velocity = {0, Real(1e-6)};
    const BodyId drifting = world.add(def);
    def = boxDef({20, 0}, 1, 1);
    def.angularVelocity = Real(1e-6);
    const BodyId turning = world.add(def);
    run(world, 300);
    EXPECT_TRUE(isAsleep(world, still));
    EXPECT_FALSE(isAsleep(world, drifting));
    EXPECT_FALSE(isAsleep(world, turning));
}

// O3: near the apex of a throw |v| <= g dt holds for two or three steps, for any time step. The
// velocity changes there, so no body falls asleep, at any count.
TEST(Sleep, DoesNotTakeABodyAtTheApexOfAThrow) {
    for (const int sleepSteps : {1, 2, 3, 4, 30}) {
        for (const Real dt : {Real(1) / 1000, Real(1) / 240, kDt, Real(1) / 10}) {
            World world(restingAfter(sleepSteps));
            std::vector<BodyId> thrown;
            for (int i = 0; i < 40; ++i) {
                BodyDef def = ballDef({static_cast<Real>(2 * i), 100}, Real(0.5));
                def.velocity = {0, Real(0.3) + Real(0.017) * static_cast<Real>(i)};
                thrown.push_back(world.add(def));
            }
            for (int step = 0; step < 300; ++step) {
                world.step(dt);
                ASSERT_EQ(support::countAsleep(world), 0u) << "dt " << dt << ", step " << step;
            }
            for (const BodyId id : thrown) {
                EXPECT_LT(world[id].velocity().y, Real(-0.5));
            }
        }
    }
}

// O3: what its support leaves falls, at any count and step, with either solver: 1/2 g t^2.
TEST(Sleep, DoesNotTakeABodyWhoseGroundIsGone) {
    for (const StepSettings& profile : {balanced(), thesis2006()}) {
        for (const int sleepSteps : {1, 2, 3, 30}) {
            for (const int rate : {30, 60, 240, 1000}) {
                WorldDef def{.gravity = support::kEarth, .settings = profile};
                def.settings.sleepSteps = sleepSteps;
                World world(def);
                const BodyId floor = addFloor(world);
                const BodyId box = world.add(boxDef({3, Real(0.5)}, 1, 1));
                const Real dt = Real(1) / static_cast<Real>(rate);
                for (int step = 0; step < rate; ++step) {
                    world.step(dt);
                }
                ASSERT_TRUE(isAsleep(world, box));
                const Real height = world[box].position().y;
                world.remove(floor);
                for (int step = 0; step < rate; ++step) {
                    world.step(dt);
                }
                const Real way = length(support::kEarth) / 2;
                EXPECT_TRUE(near(height - world[box].position().y, way, Real(0.04) * way))
                    << sleepSteps << " steps at " << rate << " Hz"; // a step more: 1 / 30 of it
            }
        }
    }
}

// O3, fig. 5.3: a body slightly off its balance gains less energy in a step than its forces would
// give it from rest. It must tip over nevertheless.
TEST(Sleep, DoesNotTakeASlowlyTippingBody) {
    const Real balance = std::atan2(Real(0.4), Real(2)); // its diagonal is vertical
    for (const Real off :
         {Real(0.03), Real(0.01), Real(3e-3), Real(1e-3), Real(3e-4), Real(1e-4)}) {
        World world({.gravity = support::kEarth});
        addFloor(world);
        BodyDef def = boxDef({}, Real(0.4), 2);
        def.rotation = Rot::fromAngle(balance + off);
        const Vec2 corner = def.rotation * Vec2{Real(-0.2), -1};
        def.position = {3, -corner.y};
        const BodyId box = world.add(def);
        bool early = false;
        for (int step = 0; step < 600 && !early; ++step) {
            world.step(kDt);
            early = isAsleep(world, box) && world[box].rotation().c > Real(0.1);
        }
        EXPECT_FALSE(early) << off;
        EXPECT_TRUE(near(world[box].rotation().c, 0, Real(0.01))) << "lies, from " << off;
        EXPECT_TRUE(isAsleep(world, box)) << off;
    }
}

// O3: the calm count is that of the whole pile, the lowest among touching bodies. The lower box has
// been calm for long when the other one lands on it, but they fall asleep together.
TEST(Sleep, TouchingBodiesFallAsleepTogether) {
    World world(restingAfter(60));
    addFloor(world);
    const BodyId lower = world.add(boxDef({3, Real(0.5)}, 1, 1));
    const BodyId upper = world.add(boxDef({3, Real(2.5)}, 1, 1)); // lands after 27 steps
    const BodyId apart = world.add(boxDef({9, Real(0.5)}, 1, 1));
    EXPECT_EQ(stepsUntilAsleep(world, apart, 200), 60);
    EXPECT_FALSE(isAsleep(world, lower));
    const int more = stepsUntilAsleep(world, lower, 200);
    EXPECT_TRUE(isAsleep(world, upper));
    EXPECT_GT(more, 25);
    EXPECT_LT(more, 200);
}

// O3: also along a row of touching bodies. One awake body at the end keeps all of it awake. The
// floor, which all of them touch, does not connect piles.
TEST(Sleep, OneAwakeBodyKeepsOnlyItsOwnPileAwake) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    const std::vector<BodyId> pile = addStack(world, 5, 3);
    const std::vector<BodyId> other = addStack(world, 5, 9);
    world[pile[4]].setFlags(kNeverSleep); // R8
    run(world, 600);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_FALSE(isAsleep(world, pile[i])) << i;
        EXPECT_TRUE(isAsleep(world, other[i])) << i;
    }
    world[pile[4]].setFlags(0);
    run(world, 60);
    EXPECT_EQ(support::countAsleep(world), 10u);
}

// O3: a body whose forces are in balance falls asleep without support: here a floating one.
TEST(Sleep, TakesAFloatingBody) {
    World world({.gravity = support::kEarth});
    world.addField({std::make_shared<Buoyancy>(Buoyancy::Fluid{2, 8}, Vec2{}, support::kEarth)});
    const BodyId box = world.add(boxDef({3, Real(0.3)}, 2, 1));
    EXPECT_LE(stepsUntilAsleep(world, box, 1800), 1800);
    EXPECT_TRUE(near(world[box].position(), Vec2{3, 0}, world.tolerances().slop));
}

// O3: sleeping bodies cost nothing: a step visits no body and no contact, and records none.
TEST(Sleep, TenThousandSleepingBodiesAreNotVisited) {
    World world({.gravity = support::kEarth});
    addFloor(world);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 5000; ++i) {
        const Real x = Real(-625) + static_cast<Real>(i) / 4;
        for (const Real y : {Real(0.0625), Real(0.1875)}) {
            boxes.push_back(world.add(boxDef({x, y}, Real(0.125), Real(0.125))));
        }
    }
    world.step(kDt);
    EXPECT_EQ(stepStats(world).bodies, 10000u);
    EXPECT_GE(stepStats(world).contacts, 10000u);
    run(world, 120);
    ASSERT_EQ(support::countAsleep(world), 10000u);
    EXPECT_EQ(stepStats(world).bodies, 0u);
    EXPECT_EQ(stepStats(world).contacts, 0u);
    EXPECT_TRUE(world.collisions().empty());
    // After an impulse on one body, a step visits only its island.
    world[boxes[5000]].applyImpulse({0, Real(1e-4)});
    world.step(kDt);
    EXPECT_EQ(stepStats(world).bodies, 2u);
    EXPECT_GT(stepStats(world).contacts, 0u);
    // Two contacts, each twice per substep.
    EXPECT_LE(stepStats(world).contacts,
              4u * static_cast<std::size_t>(world.settings().soft().substeps));
    EXPECT_EQ(world.collisions().size(), 2u);
}

/// Largest distance (m) of a body between two worlds.
Real farthestApart(const World& one, const World& other) {
    Real most = 0;
    for (const BodyId id : one.bodies()) {
        most = std::max(
            most, length(one[id].position() - other[BodyId{id.index, id.generation}].position()));
    }
    return most;
}

// O3: sleep changes final poses as little as possible. A body stops within a quarter of the slop of
// its pose when it became calm. A body supported by it may move by twice that.
TEST(Sleep, OnAndOffEndInTheSamePoses) {
    for (const scenes::SceneDef& scene :
         {scenes::stack(10), scenes::pyramid(8), scenes::pile(10)}) {
        World with = scenes::inKodo(scene).world;
        StepSettings settings;
        settings.leaveOut = Feature::Sleep;
        World without = scenes::inKodo(scene, settings).world;
        run(with, 1200);
        run(without, 1200);
        EXPECT_GT(support::countAsleep(with), 9u) << scene.name;
        EXPECT_EQ(support::countAsleep(without), 0u) << scene.name;
        EXPECT_LT(farthestApart(with, without), with.tolerances().slop) << scene.name;
    }
}

// R8: only a step changes the flag; setFlags() and BodyDef ignore it.
TEST(Sleep, AUserCannotSetTheAsleepFlag) {
    World world({.gravity = support::kEarth});
    BodyDef def = ballDef({0, 50}, 1);
    def.flags = kAsleep | kColliding | kFrozen | kOutside;
    const BodyId ball = world.add(def);
    EXPECT_EQ(world[ball].flags(), 0u);
    world[ball].setFlags(kAsleep | 5);
    EXPECT_EQ(world[ball].flags(), 5u);
    run(world, 60);
    EXPECT_LT(world[ball].position().y, 46);
}

} // namespace
} // namespace kodo
