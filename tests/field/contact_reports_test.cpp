// SPDX-License-Identifier: MIT
// Reports on records, sensors and pairs.
#include <gtest/gtest.h>

#include <algorithm>

#include "field_scene.hpp"

namespace field {
namespace {

int count(const World& world, kodo::TouchPhase phase, BodyId body) {
    const auto all = world.collisions();
    return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const auto& record) {
        return record.phase == phase && record.involves(body);
    }));
}

// Whether a moving body that is a sensor is reported depends on the types of both. Pairs that
// nothing can move apart need no contact, but a sensor that moves must report what it meets.
// https://github.com/dimforge/rapier/issues/25
TEST(FieldContact, AMovingSensorReportsBodiesOfEveryType) {
    for (const BodyType type : {BodyType::Dynamic, BodyType::Kinematic, BodyType::Static}) {
        World world;
        const BodyId sensor = world.add({.shape = kodo::Box{1, 1},
                                         .position = {-3, 0},
                                         .velocity = {2, 0},
                                         .type = BodyType::Kinematic,
                                         .flags = kodo::kSensor});
        world.add({.shape = kodo::Box{1, 1}, .type = type});
        int begun = 0;
        int ended = 0;
        for (int i = 0; i < 180; ++i) {
            world.step(kDt);
            begun += count(world, kodo::TouchPhase::Begin, sensor);
            ended += count(world, kodo::TouchPhase::End, sensor);
        }
        EXPECT_EQ(begun, 1) << "type " << static_cast<int>(type);
        EXPECT_EQ(ended, 1) << "type " << static_cast<int>(type);
    }
}

// A large kinematic sensor that strafes misses boxes inside it, in some steps.
// https://github.com/dimforge/rapier/issues/244
TEST(FieldContact, ALargeStrafingSensorNeverMissesWhatIsInside) {
    World world;
    std::vector<BodyId> boxes;
    for (int i = -6; i <= 6; ++i) {
        for (int k = -6; k <= 6; ++k) {
            boxes.push_back(
                world.add({.shape = kodo::Box{1, 1},
                           .position = {static_cast<Real>(i) * 2, static_cast<Real>(k) * 2},
                           .flags = kodo::kNeverSleep}));
        }
    }
    const BodyId view = world.add(
        {.shape = kodo::Box{40, 40}, .type = BodyType::Kinematic, .flags = kodo::kSensor});
    world.step(kDt);
    for (int i = 0; i < 240; ++i) {
        world[view].setVelocity({i / 30 % 2 == 0 ? Real(8) : Real(-8), 0});
        world.step(kDt);
        ASSERT_EQ(count(world, kodo::TouchPhase::Persist, view) +
                      count(world, kodo::TouchPhase::Begin, view),
                  static_cast<int>(boxes.size()))
            << "step " << i;
    }
}

// The end of an overlap is lost if a body carries several sensors.
// https://github.com/dimforge/bevy_rapier/issues/107
TEST(FieldContact, EachSensorOfABodyEndsAsOftenAsItBegins) {
    World world = underGravity();
    addGround(world);
    const BodyId hero = world.add({.shape = kodo::Box{1, 1}, .position = {0, Real(0.5)}});
    std::vector<BodyId> sensors; // below and at both sides, moved along with the hero
    const Vec2 places[] = {{0, Real(-0.5)}, {Real(-0.6), 0}, {Real(0.6), 0}};
    for (const Vec2 at : places) {
        sensors.push_back(world.add({.shape = kodo::Box{Real(0.4), Real(0.4)},
                                     .position = world[hero].position() + at,
                                     .flags = kodo::kSensor}));
        world.add(kodo::FixedJoint{.ends = {.a = hero, .b = sensors.back(), .anchorA = at}});
    }
    world.add({.shape = kodo::Circle{Real(0.4)},
               .position = {2, 3},
               .velocity = {-3, 0},
               .material = {.restitution = Real(0.8)}});
    std::array<int, 3> open{};
    for (int i = 0; i < 600; ++i) {
        if (i % 100 == 50) {
            world[hero].applyImpulse({0, 6});
        }
        world.step(kDt);
        for (std::size_t k = 0; k < sensors.size(); ++k) {
            open[k] += count(world, kodo::TouchPhase::Begin, sensors[k]);
            open[k] -= count(world, kodo::TouchPhase::End, sensors[k]);
            const int now = count(world, kodo::TouchPhase::Persist, sensors[k]) +
                            count(world, kodo::TouchPhase::Begin, sensors[k]);
            if (!world[sensors[k]].isAsleep()) {
                ASSERT_EQ(open[k], now) << "sensor " << k << ", step " << i;
            }
        }
    }
}

// Two pairs whose numbers give one hash value share a contact: one of them has none.
// https://github.com/netonjm/ChipmunkSharp/pull/8
TEST(FieldContact, TwoHundredPairsBeginInOneStepAndEachHasItsRecord) {
    World world = underGravity();
    std::vector<BodyId> balls;
    for (int i = 0; i < 200; ++i) {
        const auto x = static_cast<Real>(i) * Real(1.5);
        world.add({.shape = kodo::Box{1, 1}, .position = {x, 0}, .type = BodyType::Static});
    }
    for (int i = 0; i < 200; ++i) {
        const auto x = static_cast<Real>(i) * Real(1.5);
        balls.push_back(world.add({.shape = kodo::Box{1, 1}, .position = {x, Real(1.02)}}));
    }
    std::size_t begun = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(kDt);
        const std::size_t now = world.begunCollisions().size();
        EXPECT_TRUE(now == 0 || now == balls.size()) << now << " in step " << i;
        begun += now;
    }
    EXPECT_EQ(begun, balls.size());
    for (const BodyId ball : balls) {
        EXPECT_NEAR(world[ball].position().y, 1, 0.01);
    }
}

// A box query answers bodies whose bounds it meets, although it misses their shapes.
// https://github.com/Argus-Labs/world-engine/pull/948
TEST(FieldContact, ABoxQueryTestsShapesAndNotBounds) {
    World world;
    const BodyId bar = world.add(
        {.shape = kodo::Box{4, Real(0.2)}, .rotation = kodo::Rot::fromAngle(Real(0.785))});
    const BodyId disc = world.add({.shape = kodo::Circle{1}, .position = {5, 0}});
    EXPECT_TRUE(kodo::overlap(world, {{Real(0.8), Real(-1.2)}, {Real(1.2), Real(-0.8)}}).empty());
    EXPECT_TRUE(kodo::overlap(world, {{Real(5.8), Real(0.8)}, {Real(6.2), Real(1.2)}}).empty());
    EXPECT_EQ(kodo::overlap(world, {{Real(0.9), Real(0.9)}, {Real(1.1), Real(1.1)}}),
              std::vector{bar});
    EXPECT_EQ(kodo::overlap(world, {{Real(5.6), Real(0.6)}, {6, 1}}), std::vector{disc});
}

} // namespace
} // namespace field
