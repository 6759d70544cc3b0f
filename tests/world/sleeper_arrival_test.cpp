// SPDX-License-Identifier: MIT
// What arrives beside a sleeping body that it does not wake: the contact waits with the sleeper.
#include <kodo/snapshot.hpp>
#include <support/sleeping.hpp>
#include <support/solver.hpp>

#include <array>
#include <functional>
#include <string>

namespace kodo {
namespace {

using support::boxDef;
using support::kDt;
using support::kSolvers;

/// A box that sleeps on a static one, with a body elsewhere that may arrive.
struct Sleeper {
    World world;
    BodyId box, arrival;

    explicit Sleeper(support::Solver solver)
        : world({.gravity = support::kEarth, .settings = support::settingsOf(solver)}) {
        BodyDef floor = boxDef({0, Real(-0.5)}, 3, 1);
        floor.type = BodyType::Static;
        world.add(floor);
        box = world.add(boxDef({0, Real(0.5)}, 1, 1));
        BodyDef other = boxDef({-50, 1}, 2, Real(0.5)); // above the floor
        other.type = BodyType::Static;
        other.flags = kSensor;
        arrival = world.add(other);
        support::run(world, 120);
        EXPECT_TRUE(support::isAsleep(world, box));
    }
    int records() const {
        int count = 0;
        for (const CollisionRecord& record : world.collisions()) {
            count += record.involves(box) ? 1 : 0;
        }
        return count;
    }
};

struct Arrival {
    std::string_view name;
    std::function<void(Sleeper&)> act;
};

const std::array<Arrival, 5> kArrivals = {{
    {"teleported",
     [](Sleeper& s) {
         s.world[s.arrival].setPosition({0, 1});
     }},
    {"added",
     [](Sleeper& s) {
         BodyDef def = boxDef({0, 1}, 2, Real(0.5));
         def.type = BodyType::Static;
         def.flags = kSensor;
         s.arrival = s.world.add(def);
     }},
    {"enabled",
     [](Sleeper& s) {
         s.world[s.arrival].setFlags(kSensor | kDisabled);
         s.world[s.arrival].setPosition({0, 1});
         s.world.step(kDt);
         s.world[s.arrival].setFlags(kSensor);
     }},
    {"slid in",
     [](Sleeper& s) {
         s.world[s.arrival].setType(BodyType::Kinematic);
         s.world[s.arrival].setVelocity({50, 0});
         support::run(s.world, 60);
         s.world[s.arrival].setVelocity({0, 0});
     }},
    {"beside it, and moved on",
     [](Sleeper& s) {
         s.world[s.arrival].setPosition({Real(1.51), 1});
         s.world.step(kDt);
         s.world[s.arrival].setPosition({0, 1});
     }},
}};

/// Calls test(sleeper, arrival) for each arrival with each solver.
template <typename Test>
void forEachArrival(Test test) {
    for (const support::Solver solver : kSolvers) {
        for (const Arrival& arrival : kArrivals) {
            SCOPED_TRACE(arrival.name);
            Sleeper sleeper(solver);
            test(sleeper, arrival);
        }
    }
}

// Regression: a contact with what arrived later stayed in the list of each step, with a Persist,
// until the body woke.
TEST(SleeperArrival, OfASensorIsToldOnceAndCostsNoFurtherStep) {
    forEachArrival([](Sleeper& sleeper, const Arrival& arrival) {
        World& world = sleeper.world;
        arrival.act(sleeper);
        support::run(world, 2);
        for (int step = 0; step < 60; ++step) {
            world.step(kDt);
            EXPECT_EQ(sleeper.records(), 0) << step;
            EXPECT_TRUE(world.endedCollisions().empty());
        }
        EXPECT_TRUE(support::isAsleep(world, sleeper.box));
        world[sleeper.box].wake();
        world.step(kDt);
        EXPECT_EQ(sleeper.records(), 2) << "it still touches the floor and the sensor";
    });
}

TEST(SleeperArrival, OfASensorBeginsOnceAndEndsWithoutWaking) {
    forEachArrival([](Sleeper& sleeper, const Arrival& arrival) {
        World& world = sleeper.world;
        std::size_t begins = 0;
        if (arrival.name == "slid in") {
            world[sleeper.arrival].setType(BodyType::Kinematic);
            world[sleeper.arrival].setVelocity({50, 0});
            for (int step = 0; step < 60; ++step) {
                world.step(kDt);
                begins += world.begunCollisions().size();
            }
            world[sleeper.arrival].setVelocity({0, 0});
        } else {
            arrival.act(sleeper);
        }
        for (int step = 0; step < 10; ++step) {
            world.step(kDt);
            begins += world.begunCollisions().size();
        }
        EXPECT_EQ(begins, 1u);
        world[sleeper.arrival].setPosition({50, 1});
        world.step(kDt);
        EXPECT_EQ(world.endedCollisions().size(), 1u);
        EXPECT_TRUE(support::isAsleep(world, sleeper.box));
    });
}

// A wall within the margin does not touch the box; it is beside it when it wakes.
TEST(SleeperArrival, OfAWallThatDoesNotTouchIsKnownAfterWaking) {
    for (const support::Solver solver : kSolvers) {
        Sleeper sleeper(solver);
        World& world = sleeper.world;
        BodyDef wall = boxDef({1, Real(0.5)}, Real(0.98), 1); // 10 mm beside it
        wall.type = BodyType::Static;
        world.add(wall);
        support::run(world, 30);
        EXPECT_TRUE(support::isAsleep(world, sleeper.box));
        world[sleeper.box].setVelocity({1, 0});
        support::run(world, 60);
        EXPECT_NEAR(world[sleeper.box].position().x, 0.01, 0.02) << "it stopped at the wall";
    }
}

TEST(SleeperArrival, IsTheSameInACopyAndFromBytesAtEachStep) {
    forEachArrival([](Sleeper& sleeper, const Arrival& arrival) {
        World& world = sleeper.world;
        arrival.act(sleeper);
        for (int step = 0; step < 4; ++step) {
            World copy = world;
            World read = fromBytes(toBytes(world));
            world.step(kDt);
            copy.step(kDt);
            read.step(kDt);
            ASSERT_EQ(copy.stateHash(), world.stateHash()) << step;
            ASSERT_EQ(read.stateHash(), world.stateHash()) << step;
            ASSERT_EQ(toBytes(copy), toBytes(world)) << step;
            ASSERT_EQ(toBytes(read), toBytes(world)) << step;
            ASSERT_EQ(read.collisions().size(), world.collisions().size()) << step;
        }
    });
}

} // namespace
} // namespace kodo
