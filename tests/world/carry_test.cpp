// SPDX-License-Identifier: MIT
// Manifolds are kept from step to step while their bodies have not gone far against each other.
// What changes a body between steps must break that.
#include <support/near.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

namespace kodo {
namespace {

/// A box that has stood on the ground for a second.
struct Standing {
    World world = World({.gravity = support::kEarth});
    BodyId floor = world.add({.shape = Box{20, 1}, .position = {0, Real(-0.5)}, .flags = kLocked});
    BodyId box = world.add(support::boxDef({0, Real(0.5)}, 1, 1));

    Standing() { support::run(world, 60); }
};

// However often it is put elsewhere between two steps: what was known of it is out of date.
TEST(Carry, EndsForWhatIsPutElsewhereSeveralTimes) {
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

// A new mass, or none: the lanes of the solver hold no old one.
TEST(Carry, EndsForWhatIsLockedAndSetFree) {
    Standing scene;
    const BodyId top = scene.world.add(support::boxDef({0, Real(1.5)}, 1, 1));
    support::run(scene.world, 60);
    scene.world[scene.box].setFlags(kLocked);
    scene.world.remove(scene.floor);
    support::run(scene.world, 60);
    EXPECT_EQ(scene.world[scene.box].velocity(), Vec2{});
    EXPECT_TRUE(
        support::near(scene.world[top].position().y, Real(1.5), scene.world.tolerances().slop));
    scene.world[scene.box].setFlags(0);
    scene.world.step(support::kDt);
    for (const BodyId body : {scene.box, top}) { // both fall freely, and do not push each other
        EXPECT_TRUE(support::near(scene.world[body].velocity().y, support::kEarth.y * support::kDt,
                                  Real(0.01)));
    }
}

// A pile on a platform that goes up and down as a whole keeps its manifolds: it stays as it is.
TEST(Carry, GoesOnInWhatMovesAsAWhole) {
    World world({.gravity = support::kEarth,
                 .settings = {.leaveOut = static_cast<std::uint8_t>(Feature::Resting)}});
    const BodyId platform = world.add({.shape = Box{4, 1}, .flags = kLocked});
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

/// What is read from bytes has no lanes yet; it must go on as what has.
void expectToGoOnAlike(World& world) {
    World read = fromBytes(toBytes(world));
    for (int step = 0; step < 90; ++step) {
        world.step(support::kDt);
        read.step(support::kDt);
        ASSERT_EQ(read.stateHash(), world.stateHash()) << "step " << step;
    }
}

// Settings that change in the middle of a slide act at once, and on all that the solver keeps.
TEST(Carry, HearsOfNewSettings) {
    StepSettings off;
    off.leaveOut = static_cast<std::uint8_t>(Feature::Friction);
    StepSettings rolling;
    rolling.leaveOut = static_cast<std::uint8_t>(Feature::RollingResistance);
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
            def.flags = kNeverRest;
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

// More contacts than there are colours: one body on forty pieces of ground, another among forty
// that can be pushed.
TEST(Carry, GoesOnAlikeWhereColoursRunOut) {
    World world({.gravity = support::kEarth});
    for (int i = 0; i < 40; ++i) {
        world.add({.shape = Box{1, 1},
                   .position = {Real(1.3) * static_cast<Real>(i), Real(-0.5)},
                   .flags = kLocked});
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
