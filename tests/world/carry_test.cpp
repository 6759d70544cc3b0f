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

} // namespace
} // namespace kodo
