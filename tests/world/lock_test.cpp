// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::kDt;
using support::near;
using support::slippery;

// R8: LOCK_MOVE: infinite mass. Neither gravity nor a blow moves it, but a blow may turn it.
TEST(Lock, LockMoveTurnsButDoesNotMove) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, 0}, 4, 1);
    def.flags = kLockMove;
    const BodyId beam = world.add(def);
    world[beam].applyImpulse({0, 10}, {2, 0});
    support::run(world, 60);
    EXPECT_EQ(world[beam].center(), (Vec2{0, 0}));
    EXPECT_EQ(world[beam].velocity(), (Vec2{0, 0}));
    EXPECT_GT(world[beam].angularVelocity(), 1);
}

// R8: LOCK_ROTATE: infinite inertia. An off-centre blow moves it straight.
TEST(Lock, LockRotateMovesButDoesNotTurn) {
    World world;
    BodyDef def = boxDef({0, 0}, 4, 1);
    def.flags = kLockRotate;
    const BodyId beam = world.add(def);
    world[beam].applyImpulse({0, 8}, {2, 0});
    world[beam].applyTorque(1000);
    support::run(world, 60);
    EXPECT_EQ(world[beam].rotation(), Rot{});
    EXPECT_EQ(world[beam].angularVelocity(), 0);
    EXPECT_EQ(world[beam].velocity(), (Vec2{0, 2}));
}

// R8, R7: what cannot turn, by a lock or since turning is left out, is braked by what it lands flat
// on like anything else: by mu (1 + e) of the speed that it lands with.
TEST(Lock, FrictionBrakesWhatLandsFlatAndCannotTurn) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        for (const bool leftOut : {false, true}) {
            for (const Real restitution : {Real(0), Real(0.5)}) {
                SCOPED_TRACE(testing::Message() << static_cast<int>(strategy) << ", " << leftOut
                                                << ", e " << restitution);
                WorldDef def;
                def.settings = strategy == Strategy::Propagation ? thesis2006() : StepSettings{};
                def.settings.leaveOut = leftOut ? static_cast<std::uint8_t>(Feature::Rotation) : 0;
                World world(def);
                const Material material = withFriction(Real(0.5), restitution);
                support::addFloor(world, material);
                BodyDef box = boxDef({0, Real(0.5)}, 1, 1, material);
                box.velocity = {10, -5};
                box.flags = leftOut ? 0 : kLockRotate;
                const BodyId id = world.add(box);
                support::run(world, 2);
                const Real kept = 10 - Real(0.5) * (1 + restitution) * 5;
                EXPECT_TRUE(near(world[id].velocity(), Vec2{kept, 5 * restitution},
                                 32 * support::kEpsilon)); // roundings of 10 m/s
                EXPECT_EQ(world[id].angularVelocity(), 0);
            }
        }
    }
}

TEST(Lock, LockedMovesOnlyAsItIsTold) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, 0}, 1, 1);
    def.flags = kLocked;
    def.velocity = {1, 0};
    def.angularVelocity = 1;
    const BodyId body = world.add(def);
    world[body].applyForce({0, 1000});
    world[body].applyImpulse({0, 1000}, {3, 0});
    support::run(world, 60);
    EXPECT_EQ(world[body].velocity(), (Vec2{1, 0}));
    EXPECT_EQ(world[body].angularVelocity(), 1);
    // 60 steps of 1/60 s, each rounded.
    EXPECT_TRUE(near(world[body].position(), Vec2{1, 0}, support::byPrecision(1e-5, 1e-13)));
}

// A locked body is hit without a trace, and the other one bounces off as from a wall.
TEST(Lock, ABlowDoesNotMoveALockedBody) {
    World world;
    BodyDef def = boxDef({0, 0}, 1, 1, slippery(1));
    def.flags = kLocked;
    const BodyId wall = world.add(def);
    BodyDef ball = ballDef({-2, 0}, Real(0.5), slippery(1));
    ball.velocity = {4, 0};
    const BodyId id = world.add(ball);
    support::run(world, 60);
    EXPECT_EQ(world[wall].position(), (Vec2{0, 0}));
    EXPECT_EQ(world[wall].velocity(), (Vec2{0, 0}));
    EXPECT_TRUE(near(world[id].velocity(), Vec2{-4, 0}, 8 * support::kEpsilon));
}

TEST(Lock, TwoLockedBodiesPassThroughEachOtherUnrecorded) {
    World world;
    BodyDef def = boxDef({0, 0}, 1, 1);
    def.flags = kLocked;
    world.add(def);
    def.position = {Real(0.5), 0};
    def.velocity = {-1, 0};
    world.add(def);
    support::run(world, 10);
    EXPECT_TRUE(world.collisions().empty());
}

// What can only turn, and is struck straight towards its hinge by what cannot give way either, has
// hardly a lever: the blow must not spin it with 1e5 rad/s to make up for that.
TEST(Lock, ABlowTowardsTheHingeDoesNotSpinABodyThatCannotMove) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        WorldDef world{};
        world.settings = strategy == Strategy::Propagation ? thesis2006() : StepSettings{};
        for (const Real offset : {Real(0), Real(1e-5), Real(1e-3)}) {
            SCOPED_TRACE(offset);
            World scene(world);
            BodyDef def = ballDef({0, offset}, Real(0.5), withFriction(Real(0.5), Real(0.5)));
            def.flags = kLockMove;
            const BodyId wheel = scene.add(def);
            def = ballDef({-2, 0}, Real(0.5), withFriction(Real(0.5), Real(0.5)));
            def.shape = Compound{{Circle{Real(0.5)}, Circle{Real(0.1), {0, Real(0.4)}}}};
            def.flags = kLocked;
            def.velocity = {2, 0};
            scene.add(def);
            support::run(scene, 60);
            // At the least lever that counts, an 11th of 0.5 m: 3 m/s make 68 rad/s.
            EXPECT_LT(std::abs(scene[wheel].angularVelocity()), 70);
        }
    }
}

// What can only turn, and is pinched by something that comes down on it at unlike distances from
// its hinge, is neither struck at two points as if it could not turn, nor to and fro within one
// step, each blow harder than the one before. What presses is a spring that holds 27 times what
// takes 3.5 m/s of the walls and 3 m/s of the push from 64 times its mass, and may be shared by two
// on each side.
TEST(Lock, WhatCanOnlyTurnIsNotPinchedEverHarder) {
    for (const Strategy strategy : {Strategy::SoftStep, Strategy::Propagation}) {
        for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(strategy) << ", " << restitution);
            World world(
                {.settings = strategy == Strategy::Propagation ? thesis2006() : StepSettings{}});
            const Material material = withFriction(Real(0.6), restitution);
            BodyDef def = boxDef({0, 0}, 2, Real(0.5), material);
            def.flags = kLockMove;
            const BodyId plank = world.add(def); // 1 kg
            def.flags = kLocked;
            def.shape = Compound{{Box{Real(0.2), 1, {Real(-0.15), 0}}, Box{Real(0.2), 1, {1, 0}}}};
            def.position = {0, 1};
            def.velocity = {0, -3};
            def.angularVelocity = Real(0.5);
            world.add(def);
            def.position = {0, -1};
            def.velocity = {0, 3};
            world.add(def);
            for (int step = 0; step < 60; ++step) {
                world.step(kDt);
                EXPECT_LT(std::abs(world[plank].angularVelocity()), 300) << step;
                for (const CollisionRecord& record : world.collisions()) {
                    ASSERT_LT(record.maxImpulse, Real(27 * 64 * 6.5 * 2)) << step;
                }
            }
            EXPECT_TRUE(world.frozenBodies().empty());
        }
    }
}

TEST(Lock, CanBeSetAndTakenOff) {
    World world({.gravity = support::kEarth});
    const BodyId ball = world.add(ballDef({0, 10}, 1));
    world[ball].setFlags(kLocked);
    support::run(world, 10);
    EXPECT_EQ(world[ball].position(), (Vec2{0, 10}));
    world[ball].setFlags(0);
    support::run(world, 10);
    EXPECT_LT(world[ball].position().y, 10);
    EXPECT_TRUE(near(world[ball].mass(), std::numbers::pi_v<long double>, 4 * support::kEpsilon));
}

// R8, R9: what is disabled, or filtered, falls through the floor; the other one does not.
TEST(Lock, FlagsDecideWhatMeets) {
    World world({.gravity = support::kEarth});
    BodyDef floor = boxDef({0, Real(-0.5)}, 100, 1);
    floor.flags = kLocked | 0b01;
    world.add(floor);
    BodyDef def = ballDef({0, 1}, Real(0.5));
    const BodyId normal = world.add(def);
    def.position.x = 10;
    def.flags = kDisabled;
    const BodyId disabled = world.add(def);
    def.position.x = 20;
    def.flags = kMatchAny;
    def.required = 0b10;
    const BodyId picky = world.add(def);
    def.position.x = 30;
    def.required = 0b11;
    const BodyId pleased = world.add(def);
    support::run(world, 120);
    EXPECT_GT(world[normal].position().y, 0);
    EXPECT_LT(world[disabled].position().y, -5);
    EXPECT_LT(world[picky].position().y, -5);
    EXPECT_GT(world[pleased].position().y, 0);
    // A change of flags acts at once.
    world[normal].setFlags(kDisabled);
    world[pleased].setRequired(0b10);
    support::run(world, 120);
    EXPECT_LT(world[normal].position().y, -5);
    EXPECT_LT(world[pleased].position().y, -5);
}

} // namespace
} // namespace kodo
