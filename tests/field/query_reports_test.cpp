// SPDX-License-Identifier: MIT
// Reports on queries.
#include <gtest/gtest.h>

#include "field_scene.hpp"

namespace field {
namespace {

// A query for a point finds nothing after a body was moved by hand, until the next step.
// https://github.com/dimforge/rapier/issues/487
TEST(FieldQuery, APointQuerySeesTeleportsAndChangesOfTypeAtOnce) {
    World world;
    const BodyId plate = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
    const auto isAt = [&](Vec2 point) {
        const auto found = kodo::closestPoint(world, point, 0);
        return found && found->body == plate;
    };
    EXPECT_TRUE(isAt({0, 0}));
    for (const BodyType type : {BodyType::Kinematic, BodyType::Dynamic, BodyType::Static}) {
        world[plate].setType(type);
        world[plate].setPosition({7, 3});
        EXPECT_TRUE(isAt({7, 3})) << static_cast<int>(type);
        EXPECT_FALSE(isAt({0, 0})) << static_cast<int>(type);
        world.step(kDt);
        world[plate].setPosition({0, 0});
        EXPECT_TRUE(isAt({0, 0})) << static_cast<int>(type);
    }
}

// A shape query loses a body that it has found if a later candidate does not overlap.
// https://github.com/slembcke/Chipmunk2D/pull/197
TEST(FieldQuery, AShapeQueryKeepsWhatItFoundBeforeACandidateThatMisses) {
    World world;
    const BodyId hit = world.add({.shape = kodo::Circle{1}});
    const BodyId miss = world.add({.shape = kodo::Circle{1}, .position = {2, 2}});
    const kodo::Shape probe = kodo::Box{2, 2};
    EXPECT_EQ(kodo::overlap(world, probe, {{Real(0.2), Real(0.2)}, {}}), std::vector{hit});
    EXPECT_EQ(kodo::overlap(world, probe, {{Real(1.8), Real(1.8)}, {}}), std::vector{miss});
    int visited = 0;
    kodo::visitOverlaps(world, probe, {{1, 1}, {}}, [&](BodyId) { return ++visited < 10; });
    EXPECT_EQ(visited, 2);
}

// A cast ahead of a body misses the wall that the body runs into, above all when it is slow.
// https://github.com/appsinacup/godot-rapier-physics/issues/532
TEST(FieldQuery, ACastAheadSeesTheWallInEveryStepBeforeTheTouch) {
    for (const Real speed : {Real(0.2), Real(3), Real(50)}) {
        World world;
        const BodyId wall =
            world.add({.shape = kodo::Box{1, 10}, .position = {3, 0}, .type = BodyType::Static});
        const BodyId body = world.add({.shape = kodo::Box{1, 1}, .velocity = {speed, 0}});
        for (int i = 0; i < 900; ++i) {
            const Vec2 at = world[body].position();
            const BodyId except[] = {body};
            const auto hit = kodo::shapeCast(world, kodo::Box{1, 1}, {at, {}}, {3, 0}, {}, except);
            ASSERT_TRUE(hit && hit->body == wall) << "speed " << speed << ", step " << i;
            ASSERT_NEAR(hit->fraction * 3, std::max(2 - at.x, Real(0)), 2e-3);
            world.step(kDt);
        }
        EXPECT_LT(world[body].position().x, 2.01);
    }
}

} // namespace
} // namespace field
