// SPDX-License-Identifier: MIT
// Reports on events, kinematic bodies and casts.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "field_scene.hpp"

namespace field {
namespace {

using kodo::CollisionRecord;

/// Begins and ends of the last step that concern a body.
struct Events {
    int begun = 0;
    int ended = 0;
};
Events eventsOf(const World& world, BodyId body) {
    Events events;
    for (const CollisionRecord& record : world.begunCollisions()) {
        events.begun += record.involves(body) ? 1 : 0;
    }
    for (const CollisionRecord& record : world.endedCollisions()) {
        events.ended += record.involves(body) ? 1 : 0;
    }
    return events;
}

// A sensor is told that a body has left it when the body falls asleep inside.
// https://github.com/godotengine/godot/issues/23590 https://github.com/avianphysics/avian/pull/112
TEST(FieldEvents, ABodyThatFallsAsleepInASensorHasNotLeftIt) {
    World world = underGravity();
    addGround(world);
    const BodyId zone = world.add({.shape = kodo::Box{4, 4},
                                   .position = {0, 2},
                                   .type = BodyType::Static,
                                   .flags = kodo::kSensor});
    const BodyId box = world.add({.shape = kodo::Box{1, 1}, .position = {0, 3}});
    Events all;
    for (int i = 0; i < 300; ++i) {
        world.step(kDt);
        const Events now = eventsOf(world, zone);
        all = {all.begun + now.begun, all.ended + now.ended};
    }
    ASSERT_TRUE(world[box].isAsleep());
    EXPECT_EQ(all.begun, 1);
    EXPECT_EQ(all.ended, 0);
    world[box].setVelocity({6, 0}); // wakes it: no second begin
    world.step(kDt);
    EXPECT_EQ(eventsOf(world, zone).begun, 0);
    run(world, 3);
    EXPECT_GT(world[box].position().x, 2.5);
}

// The end of a contact is not told if one of the bodies is removed in the step after its begin.
// https://github.com/avianphysics/avian/issues/348 https://github.com/avianphysics/avian/issues/533
TEST(FieldEvents, EachBeginHasItsEndHoweverSoonABodyIsRemoved) {
    for (int later = 0; later < 4; ++later) {
        World world = underGravity();
        const BodyId ground = addGround(world);
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.5)}, .position = {0, 1}});
        int steps = 0;
        while (eventsOf(world, ball).begun == 0 && steps++ < 60) {
            world.step(kDt);
        }
        ASSERT_EQ(eventsOf(world, ball).begun, 1);
        for (int i = 0; i < later; ++i) {
            world.step(kDt);
        }
        world.remove(ball);
        world.step(kDt);
        ASSERT_EQ(world.endedCollisions().size(), 1u) << later;
        EXPECT_TRUE(world.endedCollisions()[0].involves(ground));
        EXPECT_TRUE(world.endedCollisions()[0].involves(ball));
        world.step(kDt);
        EXPECT_EQ(world.endedCollisions().size(), 0u);
    }
}

// After a body is removed from a sensor, ends are missing or name other bodies.
// https://github.com/dimforge/rapier/issues/330
TEST(FieldEvents, ARemovedBodyEndsItsOwnContactsWithASensorAlone) {
    World world;
    const BodyId zone =
        world.add({.shape = kodo::Box{10, 2}, .type = BodyType::Static, .flags = kodo::kSensor});
    std::vector<BodyId> balls;
    for (int i = 0; i < 5; ++i) {
        balls.push_back(world.add({.shape = kodo::Circle{Real(0.5)},
                                   .position = {Real(1.5) * static_cast<Real>(i - 2), 0}}));
    }
    world.step(kDt);
    ASSERT_EQ(world.begunCollisions().size(), 5u);
    world.remove(balls[3]);
    world.remove(balls[1]);
    world.step(kDt);
    ASSERT_EQ(world.endedCollisions().size(), 2u);
    for (const CollisionRecord& record : world.endedCollisions()) {
        EXPECT_TRUE(record.involves(zone));
        EXPECT_TRUE(record.involves(balls[1]) || record.involves(balls[3]));
    }
}

// A body that is disabled and enabled again causes no event at a sensor any more.
// https://github.com/avianphysics/avian/issues/786
TEST(FieldEvents, ABodyThatIsDisabledAndEnabledEndsAndBeginsItsContact) {
    World world;
    const BodyId zone =
        world.add({.shape = kodo::Box{2, 2}, .type = BodyType::Static, .flags = kodo::kSensor});
    const BodyId cube = world.add({.shape = kodo::Box{1, 1}});
    world.step(kDt);
    ASSERT_EQ(eventsOf(world, zone).begun, 1);
    for (const int pause : {0, 1, 100}) { // steps between both, 100: the cube falls asleep before
        run(world, static_cast<Real>(pause) * kDt);
        world[cube].setFlags(kodo::kDisabled);
        world.step(kDt);
        EXPECT_EQ(eventsOf(world, zone).ended, 1) << pause;
        run(world, static_cast<Real>(pause) * kDt);
        world[cube].setFlags(0);
        world.step(kDt);
        EXPECT_EQ(eventsOf(world, zone).begun, 1) << pause;
    }
    world[cube].setFlags(kodo::kDisabled); // and back before a step has seen it
    world[cube].setFlags(0);
    world.step(kDt);
    EXPECT_EQ(eventsOf(world, zone).begun, eventsOf(world, zone).ended);
}

// A static body that appears in a sleeping one has no contact with it, and does not wake it.
// https://github.com/erincatto/box2d/issues/227
TEST(FieldEvents, AStaticBodyThatIsAddedInASleepingOneTouchesIt) {
    World world;
    const BodyId box = world.add({.shape = kodo::Box{1, 1}});
    run(world, 2);
    ASSERT_TRUE(world[box].isAsleep());
    const BodyId wall =
        world.add({.shape = kodo::Box{1, 1}, .position = {Real(0.9), 0}, .type = BodyType::Static});
    world.step(kDt);
    EXPECT_FALSE(world[box].isAsleep());
    EXPECT_EQ(eventsOf(world, wall).begun, 1);
    run(world, 2);
    EXPECT_LT(world[box].position().x, -0.09); // apart, up to the slop
}

// A static block reports no touch.
// https://github.com/godotengine/godot/issues/54790
TEST(FieldEvents, StaticAndKinematicBlocksReportTheBallThatHitsThem) {
    for (const BodyType type : {BodyType::Static, BodyType::Kinematic}) {
        World world = underGravity();
        const BodyId block = world.add({.shape = kodo::Box{2, 1}, .type = type});
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.5)}, .position = {0, 3}});
        int begun = 0;
        for (int i = 0; i < 90; ++i) {
            world.step(kDt);
            for (const CollisionRecord& hit : world.hits(1)) {
                EXPECT_TRUE(hit.involves(block) && hit.involves(ball));
                EXPECT_NEAR(hit.totalImpulse, world[ball].mass() * std::sqrt(Real(40)), 0.3);
            }
            begun += eventsOf(world, block).begun;
        }
        EXPECT_EQ(begun, 1);
    }
}

// Half of the collisions of balls that are dropped on balls are not reported.
// https://github.com/appsinacup/godot-box2d/issues/81
TEST(FieldEvents, EachBallThatIsDroppedOnAnotherIsReported) {
    for (int i = 0; i < 50; ++i) {
        World world = underGravity();
        addGround(world);
        const BodyId low =
            world.add({.shape = kodo::Circle{Real(0.5)}, .position = {0, Real(0.5)}});
        const BodyId high = world.add({.shape = kodo::Circle{Real(0.3)},
                                       .position = {Real(0.012) * static_cast<Real>(i - 25),
                                                    2 + Real(0.05) * static_cast<Real>(i)}});
        int reports = 0;
        for (int k = 0; k < 120; ++k) {
            world.step(kDt);
            for (const CollisionRecord& record : world.begunCollisions()) {
                reports += record.involves(low) && record.involves(high) ? 1 : 0;
            }
        }
        EXPECT_GE(reports, 1) << "drop " << i;
    }
}

// A box on a platform that sinks gains speed without end.
// https://github.com/erincatto/box2d/issues/130
TEST(FieldEvents, ABoxOnASinkingPlatformHasItsSpeed) {
    for (const Real speed : {Real(0.5), Real(2), Real(9)}) {
        World world = underGravity();
        const BodyId platform = world.add(
            {.shape = kodo::Box{10, 1}, .velocity = {0, -speed}, .type = BodyType::Kinematic});
        const BodyId box = world.add({.shape = kodo::Box{1, 1}, .position = {0, 2}});
        run(world, 4);
        EXPECT_NEAR(world[box].velocity().y, -speed, 1e-3);
        EXPECT_NEAR(world[box].position().y - world[platform].position().y, 1, 0.01);
    }
}

// A kinematic body that moves slowly falls asleep, and stops.
// https://github.com/erincatto/box2d/issues/62 https://github.com/dimforge/rapier/pull/885
TEST(FieldEvents, ASlowKinematicBodyNeverStops) {
    for (const Real speed : {Real(1), Real(1e-2), Real(1e-4)}) {
        World world = underGravity();
        const BodyId platform = world.add(
            {.shape = kodo::Box{4, 1}, .velocity = {speed, 0}, .type = BodyType::Kinematic});
        const BodyId box = world.add({.shape = kodo::Box{1, 1}, .position = {0, 1}});
        run(world, 10);
        EXPECT_NEAR(world[platform].position().x, 10 * speed, Real(0.02) * speed);
        EXPECT_NEAR(world[box].position().x, 10 * speed, Real(0.3) * speed + Real(1e-4));
    }
}

// A disc that is cast against a long thin box misses it, which a ray along the same way hits.
// https://github.com/dimforge/rapier.js/issues/258
TEST(FieldCasts, ADiscHitsTheLongThinBoxThatARayHits) {
    World world;
    const BodyId bar =
        world.add({.shape = kodo::Box{489, 1}, .position = {Real(884.5), Real(188.5)}});
    const Vec2 from{380, 241};
    const Vec2 way = Vec2{1004, 137} - from;
    const auto ray = kodo::rayCast(world, from, from + way);
    ASSERT_TRUE(ray && ray->body == bar);
    for (const Real radius : {Real(0.01), Real(0.5), Real(5)}) {
        const auto hit = kodo::shapeCast(world, kodo::Circle{radius}, {from, {}}, way);
        ASSERT_TRUE(hit && hit->body == bar) << radius;
        EXPECT_LE(hit->fraction, ray->fraction);
        EXPECT_NEAR(hit->fraction, ray->fraction, 2 * radius / std::abs(way.y) + Real(1e-4))
            << radius;
    }
}

// A ray that hits a segment from either side gets the same normal.
// https://github.com/erincatto/box2d/issues/95
TEST(FieldCasts, ARayGetsTheNormalOfTheSideOfASegmentThatItHits) {
    World world;
    world.add({.shape = kodo::Segment{{-1, 0}, {1, 0}}, .type = BodyType::Static});
    const auto above = kodo::rayCast(world, {0, 1}, {0, -1});
    const auto below = kodo::rayCast(world, {0, -1}, {0, 1});
    ASSERT_TRUE(above && below);
    EXPECT_EQ(above->normal, (Vec2{0, 1}));
    EXPECT_EQ(below->normal, (Vec2{0, -1}));
}

} // namespace
} // namespace field
