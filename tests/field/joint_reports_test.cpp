// SPDX-License-Identifier: MIT
// Reports on joints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "field_scene.hpp"

namespace field {
namespace {

constexpr Real kDegree = std::numbers::pi_v<Real> / 180;

/// Angle of body b against body a (rad), -pi to pi.
Real angleBetween(const World& world, BodyId a, BodyId b) {
    return (world[b].rotation() * world[a].rotation().inverse()).angle();
}

/// World point of a joint's anchor on one of its bodies (m).
Vec2 worldPoint(const World& world, BodyId body, Vec2 anchor) {
    return world[body].transform() * anchor;
}

// A motor whose target is 90 degrees spins for ever; with 135 degrees it ends at 45.
// https://github.com/dimforge/rapier/issues/378
TEST(FieldJoints, AMotorReachesEachTargetAngle) {
    for (const int degrees : {-170, -135, -90, -45, 45, 90, 135, 170}) {
        World world;
        const BodyId base = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
        const BodyId arm = world.add({.shape = kodo::Box{2, Real(0.2)}, .position = {1, 0}});
        world.add(kodo::RevoluteJoint{.ends = {.a = base, .b = arm, .anchorB = {-1, 0}}});
        world.add(kodo::MotorJoint{.ends = {.a = base, .b = arm, .anchorB = {-1, 0}},
                                   .reference = static_cast<Real>(degrees) * kDegree,
                                   .torque = 100,
                                   .hertz = 2});
        run(world, 5);
        EXPECT_NEAR(angleBetween(world, base, arm), static_cast<Real>(degrees) * kDegree, 1e-3)
            << degrees;
        EXPECT_NEAR(world[arm].angularVelocity(), 0, 1e-3) << degrees;
    }
}

// The flipper of a pinball table in true size, 71 mm long, shakes between its limits; lighter than
// 1 g it ignores them. https://github.com/avianphysics/avian/issues/886
TEST(FieldJoints, ALightSmallFlipperRestsAtItsLimits) {
    for (const Real mass : {Real(0.1), Real(0.01), Real(1e-3), Real(1e-4)}) {
        World world({.gravity = {0, Real(-9.81)}, .lengthUnit = Real(0.05)});
        const BodyId table =
            world.add({.shape = kodo::Circle{Real(0.005)}, .type = BodyType::Static});
        const BodyId flipper = world.add({.shape = kodo::Box{Real(0.071), Real(0.018)},
                                          .position = {Real(0.0355), 0},
                                          .mass = kodo::MassDef{mass, {}, {}}});
        world.add(
            kodo::RevoluteJoint{.ends = {.a = table, .b = flipper, .anchorB = {Real(-0.0355), 0}},
                                .limits = kodo::Range{-30 * kDegree, 30 * kDegree}});
        run(world, 2);
        EXPECT_NEAR(angleBetween(world, table, flipper), -30 * kDegree, 1e-2) << mass;
        EXPECT_NEAR(world[flipper].angularVelocity(), 0, 1e-3) << mass;
        world[flipper].setAngularVelocity(150); // a blow: 39 rad/s about the pin
        Real highest = -30 * kDegree;
        for (int i = 0; i < 120; ++i) {
            world.step(kDt);
            highest = std::max(highest, angleBetween(world, table, flipper));
        }
        EXPECT_LT(highest, 31 * kDegree) << mass;
        EXPECT_GT(highest, 25 * kDegree) << mass;
        EXPECT_NEAR(angleBetween(world, table, flipper), -30 * kDegree, 1e-2) << mass;
    }
}

// Two discs that start farther apart than the limit of their joint exchange their places.
// https://github.com/avianphysics/avian/issues/875
TEST(FieldJoints, BodiesBeyondALimitComeTogetherOnTheirSides) {
    for (const Real distance : {Real(1.5), Real(4), Real(20)}) {
        World world;
        const BodyId left =
            world.add({.shape = kodo::Circle{Real(0.25)}, .position = {-distance / 2, 1}});
        const BodyId right =
            world.add({.shape = kodo::Circle{Real(0.25)}, .position = {distance / 2, -1}});
        world.add(
            kodo::DistanceJoint{.ends = {.a = left, .b = right}, .limits = kodo::Range{0, 1}});
        for (int i = 0; i < 600; ++i) {
            world.step(kDt);
            ASSERT_LT(world[left].position().x, world[right].position().x) << distance;
        }
        EXPECT_LE(length(world[right].position() - world[left].position()), 1.01) << distance;
    }
}

// A pin with narrow limits turns its bodies faster and faster by itself.
// https://github.com/godotengine/godot/issues/88481
TEST(FieldJoints, APinWithLimitsNeverTurnsItsFreeBodies) {
    for (const Real width : {Real(0), Real(1), Real(20)}) {
        World world;
        const BodyId a = world.add({.shape = kodo::Box{1, Real(0.2)}});
        const BodyId b = world.add({.shape = kodo::Box{1, Real(0.2)}, .position = {1, 0}});
        world.add(kodo::RevoluteJoint{
            .ends = {.a = a, .b = b, .anchorA = {Real(0.5), 0}, .anchorB = {Real(-0.5), 0}},
            .limits = kodo::Range{-width * kDegree, width * kDegree}});
        world[b].applyImpulse({0, Real(0.2)}, {Real(1.4), 0});
        const auto spin = [&] { // N m s, about the origin
            Real sum = 0;
            for (const BodyId id : {a, b}) {
                sum += world[id].inertia() * world[id].angularVelocity() +
                       world[id].mass() * cross(world[id].center(), world[id].velocity());
            }
            return sum;
        };
        const Real before = spin();
        for (int i = 0; i < 1200; ++i) {
            world.step(kDt);
            ASSERT_LT(std::abs(angleBetween(world, a, b)), (width + 1) * kDegree) << width;
        }
        EXPECT_NEAR(spin(), before, Real(1e-3) * before) << width;
    }
}

// In a hanging chain with angle limits, the links that carry others break out of their limits.
// https://github.com/avianphysics/avian/issues/553
TEST(FieldJoints, AChainThatSticksOutStaysWithinItsLimits) {
    World world = underGravity();
    constexpr int kLinks = 5; // with ten, limits yield by 6 degrees: see docs/tuning.md
    BodyId last = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
    std::vector<std::pair<BodyId, BodyId>> pairs;
    for (int i = 0; i < kLinks; ++i) {
        const BodyId link = world.add(
            {.shape = kodo::Box{1, Real(0.2)}, .position = {static_cast<Real>(i + 1), 0}});
        world.add(kodo::RevoluteJoint{
            .ends = {.a = last, .b = link, .anchorA = {Real(0.5), 0}, .anchorB = {Real(-0.5), 0}},
            .limits = kodo::Range{-15 * kDegree, 15 * kDegree}});
        pairs.emplace_back(last, link);
        last = link;
    }
    run(world, 10);
    for (const auto& [a, b] : pairs) {
        EXPECT_NEAR(angleBetween(world, a, b), -15 * kDegree, 2 * kDegree);
    }
}

// A pole of links with limits of 0 straightens within ten seconds only, after it was bent. A blow
// of 2 m/s bends it by at most 10 degrees, and one second later by at most 3.
// https://github.com/erincatto/box2d/issues/310
TEST(FieldJoints, APoleOfLockedPinsStraightensWithinASecond) {
    World world;
    BodyId last = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
    std::vector<BodyId> links;
    for (int i = 0; i < 8; ++i) {
        const BodyId link =
            world.add({.shape = kodo::Box{Real(0.2), Real(0.5)},
                       .position = {0, Real(0.75) + Real(0.5) * static_cast<Real>(i)}});
        const Real reach = i == 0 ? Real(0.5) : Real(0.25);
        world.add(kodo::RevoluteJoint{
            .ends = {.a = last, .b = link, .anchorA = {0, reach}, .anchorB = {0, Real(-0.25)}},
            .limits = kodo::Range{0, 0}});
        links.push_back(link);
        last = link;
    }
    world[last].applyImpulse({Real(0.2), 0});
    for (int i = 0; i < 60; ++i) {
        world.step(kDt);
        EXPECT_NEAR(world[last].rotation().angle(), 0, 10 * kDegree) << "step " << i;
    }
    for (const BodyId link : links) {
        EXPECT_NEAR(world[link].rotation().angle(), 0, 3 * kDegree);
    }
}

// Two boxes that a motor joint holds side by side land and come to rest in a pose that no static
// body could have. https://github.com/erincatto/box2d/issues/487
TEST(FieldJoints, APairHeldByAMotorRestsOnlyWhereItIsInBalance) {
    World world = underGravity();
    addGround(world);
    const BodyId a = world.add({.shape = kodo::Box{1, 1}, .position = {0, 3}});
    const BodyId b = world.add({.shape = kodo::Box{1, 1}, .position = {2, 3}});
    world.add(
        kodo::MotorJoint{.ends = {.a = a, .b = b, .anchorA = {2, 0}}, .force = 1e4, .torque = 1e4});
    world[a].setRotation(kodo::Rot::fromAngle(30 * kDegree));
    run(world, 10);
    EXPECT_NEAR(world[a].position().y, 0.5, 0.02); // both lie flat
    EXPECT_NEAR(world[b].position().y, 0.5, 0.02);
}

// The wheel of a car with a slider and a spring leaves its slot when the car tilts or lands.
// https://github.com/godotengine/godot/issues/10580 https://github.com/piqnt/planck.js/issues/28
TEST(FieldJoints, AWheelStaysInItsSlot) {
    World world = underGravity();
    addGround(world);
    const BodyId car = world.add({.shape = kodo::Box{3, Real(0.5)},
                                  .position = {0, 3},
                                  .rotation = kodo::Rot::fromAngle(Real(0.4))});
    std::vector<BodyId> hubs;
    for (const Real side : {Real(-1), Real(1)}) {
        const Vec2 anchor{side, Real(-0.75)};
        const Vec2 place = worldPoint(world, car, anchor);
        const BodyId hub = world.add(
            {.shape = kodo::Circle{Real(0.1)}, .position = place, .flags = kodo::kMatchEqual | 2});
        const BodyId wheel = world.add({.shape = kodo::Circle{Real(0.4)}, .position = place});
        world.add(kodo::PrismaticJoint{.ends = {.a = car, .b = hub, .anchorA = anchor},
                                       .axis = {0, 1},
                                       .reference = Real(-0.4),
                                       .limits = kodo::Range{Real(-0.3), Real(0.3)}});
        world.add(kodo::DistanceJoint{.ends = {.a = car, .b = hub, .anchorA = anchor + Vec2{0, 1}},
                                      .length = 1,
                                      .hertz = 3,
                                      .damping = Real(0.7)});
        world.add(kodo::RevoluteJoint{.ends = {.a = hub, .b = wheel}});
        hubs.push_back(hub);
    }
    for (int i = 0; i < 600; ++i) {
        world.step(kDt);
        for (std::size_t k = 0; k < hubs.size(); ++k) {
            const Vec2 local = toLocal(world[car].transform(), world[hubs[k]].position());
            ASSERT_NEAR(local.x, k == 0 ? -1 : 1, 0.02) << "step " << i;
            ASSERT_LT(std::abs(local.y + Real(0.75)), 0.32) << "step " << i;
        }
    }
}

// A body on a slider can be pulled off the axis by the mouse, and comes back slowly. With a torque
// on one of the bodies the slot comes apart.
// https://github.com/godotengine/godot/issues/27454
// https://github.com/godotengine/godot/issues/19376
TEST(FieldJoints, ASliderHoldsAgainstMouseAndTorque) {
    World world;
    const BodyId rail = world.add({.shape = kodo::Box{4, Real(0.2)}});
    const BodyId slider = world.add({.shape = kodo::Box{Real(0.5), Real(0.5)}, .position = {0, 1}});
    world.add(kodo::PrismaticJoint{.ends = {.a = rail, .b = slider, .anchorA = {0, 1}},
                                   .limits = kodo::Range{-1, 1}});
    world.add(kodo::MouseJoint{.body = slider, .target = {3, 5}, .force = 500});
    for (int i = 0; i < 300; ++i) {
        world[rail].applyTorque(i < 120 ? 100 : -100);
        world.step(kDt);
        const Vec2 local = toLocal(world[rail].transform(), world[slider].position());
        ASSERT_NEAR(local.y, 1, 0.02) << "step " << i;
        ASSERT_LT(std::abs(local.x), 1.02) << "step " << i;
    }
}

// A spring does not contract when the body at its end is lighter than 50 g.
// https://github.com/godotengine/godot/issues/76697
TEST(FieldJoints, ASpringMovesALightBodyAsAHeavyOne) {
    for (const Real mass : {Real(1e-3), Real(0.01), Real(0.04), Real(1), Real(50)}) {
        World world;
        const BodyId hook = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.2)},
                                       .position = {0, -4},
                                       .mass = kodo::MassDef{mass, {}, {}}});
        world.add(kodo::DistanceJoint{
            .ends = {.a = hook, .b = ball}, .length = 2, .hertz = 1, .damping = 0});
        run(world, Real(0.25)); // a quarter of the period: at the rest length, at 2 pi f A
        EXPECT_NEAR(world[ball].position().y, -2, 0.1) << mass;
        EXPECT_NEAR(world[ball].velocity().y, 4 * std::numbers::pi, 0.2) << mass;
    }
}

// A limb stays where it is while the kinematic body that it hangs from moves on.
// https://github.com/dimforge/rapier/issues/287
TEST(FieldJoints, ASleepingLimbFollowsItsKinematicBody) {
    World world = underGravity();
    const BodyId hand = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Kinematic});
    const BodyId limb = world.add({.shape = kodo::Box{Real(0.2), 1}, .position = {0, -1}});
    world.add(kodo::RevoluteJoint{
        .ends = {.a = hand, .b = limb, .anchorA = {0, Real(-0.5)}, .anchorB = {0, Real(0.5)}}});
    run(world, 3);
    ASSERT_TRUE(world[limb].isAsleep());
    world[hand].setVelocity({1, 0});
    run(world, 2);
    EXPECT_FALSE(world[limb].isAsleep());
    EXPECT_NEAR(
        length(worldPoint(world, limb, {0, Real(0.5)}) - worldPoint(world, hand, {0, Real(-0.5)})),
        0, 0.01);
}

// A joint between two sleeping bodies does not wake them when it is added.
// https://github.com/dimforge/rapier/issues/352
TEST(FieldJoints, AJointWakesBothBodiesWhenItIsAdded) {
    World world = underGravity();
    addGround(world);
    const BodyId a = addSleepingBox(world, {-2, Real(0.5)});
    const BodyId b = addSleepingBox(world, {2, Real(0.5)});
    world.add(kodo::DistanceJoint{.ends = {.a = a, .b = b}, .length = 2, .hertz = 1, .damping = 1});
    world.step(kDt);
    EXPECT_FALSE(world[a].isAsleep());
    EXPECT_FALSE(world[b].isAsleep());
    run(world, 1);
    EXPECT_LT(world[b].position().x - world[a].position().x, 3.5);
}

// A wheel that has fallen asleep does not start when the speed of its motor is set.
// https://github.com/dimforge/rapier/pull/328
TEST(FieldJoints, ASleepingWheelStartsWithItsMotor) {
    World world = underGravity();
    const BodyId frame = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
    const BodyId wheel = world.add({.shape = kodo::Circle{Real(0.5)}, .position = {2, 0}});
    kodo::RevoluteJoint axle{.ends = {.a = frame, .b = wheel, .anchorA = {2, 0}}, .motorTorque = 5};
    const kodo::JointId id = world.add(axle);
    run(world, 3);
    ASSERT_TRUE(world[wheel].isAsleep());
    axle.motorSpeed = -4;
    world.setJoint(id, axle);
    run(world, 1);
    EXPECT_NEAR(world[wheel].angularVelocity(), -4, 1e-3);
}

// A joint that is removed after its bodies crashes the program.
// https://github.com/avianphysics/avian/pull/882
TEST(FieldJoints, AJointGoesWithItsBodyAndItsIdIsRefused) {
    World world = underGravity();
    const BodyId a = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
    const BodyId b = world.add({.shape = kodo::Box{1, 1}, .position = {0, -2}});
    const kodo::JointId joint =
        world.add(kodo::RevoluteJoint{.ends = {.a = a, .b = b, .anchorB = {0, 2}}});
    run(world, 3);
    world.remove(b);
    EXPECT_FALSE(world.contains(joint));
    EXPECT_THROW(world.remove(joint), kodo::BadDefinition);
    world.step(kDt);
    EXPECT_EQ(world.joints().size(), 0u);
}

// Two equal springs that pull a body apart do not balance: the order in which they were added
// decides. https://github.com/liabru/matter-js/issues/93
TEST(FieldJoints, OpposingSpringsBalanceInEitherOrder) {
    for (const bool swapped : {false, true}) {
        World world;
        const BodyId left =
            world.add({.shape = kodo::Box{1, 1}, .position = {-4, 0}, .type = BodyType::Static});
        const BodyId right =
            world.add({.shape = kodo::Box{1, 1}, .position = {4, 0}, .type = BodyType::Static});
        const BodyId ball = world.add({.shape = kodo::Circle{Real(0.5)}});
        for (const BodyId end : {swapped ? right : left, swapped ? left : right}) {
            world.add(kodo::DistanceJoint{
                .ends = {.a = end, .b = ball}, .length = 1, .hertz = 5, .damping = Real(0.1)});
        }
        run(world, 5);
        EXPECT_NEAR(world[ball].position().x, 0, 1e-4);
        EXPECT_NEAR(world[ball].velocity().x, 0, 1e-4);
    }
}

// A pendulum stops although nothing brakes it.
// https://github.com/liabru/matter-js/issues/1250 https://github.com/liabru/matter-js/issues/216
TEST(FieldJoints, APendulumKeepsItsSwing) {
    World world = underGravity();
    const BodyId hook = world.add({.shape = kodo::Circle{Real(0.1)}, .type = BodyType::Static});
    const BodyId ball = world.add({.shape = kodo::Circle{Real(0.5)}, .position = {3, 0}});
    world.add(kodo::DistanceJoint{.ends = {.a = hook, .b = ball}, .limits = kodo::Range{3, 3}});
    Real highest = -3;
    for (int i = 0; i < 60 * 60; ++i) {
        world.step(kDt);
        highest = i < 59 * 60 - 300 ? -3 : std::max(highest, world[ball].position().y);
    }
    EXPECT_GT(highest, -0.1); // of a height of 3 m, after a minute
    EXPECT_LT(highest, 0.03);
}

// A rope of links stretches far beyond its length under a heavy end.
// https://github.com/liabru/matter-js/issues/706 https://github.com/liabru/matter-js/issues/1274
TEST(FieldJoints, ARopeKeepsItsLengthUnderAHeavyEnd) {
    World world = underGravity();
    BodyId last = world.add({.shape = kodo::Circle{Real(0.1)}, .type = BodyType::Static});
    constexpr int kLinks = 20;
    for (int i = 0; i < kLinks; ++i) {
        const bool isEnd = i == kLinks - 1;
        const BodyId link =
            world.add({.shape = kodo::Circle{Real(0.1)},
                       .position = {0, Real(-0.5) * static_cast<Real>(i + 1)},
                       .mass = kodo::MassDef{isEnd ? Real(100) : Real(0.1), {}, {}}});
        world.add(kodo::DistanceJoint{.ends = {.a = last, .b = link},
                                      .limits = kodo::Range{0, Real(0.5)}});
        last = link;
    }
    world[last].applyImpulse({300, 0}); // 3 m/s
    Real longest = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(kDt);
        longest = std::max(longest, length(world[last].position()));
    }
    EXPECT_LT(longest, 10 * 1.01);
    EXPECT_GT(longest, 10 * 0.99);
}

// A cart on four wheels creeps back and forth although its motors hold the wheels at speed 0.
// https://github.com/dimforge/rapier/issues/432
TEST(FieldJoints, ACartWithHeldWheelsStands) {
    World world = underGravity();
    addGround(world);
    const BodyId cart = world.add({.shape = kodo::Box{4, Real(0.5)}, .position = {0, 1}});
    for (const Real x : {Real(-1.5), Real(-0.5), Real(0.5), Real(1.5)}) {
        const BodyId wheel =
            world.add({.shape = kodo::Circle{Real(0.4)}, .position = {x, Real(0.4)}});
        world.add(kodo::RevoluteJoint{.ends = {.a = cart, .b = wheel, .anchorA = {x, Real(-0.6)}},
                                      .motorTorque = 1000});
    }
    run(world, 2);
    const Real x = world[cart].position().x;
    run(world, 20);
    EXPECT_NEAR(world[cart].position().x, x, 1e-3);
    EXPECT_NEAR(x, 0, 0.01);
}

// A hinge whose lower and upper angle are equal turns past them under a blow.
// https://github.com/defold/defold/issues/8438
TEST(FieldJoints, AHingeWithEqualLimitsIsRigid) {
    World world = underGravity();
    const BodyId torso = world.add({.shape = kodo::Box{1, 2}, .type = BodyType::Static});
    const kodo::Rot turn = kodo::Rot::fromAngle(-60 * kDegree);
    const BodyId leg = world.add({.shape = kodo::Box{Real(0.3), 1},
                                  .position = Vec2{0, -1} + turn * Vec2{0, Real(-0.5)},
                                  .rotation = turn});
    world.add(kodo::RevoluteJoint{
        .ends = {.a = torso, .b = leg, .anchorA = {0, -1}, .anchorB = {0, Real(0.5)}},
        .limits = kodo::Range{-60 * kDegree, -60 * kDegree}});
    for (int i = 0; i < 300; ++i) {
        if (i % 30 == 0) {
            world[leg].applyImpulse({i % 60 == 0 ? Real(1) : Real(-1), 0}, world[leg].center());
        }
        world.step(kDt);
        ASSERT_NEAR(angleBetween(world, torso, leg), -60 * kDegree, 2 * kDegree) << "step " << i;
    }
}

} // namespace
} // namespace field
