// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <sandbox.hpp>

namespace {

using namespace destructoooor;
using kodo::Real;

/// Maximum overlap (m) during two seconds, after one second of settling.
Real maxOverlapOf(Scene scene, int collision, int rest, int shock) {
    Sandbox sandbox;
    kodo::StepSettings settings = sandbox.settings();
    settings.propagation().impactPasses = collision;
    settings.propagation().contactPasses = rest;
    settings.propagation().shockPasses = shock;
    settings.leaveOut = kodo::Feature::Sleep;
    sandbox.setSettings(settings);
    sandbox.restart(scene);
    Real maxOverlap = 0;
    for (int step = 0; step < 180; ++step) {
        sandbox.step();
        maxOverlap = step < 60 ? 0 : std::max(maxOverlap, sandbox.measures().maxOverlap);
    }
    return maxOverlap;
}

// A2: shock propagation greatly improves stability even with few iterations.
TEST(Sandbox, ShockPropagationStabilisesATowerWithFewIterations) {
    const Real without = maxOverlapOf(Scene::Tower, 5, 2, 0);
    const Real with = maxOverlapOf(Scene::Tower, 5, 2, 1);
    EXPECT_LT(with, without / 4);
}

// A2: overlap grows with the height of stacks; more collision and rest iterations reduce it.
TEST(Sandbox, MoreIterationsReduceOverlap) {
    const Real few = maxOverlapOf(Scene::Pyramid, 2, 2, 0);
    const Real some = maxOverlapOf(Scene::Pyramid, 10, 10, 0);
    const Real many = maxOverlapOf(Scene::Pyramid, 40, 60, 0);
    EXPECT_LT(some, few);
    EXPECT_LT(many, some / 2);
}

TEST(Sandbox, DropsEveryPrimitiveIntoEveryScene) {
    for (std::size_t scene = 0; scene < kSceneNames.size(); ++scene) {
        Sandbox sandbox;
        sandbox.restart(static_cast<Scene>(scene));
        const std::size_t before = sandbox.measures().bodies;
        for (std::size_t what = 0; what < kPrimitiveNames.size(); ++what) {
            sandbox.drop(static_cast<Primitive>(what), {Real(what) - 1, 14}, 1);
        }
        EXPECT_EQ(sandbox.measures().bodies, before + kPrimitiveNames.size());
        for (int step = 0; step < 60; ++step) {
            sandbox.step();
        }
        EXPECT_GT(sandbox.measures().fastest, 0);
    }
}

TEST(Sandbox, LiveChangesApplyToTheNextScene) {
    Sandbox sandbox;
    kodo::StepSettings settings = sandbox.settings();
    settings.solver = kodo::SoftSettings{.substeps = 7};
    sandbox.setSettings(settings);
    sandbox.setGravity(3);
    sandbox.restart(Scene::Ground);
    EXPECT_EQ(sandbox.world().settings(), settings);
    sandbox.drop(Primitive::Circle, {0, 10}, 1);
    for (int step = 0; step < 60; ++step) {
        sandbox.step();
    }
    EXPECT_NEAR(sandbox.measures().fastest, 3, 0.01); // m/s after one second of 3 m/s^2
}

TEST(Sandbox, ABurstPushesNearbyBodiesOnly) {
    Sandbox sandbox;
    sandbox.restart(Scene::Ground);
    sandbox.setGravity(0);
    sandbox.drop(Primitive::Box, {1, 5}, 1);
    sandbox.drop(Primitive::Box, {-12, 5}, 1);
    sandbox.burst({0, 5});
    const std::vector<kodo::BodyId> bodies = sandbox.world().bodies();
    EXPECT_GT(sandbox.world()[bodies[1]].velocity().x, 5);
    EXPECT_EQ(sandbox.world()[bodies[2]].velocity(), (kodo::Vec2{}));
}

} // namespace
