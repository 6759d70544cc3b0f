// SPDX-License-Identifier: MIT
// Lists of begins, ends and hits, and the records of one body.
#include "support/solver.hpp"
#include <kodo/executor.hpp>
#include <kodo/snapshot.hpp>
#include <kodo/step_stats.hpp>
#include <support/same_events.hpp>
#include <support/scenes.hpp>
#include <support/sleeping.hpp>

#include "world/snapshot_scenes.hpp"

#include <limits>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::eventsMatchRecords;
using support::kDt;
using support::run;
using support::sameRecords;
using support::Solver;

/// A heap under one of the solvers.
World heapWorld(Solver solver, std::uint64_t seed, int count) {
    World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
    support::addHeap(world, seed, count);
    return world;
}

// S2: a ball that bounces once begins and ends once; the hit is in the step of the Begin.
TEST(Events, ABounceIsOneBeginOneEndAndOneHit) {
    World world({.gravity = support::kEarth});
    const Material elastic = support::slippery(1);
    const BodyId floor = support::addFloor(world, elastic);
    const BodyId ball = world.add(ballDef({0, 1}, Real(0.5), elastic));
    int begins = 0;
    int ends = 0;
    int hits = 0;
    for (int step = 0; step < 30; ++step) { // it lands after 0.32 s
        world.step(kDt);
        for (const CollisionRecord& record : world.begunCollisions()) {
            EXPECT_EQ(record.phase, TouchPhase::Begin);
            ++begins;
        }
        for (const CollisionRecord& record : world.endedCollisions()) {
            EXPECT_EQ(record.phase, TouchPhase::End);
            EXPECT_EQ(begins, 1);
            ++ends;
        }
        for (const CollisionRecord& record : world.hits(2)) {
            EXPECT_EQ(record.a, floor);
            EXPECT_EQ(record.b, ball);
            EXPECT_GT(record.approachSpeed, 3); // sqrt(2 g h) = 3.2 m/s
            ++hits;
        }
        EXPECT_TRUE(world.hits(4).empty());
    }
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(ends, 1);
    EXPECT_EQ(hits, 1);
}

TEST(Events, APileAtRestHasNone) {
    World world(support::withoutSleep());
    support::addFloor(world);
    support::addStack(world, 10);
    run(world, 120);
    world.step(kDt);
    EXPECT_TRUE(world.begunCollisions().empty());
    EXPECT_TRUE(world.endedCollisions().empty());
    EXPECT_TRUE(world.hits(Real(0.1)).empty());
    EXPECT_EQ(world.collisions().size(), 10u);
}

// S2: a sensor applies no impulse, so its contacts are no hits.
TEST(Events, ASensorBeginsAndEndsWithoutAHit) {
    World world;
    BodyDef zone = boxDef({0, 0}, 2, 2);
    zone.type = BodyType::Static;
    zone.flags = kSensor;
    world.add(zone);
    BodyDef shot = ballDef({-3, 0}, Real(0.2));
    shot.velocity = {20, 0};
    world.add(shot);
    std::size_t begins = 0;
    std::size_t ends = 0;
    for (int step = 0; step < 30; ++step) {
        world.step(kDt);
        ASSERT_TRUE(eventsMatchRecords(world)) << step;
        begins += world.begunCollisions().size();
        ends += world.endedCollisions().size();
        EXPECT_TRUE(world.hits(0).empty());
    }
    EXPECT_EQ(begins, 1u);
    EXPECT_EQ(ends, 1u);
}

// S2: in falling, resting and sleeping heaps, with both solvers.
TEST(Events, MatchTheRecordsOfAHeap) {
    for (const Solver solver : support::kSolvers) {
        SCOPED_TRACE(static_cast<int>(solver));
        World world = heapWorld(solver, 31, 30);
        std::size_t events = 0;
        for (int step = 0; step < 400; ++step) {
            world.step(kDt);
            ASSERT_TRUE(eventsMatchRecords(world)) << "step " << step;
            events += world.begunCollisions().size() + world.hits(1).size();
        }
        EXPECT_GT(events, 100u);
    }
}

// S2: with joints, compounds, a sensor, a region, sleep and a moving platform. A restored snapshot
// has the same lists.
TEST(Events, MatchTheRecordsOfABusyWorldAndItsSnapshots) {
    for (const Solver solver : support::kSolvers) {
        SCOPED_TRACE(static_cast<int>(solver));
        World world = support::busyWorld(support::settingsOf(solver));
        for (int step = 0; step < 200; ++step) {
            world.step(kDt);
            ASSERT_TRUE(eventsMatchRecords(world)) << "step " << step;
            if (step % 10 == 9) {
                const World restored = fromBytes(toBytes(world), support::ownFields());
                ASSERT_TRUE(eventsMatchRecords(restored)) << "step " << step;
                ASSERT_TRUE(sameRecords(restored, world)) << "step " << step;
            }
        }
    }
}

// S2: the lists keep the records of the last step, whether they are read before or after a change.
TEST(Events, StayTheSameAfterChangesOfTheWorld) {
    for (int steps = 20; steps < 100; steps += 7) {
        SCOPED_TRACE(steps);
        World world = heapWorld(Solver::Soft, 32, 40);
        run(world, steps);
        const World before = world;
        World read = world;
        const std::span<const CollisionRecord> begun = read.begunCollisions();
        for (World* changed : {&world, &read}) {
            const std::vector<BodyId> bodies = changed->bodies();
            changed->remove(bodies[0]); // the floor
            changed->remove(bodies[9]);
            changed->add(ballDef({0, 1}, 1)); // in the place of a removed one
            (*changed)[bodies[12]].setPosition({0, 50});
            (*changed)[bodies[13]].setType(BodyType::Static);
        }
        EXPECT_TRUE(eventsMatchRecords(world));
        EXPECT_TRUE(sameRecords(world, before));
        EXPECT_TRUE(sameRecords(begun, before.begunCollisions()));
        const std::vector<BodyId> bodies = world.bodies();
        world.weld(bodies[3], bodies[4]);
        EXPECT_TRUE(eventsMatchRecords(world));
        EXPECT_TRUE(sameRecords(world, before));
        world.unweld(bodies[3], 0);
        EXPECT_TRUE(eventsMatchRecords(world));
        EXPECT_TRUE(sameRecords(world, before));
    }
}

// S2: in the step in which a stack falls asleep, and when it is woken.
TEST(Events, MatchTheRecordsWhenIslandsSleepAndWake) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const std::vector<BodyId> stack = support::addStack(world, 4);
    const std::vector<BodyId> other = support::addStack(world, 3, 5);
    world[other[2]].setVelocity({0, 3}); // falls asleep later
    for (int step = 0; step < 200; ++step) {
        const bool wasAsleep = support::isAsleep(world, stack[0]);
        world.step(kDt);
        ASSERT_TRUE(eventsMatchRecords(world)) << "step " << step;
        // The step in which it falls asleep still has its records, and those after have none.
        ASSERT_EQ(world.collisions(stack[0]).size(), wasAsleep ? 0u : 2u) << "step " << step;
    }
    ASSERT_EQ(support::countAsleep(world), 7u);
    world[stack[3]].setVelocity({0, 1});
    EXPECT_TRUE(eventsMatchRecords(world));
    for (int step = 0; step < 100; ++step) {
        world.step(kDt);
        ASSERT_TRUE(eventsMatchRecords(world)) << "step " << step;
    }
}

// Reading has no effect on the steps that follow.
TEST(Events, ReadingChangesNoBit) {
    for (const Solver solver : support::kSolvers) {
        World read = heapWorld(solver, 33, 40);
        World left = read;
        for (int step = 0; step < 200; ++step) {
            read.step(kDt);
            left.step(kDt);
            read.begunCollisions();
            read.hits(Real(0.5));
            read.collisions(read.bodies()[static_cast<std::size_t>(step) % 40]);
            ASSERT_EQ(read.stateHash(), left.stateHash()) << "step " << step;
        }
    }
}

TEST(Events, AreTheSameWithThreads) {
    ThreadPool pool(3);
    World alone({.gravity = support::kEarth});
    support::addHeap(alone, 34, 700);
    World helped = alone;
    for (int step = 0; step < 60; ++step) {
        alone.step(kDt);
        helped.step(kDt, {.executor = &pool});
        ASSERT_TRUE(sameRecords(alone, helped)) << "step " << step;
        ASSERT_TRUE(sameRecords(alone.hits(1), helped.hits(1))) << "step " << step;
    }
}

TEST(Events, AreEmptyWithoutRecords) {
    World world({.gravity = support::kEarth});
    StepSettings settings;
    settings.leaveOut = Feature::Records;
    world.setSettings(settings);
    support::addHeap(world, 35, 20);
    for (int step = 0; step < 60; ++step) {
        world.step(kDt);
        ASSERT_TRUE(world.begunCollisions().empty());
        ASSERT_TRUE(world.endedCollisions().empty());
        ASSERT_TRUE(world.hits(0).empty());
        ASSERT_TRUE(world.collisions(world.bodies()[0]).empty());
    }
}

// Values that are no speed, and bodies that do not exist.
TEST(Events, RefuseBadArguments) {
    World world;
    const BodyId ball = world.add(ballDef({}, 1));
    EXPECT_THROW(world.hits(-1), BadDefinition);
    EXPECT_THROW(world.hits(std::numeric_limits<Real>::quiet_NaN()), BadDefinition);
    EXPECT_TRUE(world.collisions(ball).empty());
    world.remove(ball);
    EXPECT_THROW(world.collisions(ball), BadBodyId);
}

// The lanes of many contacts are dropped when their bodies fall asleep. A body that stays awake
// keeps the impulse of that step in its record.
TEST(Events, KeepTheImpulseOfABodyBesideManyThatFallAsleep) {
    constexpr int kBoxes = 4000;
    World world({.gravity = support::kEarth});
    world.add({.shape = Plane{{0, 1}, 0}, .type = BodyType::Static});
    const BodyId awake =
        world.add({.shape = Box{1, 1}, .position = {-5, Real(0.5)}, .flags = kNeverSleep});
    for (int i = 0; i < kBoxes; ++i) {
        world.add({.shape = Box{1, 1}, .position = {Real(2 * i), Real(0.5)}});
    }
    const Real weight = world[awake].mass() * length(support::kEarth);
    while (stepStats(world).bodies != 1) {
        ASSERT_LT(world.stepCount(), 300u);
        world.step(kDt);
        const std::vector<CollisionRecord> records = world.collisions(awake);
        ASSERT_EQ(records.size(), 1u) << "step " << world.stepCount();
        EXPECT_NEAR(records[0].totalImpulse / (weight * kDt), 1, 0.02) << world.stepCount();
    }
}

} // namespace
} // namespace kodo
