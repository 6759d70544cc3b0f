// SPDX-License-Identifier: MIT
// Reports on springs, ropes, sliders, suspensions, and on what bodies held by joints do to others,
// in both solvers at several rates.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "field_scene.hpp"

namespace field {
namespace {

// A rope of 1 m lets its load fall by 1.7 m. https://github.com/dimforge/rapier/issues/561
TEST(FieldAssemblies, ALoadFallsToTheEndOfItsRopeAndNoFarther) {
    inAllSettings([](const Setting& setting) {
        for (const Real density : {Real(1), Real(1000)}) {
            World world = setting.world();
            const BodyId hook = world.add({.position = {0, 5}, .type = BodyType::Static});
            const BodyId load = world.add(
                {.shape = kodo::Circle{Real(0.1)}, .position = {0, 5}, .density = density});
            world.add(
                kodo::DistanceJoint{.ends = {.a = hook, .b = load}, .limits = kodo::Range{0, 1}});
            Real lowest = 5;
            for (Real t = 0; t < 3; t += setting.dt) {
                world.step(setting.dt);
                lowest = std::min(lowest, world[load].position().y);
            }
            EXPECT_GT(lowest, 3.98) << density;
            EXPECT_NEAR(world[load].position().y, 4, 2e-3) << density;
            EXPECT_NEAR(world[load].velocity().y, 0, 1e-3) << density;
        }
    });
}

// A box with wheels on sliders that act as springs drifts and shakes.
// https://github.com/dimforge/rapier/issues/172
TEST(FieldAssemblies, ABoxOnSlidersWithSpringsRestsByHookesLaw) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId box = world.add({.shape = kodo::Box{2, Real(0.5)}, .position = {0, 1}});
        for (const Real x : {Real(-0.8), Real(0.8)}) {
            const BodyId wheel =
                world.add({.shape = kodo::Circle{Real(0.25)}, .position = {x, Real(0.25)}});
            world.add(kodo::PrismaticJoint{.ends = {.a = box, .b = wheel, .anchorA = {x, 0}},
                                           .axis = {0, -1},
                                           .target = Real(0.75),
                                           .hertz = 2,
                                           .damping = 1});
        }
        setting.run(world, 6);
        EXPECT_NEAR(world[box].position().x, 0, 0.02);
        EXPECT_NEAR(world[box].rotation().angle(), 0, 1e-3);
        EXPECT_LT(length(world[box].velocity()), 2e-3);
        if (setting.thesis && setting.dt > Real(0.02)) {
            return; // one substep of 1/30 s is too long for such a spring
        }
        // Each spring has k = (2 pi f)^2 m1 m2 / (m1 + m2) and carries half the box, 5 N.
        const Real disc = std::numbers::pi_v<Real> / 16;
        const Real stiffness =
            16 * std::numbers::pi_v<Real> * std::numbers::pi_v<Real> * disc / (1 + disc);
        EXPECT_NEAR(world[box].position().y, 1 - 5 / stiffness, 0.01);
    });
}

// A ring of bodies on springs swings more and more until it is gone.
// https://github.com/godotengine/godot/issues/16922
TEST(FieldAssemblies, ASoftRingOfSpringsComesToRest) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId hub = world.add({.shape = kodo::Circle{Real(0.3)}, .position = {0, 3}});
        constexpr int kCount = 10;
        std::vector<BodyId> ring;
        for (int i = 0; i < kCount; ++i) {
            const kodo::Rot turn =
                kodo::Rot::fromAngle(static_cast<Real>(i) * 2 * std::numbers::pi_v<Real> / kCount);
            ring.push_back(world.add(
                {.shape = kodo::Circle{Real(0.25)}, .position = Vec2{0, 3} + turn * Vec2{1, 0}}));
        }
        const auto spring = [&](BodyId a, BodyId b) {
            const Real rest = length(world[b].position() - world[a].position());
            world.add(kodo::DistanceJoint{
                .ends = {.a = a, .b = b}, .length = rest, .hertz = 8, .damping = Real(0.3)});
        };
        for (std::size_t i = 0; i < ring.size(); ++i) {
            spring(hub, ring[i]);
            spring(ring[i], ring[(i + 1) % ring.size()]);
        }
        for (Real t = 0; t < 10; t += setting.dt) {
            world.step(setting.dt);
            ASSERT_LT(length(world[hub].position()), 4) << t;
            ASSERT_LT(length(world[hub].velocity()), 9) << t; // it falls 3 m at most
        }
        for (const BodyId id : ring) {
            EXPECT_LT(length(world[id].velocity()), 0.2);
            EXPECT_LT(length(world[id].position() - world[hub].position()), 1.5);
        }
    });
}

// A spring comes to rest at another length than its rest length, and can be pulled beyond its
// largest. https://github.com/appsinacup/godot-box2d/issues/65
TEST(FieldAssemblies, ASpringRestsAtItsLengthWithinItsLimits) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world({});
        const BodyId base = world.add({.type = BodyType::Static});
        const BodyId load = world.add({.shape = kodo::Box{1, 1}, .position = {3, 0}});
        const kodo::JointId spring =
            world.add(kodo::DistanceJoint{.ends = {.a = base, .b = load},
                                          .length = 2,
                                          .hertz = 2,
                                          .damping = Real(0.5),
                                          .limits = kodo::Range{Real(1.5), 4}});
        setting.run(world, 4);
        EXPECT_NEAR(world.jointState(spring).length, 2, 1e-3);
        for (const Real force : {Real(-2000), Real(2000)}) {
            for (Real t = 0; t < 1; t += setting.dt) {
                world[load].applyForce({force, 0});
                world.step(setting.dt);
                ASSERT_GT(world.jointState(spring).length, 1.5 - 0.05) << force;
                ASSERT_LT(world.jointState(spring).length, 4 + 0.05) << force;
            }
        }
    });
}

// A spring whose length is changed while it acts keeps the old one.
// https://github.com/godotengine/godot/issues/6178
TEST(FieldAssemblies, ASpringTakesANewLengthAlsoWhileItsBodySleeps) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        const BodyId hook = world.add({.position = {0, 5}, .type = BodyType::Static});
        const BodyId load = world.add({.shape = kodo::Box{1, 1}, .position = {0, 4}});
        const kodo::JointId spring = world.add(
            kodo::DistanceJoint{.ends = {.a = hook, .b = load}, .hertz = 2, .damping = 1});
        setting.run(world, 6);
        EXPECT_TRUE(world[load].isAsleep());
        const Real before = world[load].position().y;
        world.changeJoint<kodo::DistanceJoint>(
            spring, [](kodo::DistanceJoint& joint) { joint.length = 3; });
        setting.run(world, 6);
        EXPECT_NEAR(world[load].position().y, before - 2, 5e-3);
    });
}

// Two large discs on stiff sliders at one small disc swing until the program ends.
// https://github.com/erincatto/box2d/issues/984
TEST(FieldAssemblies, LargeDiscsOnSlidersOfASmallOneStayInPlace) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId small = world.add({.shape = kodo::Circle{Real(0.1)}, .position = {0, 2}});
        std::vector<BodyId> all{small};
        for (const Real side : {Real(-1), Real(1)}) {
            all.push_back(world.add({.shape = kodo::Circle{Real(0.5)}, .position = {side, 2}}));
            world.add(kodo::PrismaticJoint{.ends = {.a = small, .b = all.back()},
                                           .limits = kodo::Range{Real(-1.5), Real(1.5)},
                                           .target = side,
                                           .hertz = 10,
                                           .damping = Real(0.5)});
        }
        for (Real t = 0; t < 6; t += setting.dt) {
            world.step(setting.dt);
            for (const BodyId id : all) {
                ASSERT_LT(length(world[id].position()), 6) << t;
                ASSERT_LT(length(world[id].velocity()), 20) << t;
            }
        }
    });
}

// A heavy figure lands on a light car: its wheels leave their sliders and the program ends.
// https://github.com/erincatto/box2d/issues/1007
TEST(FieldAssemblies, WheelsOfALightCarStayOnTheirSlidersUnderAHeavyFigure) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId car =
            world.add({.shape = kodo::Box{3, Real(0.3)}, .position = {0, Real(0.9)}});
        std::array<kodo::JointId, 2> sliders;
        for (const std::size_t i : {0u, 1u}) {
            const Real x = i == 0 ? Real(-1) : Real(1);
            const BodyId wheel =
                world.add({.shape = kodo::Circle{Real(0.4)}, .position = {x, Real(0.4)}});
            sliders[i] = world.add(
                kodo::WheelJoint{.ends = {.a = car, .b = wheel, .anchorA = {x, Real(-0.5)}},
                                 .limits = kodo::Range{Real(-0.2), Real(0.2)},
                                 .hertz = 4,
                                 .damping = Real(0.7)});
        }
        setting.run(world, 1);
        const BodyId figure = world.add({.shape = kodo::Box{Real(0.5), Real(1.5)},
                                         .position = {Real(0.5), 5},
                                         .density = 200,
                                         .flags = kodo::kLockRotate});
        for (Real t = 0; t < 3; t += setting.dt) {
            world.step(setting.dt);
            for (const BodyId id : world.bodies()) {
                ASSERT_LT(length(world[id].position()), 30) << t; // 3 s at the speed of the fall
            }
        }
        EXPECT_LT(length(world[figure].velocity()), setting.thesis ? 10 : 1);
        for (const kodo::JointId slider : sliders) {
            const kodo::JointState state = world.jointState(slider);
            const Vec2 along = world[car].rotation() * Vec2{0, 1};
            EXPECT_LT(std::abs(cross(along, state.anchorB - state.anchorA)), 0.05);
        }
    });
}

// A wheel joint without suspension, its axis nearly level, throws its body out of the world.
// https://github.com/erincatto/box2d/issues/491
TEST(FieldAssemblies, AWheelWithoutSuspensionOnALevelAxisFallsFreelyAlongIt) {
    inAllSettings([](const Setting& setting) {
        for (const Vec2 axis :
             {Vec2{Real(-0.999549448), Real(0.030014623)}, Vec2{1, 0}, Vec2{0, -1}}) {
            World world = setting.world();
            const BodyId base = world.add({.type = BodyType::Static});
            const BodyId body = world.add({.shape = kodo::Box{1, 1}});
            world.add(kodo::WheelJoint{.ends = {.a = base, .b = body}, .axis = normalize(axis)});
            setting.run(world, 2);
            const Vec2 unit = normalize(axis);
            const Real way = dot(unit, Vec2{0, -10}) * 2; // g sin(slope) t^2 / 2
            EXPECT_NEAR(dot(unit, world[body].position()), way,
                        Real(0.02) * std::abs(way) + 20 * setting.dt * std::abs(unit.y));
            EXPECT_NEAR(cross(unit, world[body].position()), 0, 0.01);
        }
    });
}

// A slider along a diagonal drifts and trembles at its limit.
// https://github.com/erincatto/box2d/issues/69
TEST(FieldAssemblies, AMotorOnADiagonalHoldsAPlatformAtItsLimit) {
    inAllSettings([](const Setting& setting) {
        const Real root = 1 / std::numbers::sqrt2_v<Real>;
        for (const Vec2 axis : {Vec2{root, root}, Vec2{-root, root}, Vec2{0, 1}}) {
            for (const Real speed : {Real(0), Real(2)}) {
                World world = setting.world();
                const BodyId base = world.add({.type = BodyType::Static});
                const BodyId platform = world.add({.shape = kodo::Box{2, Real(0.5)}});
                const kodo::JointId slider =
                    world.add(kodo::PrismaticJoint{.ends = {.a = base, .b = platform},
                                                   .axis = axis,
                                                   .limits = kodo::Range{-3, 3},
                                                   .motorSpeed = speed,
                                                   .motorForce = 100});
                setting.run(world, 3);
                const Vec2 place = world[platform].position();
                EXPECT_NEAR(world.jointState(slider).translation, speed > 0 ? 3 : 0, 0.01);
                EXPECT_NEAR(cross(axis, place), 0, 1e-3);
                setting.run(world, 1);
                EXPECT_LT(length(world[platform].position() - place), 2e-3);
                EXPECT_LT(length(world[platform].velocity()), speed > 0 ? 0.02 : 1e-3);
            }
        }
    });
}

// A raft of a plank and pontoons on fixed joints spins when forces lift the pontoons for the first
// time. https://github.com/avianphysics/avian/issues/296
TEST(FieldAssemblies, EqualForcesOnPontoonsLiftARaftWithoutSpin) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        const BodyId raft = world.add({.shape = kodo::Box{4, Real(0.2)}});
        std::vector<BodyId> pontoons;
        for (const Real x : {Real(-1.8), Real(-0.6), Real(0.6), Real(1.8)}) {
            pontoons.push_back(
                world.add({.shape = kodo::Circle{Real(0.25)}, .position = {x, Real(-0.35)}}));
            world.add(kodo::FixedJoint{
                .ends = {.a = raft, .b = pontoons.back(), .anchorA = {x, Real(-0.35)}}});
        }
        Real mass = world[raft].mass();
        for (const BodyId id : pontoons) {
            mass += world[id].mass();
        }
        setting.run(world, Real(0.5)); // falls freely
        const Real speed = world[raft].velocity().y;
        for (Real t = 0; t < 1; t += setting.dt) {
            for (const BodyId id : pontoons) {
                world[id].applyForce({0, mass * 15 / 4}); // g and 5 m/s^2 more
            }
            world.step(setting.dt);
            ASSERT_NEAR(world[raft].angularVelocity(), 0, 1e-3) << t;
        }
        EXPECT_NEAR(world[raft].velocity().y, speed + 5, 0.2);
        EXPECT_NEAR(world[raft].rotation().angle(), 0, 1e-3);
    });
}

// A body that something drags through a pool of others passes them without moving them.
// https://github.com/jrouwe/JoltPhysics/issues/486
TEST(FieldAssemblies, ADraggedBodyPushesThePoolAside) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        for (const Real x : {Real(-3), Real(3)}) {
            world.add({.shape = kodo::Box{Real(0.5), 3},
                       .position = {x, Real(1.5)},
                       .type = BodyType::Static});
        }
        std::vector<BodyId> pool;
        for (int i = 0; i < 30; ++i) {
            const Real x = Real(-2.4) + Real(0.5) * static_cast<Real>(i % 10);
            pool.push_back(
                world.add({.shape = kodo::Circle{Real(0.2)},
                           .position = {x, Real(0.25) + Real(0.45) * static_cast<Real>(i / 10)}}));
        }
        const BodyId dragged =
            world.add({.shape = kodo::Box{1, 1}, .position = {-2, 4}, .density = 2});
        const kodo::JointId mouse =
            world.add(kodo::MouseJoint{.body = dragged, .target = {-2, 4}, .force = 1000});
        for (Real t = 0; t < 4; t += setting.dt) {
            world.changeJoint<kodo::MouseJoint>(mouse, [&](kodo::MouseJoint& joint) {
                joint.target = t < 1 ? Vec2{-2, 4 - 3 * t} : Vec2{-2 + (t - 1) * Real(1.3), 1};
            });
            world.step(setting.dt);
            for (const BodyId ball : pool) {
                ASSERT_LT(std::abs(world[ball].position().x), 6) << t;
            }
        }
        int right = 0;
        for (const BodyId ball : pool) {
            const Vec2 away = world[ball].position() - world[dragged].position();
            right += world[ball].position().x > 0 ? 1 : 0;
            EXPECT_GT(length(away), 0.6); // 0.5 and 0.2, less a few centimetres
        }
        EXPECT_GT(right, 12);
    });
}

// A ball that passes a block without touching it is told as a collision. Here it may be told up to
// 5 mm, since parts within a slop count as touching.
// https://github.com/avianphysics/avian/issues/224
TEST(FieldAssemblies, ABallThatPassesNearABlockHasNoRecord) {
    inAllSettings([](const Setting& setting) {
        for (const Real gap : {Real(0.01), Real(0.03)}) {
            for (const Real speed : {Real(1), Real(10), Real(60)}) {
                World world = setting.world({});
                world.add({.shape = kodo::Box{1, 1}, .type = BodyType::Static});
                const BodyId ball = world.add({.shape = kodo::Circle{Real(0.25)},
                                               .position = {-2, Real(0.75) + gap},
                                               .velocity = {speed, 0}});
                for (Real t = 0; t < 4 / speed; t += setting.dt) {
                    world.step(setting.dt);
                    ASSERT_TRUE(world.collisions().empty()) << gap << ", " << speed;
                }
                EXPECT_EQ(world[ball].velocity(), (Vec2{speed, 0}));
            }
        }
    });
}

// A box sleeps within a sensor. When other bodies begin to touch, elsewhere, the sensor loses it.
// https://github.com/jrouwe/JoltPhysics/issues/130
TEST(FieldAssemblies, ASensorKeepsASleeperWhileOthersBeginToTouch) {
    inAllSettings([](const Setting& setting) {
        World world = setting.world();
        addGround(world);
        const BodyId sensor = world.add({.shape = kodo::Box{3, 3},
                                         .position = {0, Real(1.5)},
                                         .type = BodyType::Static,
                                         .flags = kodo::kSensor});
        const BodyId box = world.add({.shape = kodo::Box{1, 1}, .position = {0, Real(0.5)}});
        setting.run(world, 3);
        ASSERT_TRUE(world[box].isAsleep());
        world.add({.shape = kodo::Box{1, 1}, .position = {6, 2}});
        for (Real t = 0; t < 2; t += setting.dt) {
            world.step(setting.dt);
            for (const kodo::CollisionRecord& record : world.endedCollisions()) {
                ASSERT_FALSE(record.involves(sensor)) << t;
            }
            ASSERT_EQ(touching(world, sensor), std::vector<BodyId>{box}) << t;
        }
        world[box].setPosition({-10, Real(0.5)});
        world.step(setting.dt);
        EXPECT_TRUE(touching(world, sensor).empty());
    });
}

} // namespace
} // namespace field
