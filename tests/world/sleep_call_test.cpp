// SPDX-License-Identifier: MIT
// Sleep by call, and the list of bodies that moved.
#include <kodo/snapshot.hpp>
#include <support/sleeping.hpp>
#include <support/solver.hpp>

#include <algorithm>
#include <set>

namespace kodo {
namespace {

using support::isAsleep;
using support::kDt;

struct Tower {
    World world;
    BodyId floor;
    std::vector<BodyId> boxes;
};

/// A stack of three boxes that has begun to touch.
Tower towerOf(support::Solver solver) {
    World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
    const BodyId floor = support::addFloor(world);
    const std::vector<BodyId> boxes = support::addStack(world, 3);
    support::run(world, 2);
    return {std::move(world), floor, boxes};
}

TEST(SleepCall, PutsTheWholeIslandToSleepAtOnce) {
    for (const support::Solver solver : support::kSolvers) {
        auto [world, floor, boxes] = towerOf(solver);
        const BodyId aside = world.add(support::boxDef({5, 3}, 1, 1));
        EXPECT_TRUE(world[boxes[1]].sleep());
        for (const BodyId box : boxes) {
            EXPECT_TRUE(isAsleep(world, box));
            EXPECT_EQ(world[box].velocity(), Vec2{});
        }
        EXPECT_FALSE(isAsleep(world, aside));
        const Vec2 before = world[boxes[2]].position();
        support::run(world, 120);
        EXPECT_EQ(world[boxes[2]].position(), before);
        EXPECT_TRUE(world[boxes[0]].sleep()); // again: nothing to do
    }
}

// As an island that fell asleep by itself does: a touch, a change below it, a call.
TEST(SleepCall, EndsAsAnySleepDoes) {
    for (const support::Solver solver : support::kSolvers) {
        auto [world, floor, boxes] = towerOf(solver);
        world[boxes[0]].sleep();
        support::run(world, 10);
        const BodyId ball = world.add(support::ballDef({0, 5}, Real(0.5)));
        support::run(world, 60);
        EXPECT_FALSE(isAsleep(world, boxes[0]));
        world[ball].setPosition({30, 5});
        support::run(world, 2);
        world[boxes[0]].sleep();
        ASSERT_TRUE(isAsleep(world, boxes[2]));
        world.remove(floor);
        support::run(world, 30);
        EXPECT_LT(world[boxes[0]].position().y, 0);
    }
}

// In the air too: a body stays where it was put, until something touches it.
TEST(SleepCall, HoldsABodyInTheAir) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
        const BodyId body = world.add(support::boxDef({0, 5}, 1, 1));
        EXPECT_TRUE(world[body].sleep());
        support::run(world, 60);
        EXPECT_EQ(world[body].position(), (Vec2{0, 5}));
        world[body].wake();
        world.step(kDt);
        EXPECT_LT(world[body].position().y, 5);
    }
}

TEST(SleepCall, IsRefusedByWhatKeepsTheIslandAwake) {
    auto [world, floor, boxes] = towerOf(support::Solver::Soft);
    world[boxes[2]].setFlags(kNeverSleep);
    support::run(world, 2);
    EXPECT_FALSE(world[boxes[0]].sleep());
    EXPECT_FALSE(isAsleep(world, boxes[0]));
    world[boxes[2]].setFlags(0);
    Material belt;
    belt.surfaceSpeed = 1;
    world[floor].setMaterial(belt);
    support::run(world, 2);
    EXPECT_FALSE(world[boxes[0]].sleep());
    world[floor].setMaterial({});
    support::run(world, 2);
    world.setSettings({.leaveOut = Feature::Sleep});
    EXPECT_FALSE(world[boxes[0]].sleep());
    world.setSettings({});
    const BodyId platform =
        world.add({.position = {9, 9}, .velocity = {1, 0}, .type = BodyType::Kinematic});
    support::run(world, 2);
    EXPECT_FALSE(world[platform].sleep());
    EXPECT_TRUE(world[boxes[0]].sleep());
    EXPECT_TRUE(isAsleep(world, boxes[0]));
}

// The records of the last step stay, though they are written when they are first read.
TEST(SleepCall, LeavesTheRecordsOfTheLastStep) {
    auto [world, floor, boxes] = towerOf(support::Solver::Soft);
    World other = world;
    const std::size_t count = other.collisions().size();
    ASSERT_EQ(count, 3u);
    world[boxes[0]].sleep();
    EXPECT_EQ(world.collisions().size(), count);
    world.step(kDt);
    EXPECT_TRUE(world.endedCollisions().empty()); // they still touch
}

TEST(SleepCall, ContinuesFromASnapshotAndAsWithAnyThreads) {
    for (const support::Solver solver : support::kSolvers) {
        auto [world, floor, boxes] = towerOf(solver);
        world[boxes[0]].sleep();
        World read = fromBytes(toBytes(world));
        World copy = world;
        for (World* each : {&world, &read, &copy}) {
            support::run(*each, 5);
            (*each)[boxes[2]].applyImpulse({1, 0});
            support::run(*each, 60);
        }
        EXPECT_EQ(read.stateHash(), world.stateHash());
        EXPECT_EQ(copy.stateHash(), world.stateHash());
    }
}

// All poses that a step changes are those of listed bodies; and all listed bodies moved or sleep.
TEST(MovedBodies, AreThoseWhosePoseChanged) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
        support::addFloor(world);
        support::addStack(world, 4);
        for (int i = 0; i < 12; ++i) { // boxes that tumble to rest, and balls that roll on
            BodyDef def = support::boxDef({Real(5) + 2 * static_cast<Real>(i), 3}, 1, Real(0.5));
            def.rotation = Rot::fromAngle(static_cast<Real>(i));
            def.shape = i % 4 == 0 ? Shape(Circle{Real(0.5)}) : def.shape;
            world.add(def);
        }
        world.add({.position = {0, 30}, .velocity = {1, 0}, .type = BodyType::Kinematic});
        std::vector<Transform> before;
        std::size_t fewest = world.bodyCount();
        for (int step = 0; step < 400; ++step) {
            before.clear();
            for (const BodyId id : world.bodies()) {
                before.push_back(world[id].transform());
            }
            world.step(kDt);
            const std::vector<BodyId> moved = world.movedBodies();
            EXPECT_TRUE(std::is_sorted(moved.begin(), moved.end()));
            fewest = std::min(fewest, moved.size());
            const std::set<BodyId> listed(moved.begin(), moved.end());
            std::size_t i = 0;
            for (const BodyId id : world.bodies()) {
                const Transform now = world[id].transform();
                const bool changed =
                    now.position != before[i].position || now.rotation != before[i].rotation;
                ++i;
                if (changed) {
                    ASSERT_TRUE(listed.contains(id)) << step << ", body " << id.index;
                } else if (listed.contains(id)) {
                    ASSERT_EQ(world[id].type(), BodyType::Dynamic);
                }
            }
        }
        EXPECT_LT(fewest, 8u); // all boxes came to rest
    }
}

TEST(MovedBodies, LeaveOutWhatWasRemovedOrIsNew) {
    World world({.gravity = support::kEarth});
    EXPECT_TRUE(world.movedBodies().empty());
    const BodyId first = world.add({});
    EXPECT_TRUE(world.movedBodies().empty());
    world.step(kDt);
    EXPECT_EQ(world.movedBodies(), std::vector<BodyId>{first});
    world.remove(first);
    world.add({});
    EXPECT_TRUE(world.movedBodies().empty());
}

// Points turn and shift, vectors only turn.
TEST(BodyFrames, TakePointsAndVectorsToTheWorldAndBack) {
    World world;
    const BodyId id = world.add({.position = {2, 3}, .rotation = Rot{0, 1}}); // a quarter turn
    const BodyView body = world[id];
    EXPECT_EQ(body.toWorld({1, 0}), (Vec2{2, 4}));
    EXPECT_EQ(body.toLocal({2, 4}), (Vec2{1, 0}));
    EXPECT_EQ(body.toWorldVector({1, 0}), (Vec2{0, 1}));
    EXPECT_EQ(body.toLocalVector({0, 1}), (Vec2{1, 0}));
}

TEST(AngularImpulse, ChangesTheSpinAlone) {
    World world;
    const BodyId id = world.add({.shape = Box{2, 1}, .velocity = {1, 2}});
    world[id].applyAngularImpulse(3 * world[id].inertia());
    EXPECT_TRUE(support::near(world[id].angularVelocity(), 3, 1e-6));
    EXPECT_EQ(world[id].velocity(), (Vec2{1, 2}));
    EXPECT_THROW(world[id].applyAngularImpulse(std::numeric_limits<Real>::infinity()),
                 BadDefinition);
}

} // namespace
} // namespace kodo
