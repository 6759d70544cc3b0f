// SPDX-License-Identifier: MIT
// B6: an island sleeps only if it would stay as it is. Bodies slightly off their balance move by
// less than a slop for a long time, but they move.
#include "support/solver.hpp"
#include <support/sleeping.hpp>

#include <cmath>
#include <functional>

namespace kodo {
namespace {

using support::isAsleep;

struct Case {
    support::Solver solver;
    int rate; // Hz
    Real dt() const { return Real(1) / static_cast<Real>(rate); }
};

/// Calls test(case) for both solvers and three rates.
void forEachCase(const std::function<void(const Case&)>& test) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 240}) {
            SCOPED_TRACE(testing::Message()
                         << "solver " << static_cast<int>(solver) << ", " << rate << " Hz");
            test({solver, rate});
        }
    }
}

World worldOf(const Case& row) {
    return World({.gravity = support::kEarth, .settings = support::settingsOf(row.solver)});
}

/// Steps until done(body) or for `seconds`. True if the body fell asleep before.
template <typename Done>
bool sleepsBefore(World& world, BodyId body, const Case& row, int seconds, Done done) {
    for (int i = 0; i < seconds * row.rate && !done(world[body]); ++i) {
        world.step(row.dt());
        if (isAsleep(world, body)) {
            return true;
        }
    }
    return false;
}

TEST(SleepMotion, ASeeSawOffItsBalanceTips) {
    forEachCase([](const Case& row) {
        for (const Real length : {Real(2), Real(6)}) {
            for (const Real off : {Real(-1e-3), Real(1e-3), Real(3e-4)}) {
                World world = worldOf(row);
                world.add(
                    {.shape = Polygon{{{-1, -1}, {1, -1}, {0, 0}}}, .type = BodyType::Static});
                const BodyId plank =
                    world.add(support::boxDef({off, Real(0.05)}, length, Real(0.1)));
                EXPECT_FALSE(sleepsBefore(
                    world, plank, row, 10,
                    [](const BodyView& body) { return std::abs(body.rotation().s) > Real(0.05); }))
                    << length << ", " << off;
                EXPECT_GT(std::abs(world[plank].rotation().s), Real(0.05)) << length << ", " << off;
            }
        }
    });
}

// It lies on two points: the end on the table, and the edge. Its centre is beyond the edge.
TEST(SleepMotion, APlankWhoseCentreIsBeyondTheEdgeOfATableTips) {
    forEachCase([](const Case& row) {
        for (const Real length : {Real(1), Real(2), Real(6)}) {
            for (const Real off : {Real(1e-3), Real(3e-4)}) {
                World world = worldOf(row);
                world.add(
                    {.shape = Box{8, 1}, .position = {-4, Real(-0.5)}, .type = BodyType::Static});
                const BodyId plank =
                    world.add(support::boxDef({off, Real(0.05)}, length, Real(0.1)));
                EXPECT_FALSE(sleepsBefore(
                    world, plank, row, 15,
                    [](const BodyView& body) { return std::abs(body.rotation().s) > Real(0.05); }))
                    << length << ", " << off;
                EXPECT_GT(std::abs(world[plank].rotation().s), Real(0.05)) << length << ", " << off;
            }
        }
    });
}

// The load is off the balance, not the plank, which lies on an edge of 0.1 m.
TEST(SleepMotion, ALoadedSeeSawOffItsBalanceTips) {
    forEachCase([](const Case& row) {
        World world = worldOf(row);
        world.add({.shape = Polygon{{{-1, -1}, {1, -1}, {Real(0.05), 0}, {Real(-0.05), 0}}},
                   .type = BodyType::Static});
        const BodyId plank = world.add(support::boxDef({0, Real(0.05)}, 6, Real(0.1)));
        BodyDef load = support::boxDef({-2, Real(0.35)}, Real(0.5), Real(0.5));
        load.density = 40;
        world.add(load);
        load.position.x = Real(2.2); // the weights' centre is 0.1 m off: outside the edge
        world.add(load);
        EXPECT_FALSE(sleepsBefore(world, plank, row, 10, [](const BodyView& body) {
            return std::abs(body.rotation().s) > Real(0.05);
        }));
    });
}

TEST(SleepMotion, ADiscOffTheTopOfADiscRollsDown) {
    forEachCase([](const Case& row) {
        for (const Real off : {Real(3e-4), Real(-3e-4), Real(1e-4)}) {
            World world = worldOf(row);
            world.add({.shape = Circle{1}, .type = BodyType::Static});
            const Vec2 place = Real(1.5) * Vec2{std::sin(off), std::cos(off)};
            const BodyId disc = world.add(support::ballDef(place, Real(0.5)));
            EXPECT_FALSE(sleepsBefore(world, disc, row, 20, [](const BodyView& body) {
                return body.position().y < 1;
            })) << off;
            EXPECT_LT(world[disc].position().y, 1) << off;
        }
    });
}

/// A pendulum without damping, let go at an angle (rad).
BodyId addPendulum(World& world, Real length, Real angle) {
    const BodyId hook = world.add(
        {.shape = Box{Real(0.1), Real(0.1)}, .type = BodyType::Static, .flags = kDisabled});
    BodyDef def = support::ballDef(length * Vec2{std::sin(angle), -std::cos(angle)}, Real(0.1));
    const BodyId bob = world.add(def);
    RevoluteJoint joint;
    joint.ends.a = hook;
    joint.ends.b = bob;
    joint.ends.anchorB = -def.position;
    world.add(joint);
    return bob;
}

TEST(SleepMotion, APendulumOfAThousandthKeepsSwinging) {
    forEachCase([](const Case& row) {
        for (const Real length : {Real(0.25), Real(1), Real(10)}) {
            World world = worldOf(row);
            const BodyId bob = addPendulum(world, length, Real(1e-3));
            EXPECT_FALSE(sleepsBefore(world, bob, row, 20, [](const BodyView&) { return false; }))
                << length;
        }
    });
}

// One that is at rest sleeps, and so do a disc on the top, and a plank on its balance.
TEST(SleepMotion, WhatIsInBalanceSleeps) {
    forEachCase([](const Case& row) {
        World world = worldOf(row);
        const BodyId bob = addPendulum(world, 1, 0);
        world.add({.shape = Polygon{{{9, -1}, {11, -1}, {10, 0}}}, .type = BodyType::Static});
        const BodyId plank = world.add(support::boxDef({10, Real(0.05)}, 2, Real(0.1)));
        const auto never = [](const BodyView&) { return false; };
        EXPECT_TRUE(sleepsBefore(world, bob, row, 3, never));
        EXPECT_TRUE(isAsleep(world, plank) || sleepsBefore(world, plank, row, 3, never));
    });
}

// Contacts settle as springs, so a body that lies on a base may move a little when it falls asleep.
TEST(SleepMotion, AStackOfTwentySleepsWithinASecondAndAPyramidWithinThree) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    const std::vector<BodyId> stack = support::addStack(world, 20);
    EXPECT_LT(support::stepsUntilAsleep(world, stack[0], 120), 60);
    World other({.gravity = support::kEarth});
    support::addFloor(other);
    BodyId top;
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 10 - row; ++i) {
            const Real x = static_cast<Real>(i) + static_cast<Real>(row) / 2;
            top = other.add(support::boxDef({x, static_cast<Real>(row) + Real(0.5)}, 1, 1));
        }
    }
    EXPECT_LT(support::stepsUntilAsleep(other, top, 240), 180);
}

} // namespace
} // namespace kodo
