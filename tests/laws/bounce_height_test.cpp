// SPDX-License-Identifier: MIT
// B8: a lossless ball keeps its height at any gravity and rate.
#include "support/solver.hpp"
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kodo {
namespace {

struct Fall {
    support::Solver solver;
    int substeps;
    int rate; // Hz
    Real gravity;
};

/// Energy of a ball of radius 0.5 that falls from 5 m, as a height (m): least and largest over a
/// number of steps.
std::pair<Real, Real> heightsOf(const Fall& fall, int steps, const BodyDef& ball) {
    const StepSettings settings =
        support::withSubsteps(support::settingsOf(fall.solver), fall.substeps);
    World world({.gravity = {0, -fall.gravity}, .settings = settings});
    support::addFloor(world, ball.material);
    const BodyId body = world.add(ball);
    std::pair<Real, Real> heights{5, 5};
    for (int i = 0; i < steps; ++i) {
        world.step(Real(1) / static_cast<Real>(fall.rate));
        const Real speed = world[body].velocity().y;
        const Real height = world[body].position().y + speed * speed / (2 * fall.gravity);
        heights = {std::min(heights.first, height), std::max(heights.second, height)};
    }
    return heights;
}

// 6,000 steps are 500 bounces where a step adds 7 m/s to 60 m/s. A step that adds more than half of
// the speed of the impact leaves fewer than three steps for a fall.
TEST(BounceHeight, ALosslessBallKeepsItsHeightAtAnyGravityAndRate) {
    const BodyDef ball = support::ballDef({0, 5}, Real(0.5), support::slippery(1));
    for (const support::Solver solver : support::kSolvers) {
        for (const int substeps : {1, 5}) {
            for (const int rate : {30, 60, 240}) {
                for (const Real gravity : {Real(1.62), Real(10), Real(98), Real(400), Real(1000)}) {
                    const auto [least, most] =
                        heightsOf({solver, substeps, rate, gravity}, 6000, ball);
                    EXPECT_GT(least, Real(4.9)) << static_cast<int>(solver) << ", " << substeps
                                                << ", " << rate << " Hz, g " << gravity;
                    EXPECT_LT(most, Real(5.1)) << static_cast<int>(solver) << ", " << substeps
                                               << ", " << rate << " Hz, g " << gravity;
                }
            }
        }
    }
}

// A box that lands flat has two points, and a ceiling turns a ball back on its way up.
TEST(BounceHeight, ALosslessBoxAndABallUnderACeilingKeepTheirEnergy) {
    BodyDef box = support::boxDef({0, 5}, 1, 1, support::slippery(1));
    box.flags = kLockRotate;
    for (const Real gravity : {Real(98), Real(400)}) {
        const auto [least, most] = heightsOf({support::Solver::Soft, 5, 60, gravity}, 6000, box);
        EXPECT_GT(least, Real(4.9)) << gravity;
        EXPECT_LT(most, Real(5.1)) << gravity;
        World world({.gravity = {0, -gravity}});
        support::addFloor(world, support::slippery(1));
        BodyDef ceiling = support::boxDef({0, 4}, 10, 1, support::slippery(1));
        ceiling.type = BodyType::Static;
        world.add(ceiling);
        BodyDef def = support::ballDef({0, 1}, Real(0.5), support::slippery(1));
        def.velocity = {0, 60};
        const BodyId ball = world.add(def);
        const Real start = gravity * 1 + 60 * 60 / 2;
        support::run(world, 3000);
        const Real speed = world[ball].velocity().y;
        EXPECT_TRUE(support::nearShare(gravity * world[ball].position().y + speed * speed / 2,
                                       start, 0.02L))
            << gravity;
    }
}

} // namespace
} // namespace kodo
