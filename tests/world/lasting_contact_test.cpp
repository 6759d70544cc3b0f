// SPDX-License-Identifier: MIT
// Contacts keep manifold and lane across steps while the relative displacement of their
// bodies is small, and follow each change of a body between steps.
#include <support/near.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

namespace kodo {
namespace {

/// A box that has stood on the ground for 1 s.
struct Standing {
    World world = World({.gravity = support::kEarth});
    BodyId floor =
        world.add({.shape = Box{20, 1}, .position = {0, Real(-0.5)}, .type = BodyType::Kinematic});
    BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));

    Standing() { support::run(world, 60); }
};

// Any number of teleports between two steps discards the manifold.
TEST(LastingContact, IsFoundAgainAfterAnyNumberOfTeleports) {
    for (int times = 1; times <= 8; ++times) {
        SCOPED_TRACE(times);
        Standing scene;
        for (int i = 0; i < times; ++i) {
            scene.world[scene.box].setPosition({Real(i), 5});
        }
        scene.world.step(support::kDt);
        const Vec2 velocity = scene.world[scene.box].velocity();
        EXPECT_TRUE(support::near(velocity.y, support::kEarth.y * support::kDt, Real(1e-4)));
        ASSERT_EQ(scene.world.collisions().size(), 1u);
        EXPECT_EQ(scene.world.collisions()[0].phase, TouchPhase::End);
    }
}

// The inverse mass in the lanes changes with the body type: 0 while kinematic, the old value
// afterwards.
TEST(LastingContact, TakesOverAChangedBodyType) {
    Standing scene;
    const BodyId top = scene.world.add(support::boxDef({0, Real(1.5)}, 1, 1));
    support::run(scene.world, 60);
    scene.world[scene.box].setType(BodyType::Kinematic);
    scene.world.remove(scene.floor);
    support::run(scene.world, 60);
    EXPECT_EQ(scene.world[scene.box].velocity(), Vec2{});
    EXPECT_TRUE(
        support::near(scene.world[top].position().y, Real(1.5), scene.world.tolerances().slop));
    scene.world[scene.box].setType(BodyType::Dynamic);
    scene.world.step(support::kDt);
    for (const BodyId body : {scene.box, top}) { // both in free fall, without impulses between them
        EXPECT_TRUE(support::near(scene.world[body].velocity().y, support::kEarth.y * support::kDt,
                                  Real(0.01)));
    }
}

// A stack that moves as a whole with its platform keeps its manifolds and its shape.
TEST(LastingContact, StaysWhileAStackMovesAsAWhole) {
    World world({.gravity = support::kEarth, .settings = {.leaveOut = Feature::Sleep}});
    const BodyId platform = world.add({.shape = Box{4, 1}, .type = BodyType::Kinematic});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 5; ++i) {
        boxes.push_back(world.add(support::boxDef({0, 1 + static_cast<Real>(i)}, 1, 1)));
    }
    for (int i = 0; i < 1200; ++i) {
        world[platform].moveTo({Real(0.005) * static_cast<Real>(i), 0}, support::kDt);
        world.step(support::kDt);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Vec2 offset = world[boxes[i]].position() - world[platform].position();
        EXPECT_TRUE(support::near(offset.y, 1 + static_cast<Real>(i), Real(0.02)));
        EXPECT_TRUE(support::near(world[boxes[i]].velocity().x, Real(0.3), Real(0.01)));
    }
}

/// A restored World has no lane in the passes yet. It must continue with the same bits.
void expectToGoOnAlike(World& world) {
    World read = fromBytes(toBytes(world));
    for (int step = 0; step < 90; ++step) {
        world.step(support::kDt);
        read.step(support::kDt);
        ASSERT_EQ(read.stateHash(), world.stateHash()) << "step " << step;
    }
}

// A change of settings during a slide applies at once, also to contacts with a lane.
TEST(LastingContact, AppliesNewSettingsAtOnce) {
    StepSettings off;
    off.leaveOut = Feature::Friction;
    StepSettings rolling;
    rolling.leaveOut = Feature::RollingResistance;
    for (const StepSettings& settings : {off, rolling, thesis2006()}) {
        World world({.gravity = {3, -10}});
        support::addFloor(world);
        Material rough = withFriction(Real(0.6));
        rough.rollingResistance = Real(0.1);
        std::vector<BodyId> bodies;
        for (int i = 0; i < 6; ++i) {
            BodyDef def = support::boxDef({2 * static_cast<Real>(i), Real(0.5)}, 1, 1);
            def.shape = i % 2 == 0 ? Shape(Box{1, 1}) : Shape(Circle{Real(0.5)});
            def.material = rough;
            def.flags = kNeverSleep;
            bodies.push_back(world.add(def));
        }
        support::run(world, 20);
        world.setSettings(settings);
        expectToGoOnAlike(world);
        if (settings.leaveOut == off.leaveOut) { // 3 m/s^2 for 1.5 s
            EXPECT_TRUE(support::near(world[bodies[0]].velocity().x, Real(4.5), Real(0.2)));
        }
        world.setSettings({});
        expectToGoOnAlike(world);
    }
}

// More contacts than colours: one box lies on 40 pieces of ground and carries 70 dynamic boxes.
TEST(LastingContact, ContinuesWithTheSameBitsWithoutAFreeColour) {
    World world({.gravity = support::kEarth});
    for (int i = 0; i < 40; ++i) {
        world.add({.shape = Box{1, 1},
                   .position = {Real(1.3) * static_cast<Real>(i), Real(-0.5)},
                   .type = BodyType::Kinematic});
    }
    world.add(support::boxDef({Real(25.5), Real(0.5)}, 54, 1));
    for (int i = 0; i < 70; ++i) {
        world.add(
            support::boxDef({Real(0.7) * static_cast<Real>(i), Real(1.3)}, Real(0.6), Real(0.6)));
    }
    support::run(world, 30);
    expectToGoOnAlike(world);
}

} // namespace
} // namespace kodo
