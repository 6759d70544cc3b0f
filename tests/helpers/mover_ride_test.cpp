// SPDX-License-Identifier: MIT
#include <helpers/mover_scenes.hpp>

#include <cmath>

namespace kodo {
namespace {

using support::addStatic;
using support::ground;
using support::kGravity;
using support::kShapes;
using support::kStep;
using support::standing;
using support::tick;

BodyId addPlatform(World& world, Vec2 position, const Shape& shape = Box{6, Real(0.5)}) {
    return world.add({.shape = shape, .position = position, .type = BodyType::Kinematic});
}

// dimforge/rapier#488 and godotengine/godot#30311: movers that dip into a lift, or slip on it.
TEST(Mover, IsCarriedByAPlatformExactly) {
    for (const Primitive& shape : kShapes) {
        World world;
        const BodyId lift = addPlatform(world, {0, 0});
        Mover mover = standing(world, shape, {1, 2});
        const Vec2 arm = mover.position - world[lift].position();
        for (int i = 0; i < 600; ++i) {
            const Real t = static_cast<Real>(i) * kStep;
            world[lift].moveTo({8 * std::sin(t), 5 * std::sin(Real(1.7) * t)}, kStep);
            tick(world, mover, 0);
            ASSERT_TRUE(mover.grounded) << i;
            ASSERT_EQ(mover.groundBody, lift);
            ASSERT_EQ(mover.velocity, Vec2{});
            const Vec2 slip = mover.position - world[lift].position() - arm;
            ASSERT_LT(length(slip), 0.001) << i; // rounding of 600 steps
        }
    }
}

TEST(Mover, RidesOnATurningPlatform) {
    World world;
    const BodyId wheel = addPlatform(world, {0, 0}, Circle{3});
    Mover mover = standing(world, kShapes[1], {0, 4});
    world[wheel].setAngularVelocity(Real(0.5));
    tick(world, mover, 0);
    for (int i = 0; i < 60; ++i) {
        tick(world, mover, 0);
        ASSERT_TRUE(mover.grounded);
    }
    // After 61 steps of 0.5 rad/s. The mover stays upright, so its contact moves a little.
    EXPECT_NEAR(std::atan2(-mover.position.x, mover.position.y), 61 * kStep / 2, 0.03);
}

TEST(Mover, WalksOnAPlatformRelativeToIt) {
    World world;
    const BodyId lift = addPlatform(world, {0, 0}, Box{40, 1});
    Mover mover = standing(world, kShapes[2], {-10, 2});
    world[lift].setVelocity({2, 1});
    tick(world, mover, 3); // the platform has moved once
    const Real from = mover.position.x - world[lift].position().x;
    for (int i = 0; i < 60; ++i) {
        tick(world, mover, 3);
        ASSERT_EQ(mover.velocity.x, 3);
    }
    EXPECT_NEAR(mover.position.x - world[lift].position().x - from, 3, 0.005);
}

TEST(Mover, TakesTheVelocityOfThePlatformIntoAJump) {
    World world;
    const BodyId lift = addPlatform(world, {0, 0}, Box{40, 1});
    Mover mover = standing(world, kShapes[2], {-10, 2});
    world[lift].setVelocity({3, 2});
    tick(world, mover, 0);
    tick(world, mover, 0, 6);
    EXPECT_FALSE(mover.grounded);
    EXPECT_NEAR(mover.velocity.x, 3, 1e-4);
    EXPECT_NEAR(mover.velocity.y, 8, 1e-4);
}

TEST(Mover, RidesOnADynamicBody) {
    World world;
    addStatic(world, Plane{});
    const BodyId raft = world.add({.shape = Box{4, Real(0.5)},
                                   .position = {0, Real(0.25)},
                                   .velocity = {5, 0},
                                   .material = withFriction(0)});
    Mover mover{.shape = kShapes[2], .position = {1, Real(1.01)}};
    tick(world, mover, 0);
    ASSERT_TRUE(mover.grounded);
    const Real arm = mover.position.x - world[raft].position().x;
    for (int i = 0; i < 120; ++i) {
        tick(world, mover, 0);
        ASSERT_TRUE(mover.grounded);
    }
    EXPECT_NEAR(mover.position.x - world[raft].position().x, arm, 0.001);
    EXPECT_GT(world[raft].position().x, 9);
}

TEST(Mover, IsCaughtByAOneWayLiftThatRises) {
    for (const Primitive& shape : kShapes) {
        World world;
        const BodyId lift = addPlatform(world, {0, -3}, Segment{{-3, 0}, {3, 0}, true});
        world[lift].setVelocity({0, 3});
        Mover mover{.shape = shape, .position = {0, 3}};
        for (int i = 0; i < 120; ++i) {
            tick(world, mover, 0);
        }
        EXPECT_TRUE(mover.grounded);
        EXPECT_GT(mover.position.y, world[lift].position().y);
    }
}

TEST(Mover, IsPushedByAWallAndNeverThroughAnother) {
    for (const Primitive& shape : kShapes) {
        World world;
        addStatic(world, ground({{-20, 0}, {6, 0}, {6, 9}}));
        const BodyId ram = addPlatform(world, {-4, 1}, Box{1, 2});
        world[ram].setVelocity({2, 0});
        Mover mover = standing(world, shape, {2, 1});
        for (int i = 0; i < 120; ++i) {
            tick(world, mover, 0);
            ASSERT_LT(mover.position.x, 6);
            ASSERT_GT(mover.position.y, Real(0.3));
        }
        EXPECT_GT(mover.position.x, 4);
    }
}

// Terminal acceleration of a crate that slides: (F - friction m g) / m.
TEST(Mover, PushesWithABoundedForce) {
    World world{{.gravity = {0, -10}}};
    world.add({.shape = Plane{}, .material = withFriction(Real(0.5)), .type = BodyType::Static});
    const BodyId crate = world.add({.shape = Box{1, 1},
                                    .position = {2, Real(0.5)},
                                    .material = withFriction(Real(0.5)),
                                    .density = 10,
                                    .flags = kLockRotate});
    Mover mover = standing(world, kShapes[2], {0, 1});
    mover.pushForce = 40; // below the friction of 50 N
    for (int i = 0; i < 120; ++i) {
        tick(world, mover, 5);
    }
    EXPECT_NEAR(world[crate].position().x, 2, 0.001);
    EXPECT_LT(mover.position.x, world[crate].position().x - Real(0.79));
    mover.pushForce = 80;
    tick(world, mover, 5);
    for (int i = 0; i < 30; ++i) {
        tick(world, mover, 5);
    }
    EXPECT_NEAR(world[crate].velocity().x, Real(0.5) * (80 - 50) / 10, 0.15);
}

// Weightless: a crate whose side it meets at full height gets no spin, to the left and to the
// right.
TEST(Mover, PushesAFlatSideInItsMiddle) {
    for (const Real side : {Real(-1), Real(1)}) {
        for (const Real force : {Real(1), Real(1000)}) {
            for (const int rate : {30, 60, 240}) {
                World world;
                const BodyId crate =
                    world.add({.shape = Box{1, 1}, .position = {side * Real(1.5), 0}});
                Mover mover{.pushForce = force};
                const Real dt = Real(1) / static_cast<Real>(rate);
                for (int i = 0; i < 10 * rate; ++i) {
                    world.step(dt);
                    mover.move(world, {2 * side, 0}, dt);
                }
                EXPECT_NEAR(world[crate].velocity().x, 2 * side, 1e-3) << force << ", " << rate;
                EXPECT_NEAR(world[crate].rotation().angle(), 0, 1e-3) << force << ", " << rate;
                EXPECT_NEAR(world[crate].position().y, 0, 1e-3) << force << ", " << rate;
            }
        }
    }
}

TEST(Mover, LoadsASeesaw) {
    World world{{.gravity = {0, -10}}};
    const BodyId post =
        world.add({.shape = Circle{Real(0.2)}, .position = {0, 1}, .type = BodyType::Static});
    const BodyId board = world.add({.shape = Box{6, Real(0.2)}, .position = {0, 1}});
    world.add(RevoluteJoint{.ends = {.a = post, .b = board, .anchorB = {0, 0}}});
    Mover mover{.shape = kShapes[1], .position = {2, 2}, .weight = 100};
    for (int i = 0; i < 30; ++i) {
        tick(world, mover, 0);
    }
    EXPECT_LT(world[board].rotation().angle(), -0.05);
}

// What falls on the head of a mover stays there: its body holds it.
TEST(Mover, CarriesABodyThatOthersFeel) {
    World world{{.gravity = {0, -10}}};
    addStatic(world, Plane{});
    Mover mover{.shape = kShapes[2], .position = {0, 1}};
    mover.body = world.add(
        {.shape = shapeOf(mover.shape), .position = mover.position, .type = BodyType::Kinematic});
    const BodyId crate = world.add({.shape = Box{1, 1}, .position = {0, 3}});
    for (int i = 0; i < 120; ++i) {
        tick(world, mover, 0);
    }
    EXPECT_TRUE(mover.grounded);
    EXPECT_NEAR(world[mover.body].position().y, mover.position.y, 0.001);
    EXPECT_GT(world[crate].position().y, mover.position.y + Real(0.95));
}

TEST(Mover, IgnoresSensorsAndLeavesGroundThatIsRemoved) {
    World world;
    world.add({.shape = Box{2, 2}, .position = {3, 1}, .type = BodyType::Static, .flags = kSensor});
    const BodyId floor = world.add({.shape = Plane{}, .type = BodyType::Static});
    Mover mover = standing(world, kShapes[0], {0, 1});
    for (int i = 0; i < 60; ++i) {
        tick(world, mover, 6);
    }
    EXPECT_NEAR(mover.position.x, 6, 0.01);
    world.remove(floor);
    tick(world, mover, 0);
    EXPECT_FALSE(mover.grounded);
    EXPECT_EQ(mover.groundBody, BodyId{});
    tick(world, mover, 0);
    EXPECT_LT(mover.velocity.y, 0);
}

} // namespace
} // namespace kodo
