// SPDX-License-Identifier: MIT
// B7: a one-sided line lets a body of several parts through as a whole.
#include "support/solver.hpp"
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace kodo {
namespace {

/// A figure 1.8 m high, with its centre at the position: circle, box, circle.
BodyDef heroDef(Vec2 position) {
    BodyDef def;
    def.shape = Compound{{Circle{Real(0.3), {0, Real(-0.6)}}, Box{Real(0.6), Real(1.2)},
                          Circle{Real(0.3), {0, Real(0.6)}}}};
    def.position = position;
    def.flags = kNeverSleep | kLockRotate;
    return def;
}

/// Two balls 2 m apart, one above the other.
BodyDef barbellDef(Vec2 position) {
    BodyDef def = heroDef(position);
    def.shape = Compound{{Circle{Real(0.3), {0, -1}}, Circle{Real(0.3), {0, 1}}}};
    return def;
}

World worldWith(support::Solver solver, Real y) {
    World world({.gravity = support::kEarth, .settings = support::settingsOf(solver)});
    support::addFloor(world);
    world.add({.shape = Segment{.from = {-2, 0}, .to = {2, 0}, .oneSided = true},
               .position = {0, y},
               .type = BodyType::Static});
    return world;
}

/// Lowest point (m) of the body after a jump with this speed (m/s) from the floor, and 2 s.
Real feetAfterJump(World& world, const BodyDef& def, Real feet, Real speed, int rate) {
    const BodyId hero = world.add(def);
    world[hero].setVelocity({0, speed});
    for (int i = 0; i < 2 * rate; ++i) {
        world.step(Real(1) / static_cast<Real>(rate));
    }
    return world[hero].position().y - feet;
}

TEST(OneWayBody, AFigureThatJumpsTooLowFallsBackThroughTheLedge) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 240}) {
            for (const Real reach : {Real(0.3), Real(0.9), Real(1.3)}) { // of the feet
                const Real speed = std::sqrt(20 * reach);
                World world = worldWith(solver, Real(1.5));
                EXPECT_LT(feetAfterJump(world, heroDef({0, Real(0.9)}), Real(0.9), speed, rate),
                          Real(0.02))
                    << static_cast<int>(solver) << ", " << rate << ", " << reach;
            }
            World world = worldWith(solver, Real(1.5));
            EXPECT_LT(feetAfterJump(world, barbellDef({0, Real(1.3)}), Real(1.3), 5, rate),
                      Real(0.02))
                << static_cast<int>(solver) << ", " << rate;
        }
    }
}

TEST(OneWayBody, AFigureThatJumpsHighEnoughLandsOnTheLedge) {
    for (const support::Solver solver : support::kSolvers) {
        for (const int rate : {30, 60, 240}) {
            World world = worldWith(solver, Real(1.5));
            EXPECT_TRUE(support::near(
                feetAfterJump(world, heroDef({0, Real(0.9)}), Real(0.9), 8, rate), 1.5, 0.02))
                << static_cast<int>(solver) << ", " << rate;
            World other = worldWith(solver, Real(1.5));
            EXPECT_TRUE(support::near(
                feetAfterJump(other, barbellDef({0, Real(1.3)}), Real(1.3), 8, rate), 1.5, 0.02))
                << static_cast<int>(solver) << ", " << rate;
        }
    }
}

// What stands on the line stays there, wherever its other parts are, also in a copy and a snapshot.
TEST(OneWayBody, AFigureThatStandsStays) {
    for (const support::Solver solver : support::kSolvers) {
        World world = worldWith(solver, Real(1.5));
        const BodyId hero = world.add(heroDef({0, Real(2.4)}));
        support::run(world, 60);
        World copy = fromBytes(toBytes(world));
        support::run(copy, 60);
        support::run(world, 60);
        EXPECT_TRUE(support::near(world[hero].position().y, 2.4, 0.01));
        EXPECT_EQ(world.stateHash(), copy.stateHash());
    }
}

} // namespace
} // namespace kodo
