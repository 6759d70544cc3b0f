// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace kodo {
namespace {

const std::vector<StepSettings> kImpactSolvers{{}, thesis2006()};

// B1: a paddle that moves farther in a step than it is thick. No ball ends up behind it, whatever
// the restitution e and the place of the ball in the step, and it leaves at (1 + e) times the
// speed.
TEST(KinematicImpact, AFastPaddlePassesThroughNoBall) {
    for (const StepSettings& settings : kImpactSolvers) {
        for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
            for (const Real speed : {Real(10), Real(40), Real(100)}) {
                for (const Real rate : {Real(60), Real(144)}) {
                    const Material material = withFriction(Real(0.3), restitution);
                    for (int i = 0; i < 40; ++i) {
                        World world({.settings = settings});
                        const BodyId paddle = world.add({.shape = Box{Real(0.2), 2},
                                                         .velocity = {speed, 0},
                                                         .material = material,
                                                         .type = BodyType::Kinematic});
                        const Real start = 1 + static_cast<Real>(i) * speed / rate / 40;
                        BodyDef def = support::ballDef({start, Real(0.3)}, Real(0.1), material);
                        const BodyId ball = world.add(def);
                        support::run(world, 60, 1 / rate);
                        ASSERT_GT(world[ball].position().x, world[paddle].position().x)
                            << "e " << restitution << ", " << speed << " m/s, place " << i;
                        ASSERT_NEAR(world[ball].velocity().x, speed * (1 + restitution),
                                    speed / 1000);
                    }
                }
            }
        }
    }
}

// B1: a bar that turns by up to 2 rad in a step about its middle hits a ball at each place that it
// passes over.
TEST(KinematicImpact, AFastBarHitsEachBallInItsWay) {
    for (const StepSettings& settings : kImpactSolvers) {
        for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
            for (const Real turn : {Real(0.6), Real(1), Real(2)}) { // rad per step
                const Material material = withFriction(Real(0.3), restitution);
                for (int i = 0; i < 60; ++i) {
                    World world({.settings = settings});
                    world.add({.shape = Box{4, Real(0.1)},
                               .angularVelocity = turn / support::kDt,
                               .material = material,
                               .type = BodyType::Kinematic});
                    const Real angle = Real(0.3) + Real(0.045) * static_cast<Real>(i);
                    const Vec2 place = Real(1.5) * Vec2{std::cos(angle), std::sin(angle)};
                    const BodyId ball = world.add(support::ballDef(place, Real(0.1), material));
                    support::run(world, static_cast<int>(Real(3.2) / turn) + 1);
                    ASSERT_GT(length(world[ball].position() - place), Real(0.01))
                        << "e " << restitution << ", " << turn << " rad, place " << i;
                }
            }
        }
    }
}

} // namespace
} // namespace kodo
