// SPDX-License-Identifier: MIT
// Reports on pins and their limits, in both solvers at several rates.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "field_scene.hpp"

namespace field {
namespace {

constexpr Real kPi = std::numbers::pi_v<Real>;

/// Distance (m) between the two anchors of a joint.
Real gapOf(const World& world, kodo::JointId joint) {
    const kodo::JointState state = world.jointState(joint);
    return length(state.anchorB - state.anchorA);
}

// A limit of 270 degrees acts as one of 90, and none goes beyond 180.
// https://github.com/dimforge/rapier/issues/499
TEST(FieldPins, ALimitBeyondHalfATurnIsReachedAndKept) {
    inAllSettings([](const Setting& setting) {
        for (const Real limit : {Real(0.5), Real(0.9), Real(1.5), Real(2.5)}) {
            World world = setting.world({});
            const BodyId base = world.add({.type = BodyType::Static});
            const BodyId arm = world.add({.shape = kodo::Box{2, Real(0.2)}, .position = {1, 0}});
            const kodo::JointId pin =
                world.add(kodo::RevoluteJoint{.ends = {.a = base, .b = arm, .anchorB = {-1, 0}},
                                              .limits = kodo::Range{-limit * kPi, limit * kPi},
                                              .motorSpeed = 3,
                                              .motorTorque = 10});
            setting.run(world, 4);
            EXPECT_NEAR(world.jointState(pin).angle, limit * kPi, 0.02) << limit;
            world.changeJoint<kodo::RevoluteJoint>(
                pin, [](kodo::RevoluteJoint& joint) { joint.motorSpeed = -3; });
            setting.run(world, 7);
            EXPECT_NEAR(world.jointState(pin).angle, -limit * kPi, 0.02) << limit;
        }
    });
}

// A bar that is pinned at its middle within +-45 degrees turns farther when something falls on it.
// https://github.com/dimforge/rapier/issues/523
TEST(FieldPins, ABlowDoesNotTurnABarBeyondItsLimit) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        const BodyId base = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
        const BodyId bar = world.add({.shape = kodo::Box{4, Real(0.2)}});
        const kodo::JointId pin = world.add(kodo::RevoluteJoint{
            .ends = {.a = base, .b = bar}, .limits = kodo::Range{-kPi / 4, kPi / 4}});
        world.add({.shape = kodo::Box{Real(0.5), Real(0.5)}, .position = {Real(1.6), 4}});
        Real lowest = 0;
        for (Real t = 0; t < 4; t += setting.dt) {
            world.step(setting.dt);
            lowest = std::min(lowest, world.jointState(pin).angle);
        }
        EXPECT_LT(lowest, -kPi / 4 + Real(0.02)); // it arrives
        EXPECT_GT(lowest, -kPi / 4 - Real(0.05));
    });
}

// A chain of boxes that touch each other, with limits, is stable with four links; with five it
// shakes and breaks apart. https://github.com/dimforge/rapier/issues/373
TEST(FieldPins, AChainOfTouchingLinksRestsAtAnyLength) {
    inAllSettings([](const Setting& setting) {
        for (const int links : {4, 5, 12}) {
            World world = setting.world();
            addGround(world);
            std::vector<kodo::JointId> pins;
            BodyId last{};
            for (int i = 0; i < links; ++i) {
                const BodyId link =
                    world.add({.shape = kodo::Box{Real(0.5), Real(0.2)},
                               .position = {Real(0.5) * static_cast<Real>(i), Real(0.1)}});
                if (i > 0) {
                    pins.push_back(
                        world.add(kodo::RevoluteJoint{.ends = {.a = last,
                                                               .b = link,
                                                               .anchorA = {Real(0.25), 0},
                                                               .anchorB = {Real(-0.25), 0}},
                                                      .limits = kodo::Range{-kPi / 6, kPi / 6}}));
                }
                last = link;
            }
            setting.run(world, 3);
            for (const BodyId id : world.bodies()) {
                EXPECT_LT(length(world[id].velocity()), 1e-3) << links;
            }
            for (const kodo::JointId pin : pins) {
                EXPECT_LT(gapOf(world, pin), 1e-3) << links;
            }
        }
    });
}

// A small disc on a pin under a plank of 50 kg moves off the pin and jumps.
// https://github.com/godotengine/godot/issues/79863
TEST(FieldPins, ALightWheelStaysOnThePinOfAHeavyPlank) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId plank = world.add(
            {.shape = kodo::Box{4, Real(0.25)}, .position = {0, 2}, .density = 50}); // 50 kg
        std::array<kodo::JointId, 2> pins;
        for (const std::size_t i : {0u, 1u}) {
            const Real x = i == 0 ? Real(-1.5) : Real(1.5);
            const BodyId wheel = world.add(
                {.shape = kodo::Circle{Real(0.3)}, .position = {x, Real(1.8)}, .density = 4});
            pins[i] = world.add(
                kodo::RevoluteJoint{.ends = {.a = plank, .b = wheel, .anchorA = {x, Real(-0.2)}}});
        }
        setting.run(world, 4); // falls 1.5 m
        for (const kodo::JointId pin : pins) {
            EXPECT_LT(gapOf(world, pin), 0.005);
        }
        if (!setting.thesis) { // there, such a load presses the wheels into the ground
            EXPECT_LT(length(world[plank].velocity()), 0.02);
            EXPECT_NEAR(world[plank].position().y, 0.5, 0.02);
        }
    });
}

// A car that stood still for a while: its wheels run ahead of it when it starts again.
// https://github.com/godotengine/godot/issues/99260
TEST(FieldPins, WheelsOfACarThatSleptStayOnTheirPins) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId car = world.add({.shape = kodo::Box{2, Real(0.4)}, .position = {-8, 1}});
        std::array<kodo::JointId, 2> pins;
        for (const std::size_t i : {0u, 1u}) {
            const Real x = i == 0 ? Real(-0.8) : Real(0.8);
            const BodyId wheel =
                world.add({.shape = kodo::Circle{Real(0.4)}, .position = {x - 8, Real(0.6)}});
            pins[i] = world.add(kodo::RevoluteJoint{
                .ends = {.a = car, .b = wheel, .anchorA = {x, Real(-0.4)}}, .motorTorque = 50});
        }
        setting.run(world, 4);
        EXPECT_TRUE(world[car].isAsleep());
        EXPECT_LT(length(world[car].velocity()), 0.005);
        const Real start = world[car].position().x;
        for (const kodo::JointId pin : pins) {
            world.changeJoint<kodo::RevoluteJoint>(
                pin, [](kodo::RevoluteJoint& joint) { joint.motorSpeed = -10; });
        }
        for (Real t = 0; t < 2; t += setting.dt) {
            world.step(setting.dt);
            for (const kodo::JointId pin : pins) {
                ASSERT_LT(gapOf(world, pin), 0.01);
            }
        }
        EXPECT_NEAR(world[car].velocity().x, 10 * Real(0.4), 0.05);
        EXPECT_GT(world[car].position().x, start + 5);
    });
}

// A kinematic body turns: when its angle passes 180 degrees, the body on its pin jumps.
// https://github.com/godotengine/godot/issues/31940
TEST(FieldPins, ATurningKinematicBodyCarriesAPinnedOneThroughEveryAngle) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world({});
        const BodyId arm = world.add(
            {.shape = kodo::Box{2, Real(0.2)}, .angularVelocity = 2, .type = BodyType::Kinematic});
        // It moves with the arm's end from the start, without a spin of its own.
        const BodyId bob = world.add(
            {.shape = kodo::Box{Real(0.5), Real(0.5)}, .position = {2, 0}, .velocity = {0, 4}});
        const kodo::JointId pin =
            world.add(kodo::RevoluteJoint{.ends = {.a = arm, .b = bob, .anchorA = {2, 0}}});
        for (Real t = 0; t < 10; t += setting.dt) {
            world.step(setting.dt);
            ASSERT_LT(gapOf(world, pin), setting.dt > Real(0.02) ? 0.04 : 0.02) << t;
            ASSERT_NEAR(length(world[bob].velocity()), 4, 0.05) << t;
            ASSERT_NEAR(world[bob].angularVelocity(), 0, 1e-3) << t; // the pin has no torque
        }
    });
}

// A body on the pin of a kinematic one that starts and stops runs ahead of it.
// https://github.com/godotengine/godot/issues/122480
TEST(FieldPins, APinnedBodyFollowsAKinematicOneWithoutRunningAhead) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        const BodyId player = world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Kinematic});
        const BodyId bob =
            world.add({.shape = kodo::Circle{Real(0.25)}, .position = {0, Real(-1.5)}});
        const kodo::JointId pin = world.add(
            kodo::RevoluteJoint{.ends = {.a = player, .b = bob, .anchorB = {0, Real(1.5)}}});
        int step = 0;
        for (Real t = 0; t < 4; t += setting.dt) {
            if (step++ % 20 == 0) {
                world[player].setVelocity({step % 40 == 1 ? Real(5) : Real(-5), 0});
            }
            world.step(setting.dt);
            ASSERT_LT(gapOf(world, pin), 0.02) << t;
        }
    });
}

// A unicycle that only a pin holds stands upright by itself.
// https://github.com/appsinacup/godot-box2d/issues/104
TEST(FieldPins, AUnicycleFallsOver) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId wheel =
            world.add({.shape = kodo::Circle{Real(0.5)}, .position = {0, Real(0.5)}});
        const BodyId seat = world.add({.shape = kodo::Box{Real(0.2), 2},
                                       .position = {0, Real(1.5)},
                                       .angularVelocity = Real(-0.05)});
        world.add(kodo::RevoluteJoint{.ends = {.a = wheel, .b = seat, .anchorB = {0, -1}}});
        setting.run(world, 3);
        EXPECT_GT(std::abs(world[seat].rotation().angle()), kPi / 2);
    });
}

// Bodies on pins turn as if rusted. https://github.com/appsinacup/godot-rapier-physics/issues/96
TEST(FieldPins, APinWithoutMotorHasNoFriction) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world({});
        const BodyId base = world.add({.type = BodyType::Static});
        const BodyId rotor = world.add({.shape = kodo::Box{2, Real(0.2)}, .angularVelocity = 5});
        world.add(kodo::RevoluteJoint{.ends = {.a = base, .b = rotor}});
        // A wheel within a free body: its spin is its own.
        const BodyId car = world.add({.shape = kodo::Box{2, 1}, .position = {10, 0}});
        const BodyId wheel = world.add(
            {.shape = kodo::Circle{Real(0.4)}, .position = {11, 0}, .angularVelocity = 20});
        world.add(kodo::RevoluteJoint{.ends = {.a = car, .b = wheel, .anchorA = {1, 0}}});
        setting.run(world, 10);
        EXPECT_NEAR(world[rotor].angularVelocity(), 5, 1e-3);
        EXPECT_NEAR(world[wheel].angularVelocity(), 20, 1e-3);
        EXPECT_NEAR(world[car].angularVelocity(), 0, 1e-4);
    });
}

// A torso with four limbs of two parts: pins act at other points once the joints are solved in
// lanes. https://github.com/appsinacup/godot-rapier-physics/issues/599
TEST(FieldPins, EachPinOfATreeHoldsAtItsOwnPoint) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world({});
        const BodyId torso =
            world.add({.shape = kodo::Box{1, 2}, .velocity = {1, 0}, .angularVelocity = Real(0.5)});
        std::vector<kodo::JointId> pins;
        for (const Vec2 end : {Vec2{-1, 1}, Vec2{1, 1}, Vec2{-1, -1}, Vec2{1, -1}}) {
            const Vec2 root{end.x / 2, end.y};
            const auto limb = [&](Real from) {
                return world.add({.shape = kodo::Box{1, Real(0.2)},
                                  .position = {end.x * (from + Real(0.5)) + root.x, root.y},
                                  .velocity = {1, 0}});
            };
            const BodyId upper = limb(0);
            const BodyId lower = limb(1);
            pins.push_back(world.add(kodo::RevoluteJoint{
                .ends = {.a = torso, .b = upper, .anchorA = root, .anchorB = {-end.x / 2, 0}}}));
            pins.push_back(world.add(kodo::RevoluteJoint{.ends = {.a = upper,
                                                                  .b = lower,
                                                                  .anchorA = {end.x / 2, 0},
                                                                  .anchorB = {-end.x / 2, 0}}}));
        }
        for (Real t = 0; t < 5; t += setting.dt) {
            world.step(setting.dt);
            for (const kodo::JointId pin : pins) {
                ASSERT_LT(gapOf(world, pin), 0.01) << t;
            }
        }
        Vec2 momentum{};
        Real mass = 0;
        for (const BodyId id : world.bodies()) {
            momentum = momentum + world[id].mass() * world[id].velocity();
            mass += world[id].mass();
        }
        EXPECT_NEAR(momentum.x, mass, 1e-3 * static_cast<double>(mass));
        EXPECT_NEAR(momentum.y, 0, 1e-3 * static_cast<double>(mass));
    });
}

// A hinge that is taken away and set again at another angle turns its body by a whole turn.
// https://github.com/EsotericSoftware/spine-runtimes/issues/1636
TEST(FieldPins, AHingeThatIsSetAgainDoesNotTurnItsBody) {
    inAllSettings([](const Setting& setting) {
        for (const int degrees : {-190, -170, -90, 90, 170, 190}) {
            World world = setting.world({});
            const Real angle = static_cast<Real>(degrees) * kPi / 180;
            const BodyId base = world.add({.type = BodyType::Static});
            const BodyId arm = world.add({.shape = kodo::Box{2, Real(0.2)},
                                          .position = kodo::Rot::fromAngle(angle) * Vec2{1, 0},
                                          .rotation = kodo::Rot::fromAngle(angle)});
            const kodo::RevoluteJoint hinge{.ends = {.a = base, .b = arm, .anchorB = {-1, 0}},
                                            .reference = angle,
                                            .limits = kodo::Range{Real(-0.2), Real(0.2)}};
            for (int i = 0; i < 3; ++i) {
                const kodo::JointId pin = world.add(hinge);
                setting.run(world, Real(0.5));
                ASSERT_NEAR(world.jointState(pin).angle, 0, 1e-3) << degrees;
                ASSERT_NEAR(world[arm].angularVelocity(), 0, 1e-3) << degrees;
                world.remove(pin);
            }
        }
    });
}

// Of many ragdolls, the joints of those after the 1639th do not hold.
// https://github.com/needle-mirror/com.unity.physics/issues/1
TEST(FieldPins, TheLastOfManyRagdollsHangsTogether) {
    for (const bool thesis : {false, true}) {
        World world(
            {.gravity = {0, -10}, .settings = thesis ? kodo::thesis2006() : kodo::balanced()});
        std::vector<kodo::JointId> pins;
        for (int i = 0; i < 1700; ++i) {
            const Vec2 at{static_cast<Real>(2 * (i % 50)), static_cast<Real>(2 * (i / 50))};
            const BodyId hook = world.add(
                {.shape = kodo::Circle{Real(0.1)}, .position = at, .type = BodyType::Static});
            const BodyId arm =
                world.add({.shape = kodo::Box{1, Real(0.1)}, .position = at + Vec2{Real(0.5), 0}});
            pins.push_back(world.add(
                kodo::RevoluteJoint{.ends = {.a = hook, .b = arm, .anchorB = {Real(-0.5), 0}}}));
        }
        run(world, Real(0.25));
        const Real first = world.jointState(pins.front()).angle;
        EXPECT_LT(first, -0.3);
        for (const kodo::JointId pin : pins) {
            ASSERT_LT(gapOf(world, pin), 0.002);
            ASSERT_NEAR(world.jointState(pin).angle, first, 1e-3);
        }
    }
}

// A push turns a door with a tenth of its impulse, the first time and in some directions.
// https://github.com/godot-jolt/godot-jolt/issues/733
TEST(FieldPins, ADoorTurnsByThePushInEveryDirection) {
    inAllSettings([](const Setting& setting) {
        for (int eighth = 0; eighth < 8; ++eighth) {
            for (const Real push : {Real(-0.1), Real(0.1)}) {
                World world = setting.world({});
                const kodo::Rot turn = kodo::Rot::fromAngle(static_cast<Real>(eighth) * kPi / 4);
                const BodyId frame = world.add({.type = BodyType::Static});
                const BodyId door = world.add({.shape = kodo::Box{1, Real(0.1)},
                                               .position = turn * Vec2{Real(0.5), 0},
                                               .rotation = turn});
                world.add(kodo::RevoluteJoint{
                    .ends = {.a = frame, .b = door, .anchorB = {Real(-0.5), 0}}});
                setting.run(world, Real(0.5));
                const Real inertia = // about the hinge
                    world[door].inertia() + world[door].mass() * Real(0.25);
                world[door].applyAngularImpulse(push);
                world.step(setting.dt);
                world.step(setting.dt);
                EXPECT_NEAR(world[door].angularVelocity() * inertia, push, 1e-4) << eighth;
            }
        }
    });
}

// The lower limit of a hinge is ignored. https://github.com/godot-jolt/godot-jolt/issues/364
TEST(FieldPins, AFlapFallsToItsLowerLimitAndRests) {
    inAllSettings([](const Setting& setting) {
        for (const Real lower : {Real(-0.2), Real(-1)}) {
            World world = setting.world();
            const BodyId wall = world.add({.type = BodyType::Static});
            const BodyId flap =
                world.add({.shape = kodo::Box{1, Real(0.1)}, .position = {Real(0.5), 0}});
            const kodo::JointId pin = world.add(
                kodo::RevoluteJoint{.ends = {.a = wall, .b = flap, .anchorB = {Real(-0.5), 0}},
                                    .limits = kodo::Range{lower, Real(0.5)}});
            Real lowest = 0;
            for (Real t = 0; t < 3; t += setting.dt) {
                world.step(setting.dt);
                lowest = std::min(lowest, world.jointState(pin).angle);
            }
            EXPECT_GT(lowest, lower - Real(0.03));
            EXPECT_NEAR(world.jointState(pin).angle, lower, 0.01);
            EXPECT_NEAR(world[flap].angularVelocity(), 0, 1e-3);
        }
    });
}

} // namespace
} // namespace field
