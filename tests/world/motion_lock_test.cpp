// SPDX-License-Identifier: MIT
#include "support/solver.hpp"
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::kDt;
using support::kSolvers;
using support::near;
using support::settingsOf;
using support::slippery;
using support::Solver;

// R8: kLockMove means infinite mass. Gravity and impulses cause no translation, but an off-centre
// impulse causes rotation.
TEST(MotionLock, LockMoveAllowsRotationOnly) {
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

// R8: kLockRotate means infinite moment of inertia. An off-centre impulse causes translation only.
TEST(MotionLock, LockRotateAllowsTranslationOnly) {
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

// R8, R7: a body without rotation, by a motion lock or without Feature::Rotation, lands flat.
// Friction reduces its tangential speed by mu (1 + e) times its normal speed.
TEST(MotionLock, FrictionBrakesABodyThatLandsFlatWithoutRotation) {
    for (const Solver strategy : kSolvers) {
        for (const bool leftOut : {false, true}) {
            for (const Real restitution : {Real(0), Real(0.5)}) {
                SCOPED_TRACE(testing::Message() << static_cast<int>(strategy) << ", " << leftOut
                                                << ", e " << restitution);
                WorldDef def;
                def.settings = settingsOf(strategy);
                def.settings.leaveOut = leftOut ? Feature::Rotation : Features();
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

TEST(BodyType, AKinematicBodyKeepsItsVelocityUnderForces) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, 0}, 1, 1);
    def.type = BodyType::Kinematic;
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

// An impact does not change a kinematic body. The other body bounces off as from a wall.
TEST(BodyType, AnImpactDoesNotMoveAKinematicBody) {
    World world;
    BodyDef def = boxDef({0, 0}, 1, 1, slippery(1));
    def.type = BodyType::Kinematic;
    const BodyId wall = world.add(def);
    BodyDef ball = ballDef({-2, 0}, Real(0.5), slippery(1));
    ball.velocity = {4, 0};
    const BodyId id = world.add(ball);
    support::run(world, 60);
    EXPECT_EQ(world[wall].position(), (Vec2{0, 0}));
    EXPECT_EQ(world[wall].velocity(), (Vec2{0, 0}));
    EXPECT_TRUE(near(world[id].velocity(), Vec2{-4, 0}, 8 * support::kEpsilon));
}

TEST(BodyType, TwoKinematicBodiesPassWithoutARecord) {
    World world;
    BodyDef def = boxDef({0, 0}, 1, 1);
    def.type = BodyType::Kinematic;
    world.add(def);
    def.position = {Real(0.5), 0};
    def.velocity = {-1, 0};
    world.add(def);
    support::run(world, 10);
    EXPECT_TRUE(world.collisions().empty());
}

// A kinematic body hits a body with kLockMove nearly towards its centre, so the lever arm is almost
// 0. The impact must not cause a spin of 1e5 rad/s.
TEST(MotionLock, AnImpactTowardsTheCentreHardlySpinsALockMoveBody) {
    for (const Solver strategy : kSolvers) {
        WorldDef world{};
        world.settings = settingsOf(strategy);
        for (const Real offset : {Real(0), Real(1e-5), Real(1e-3)}) {
            SCOPED_TRACE(offset);
            World scene(world);
            BodyDef def = ballDef({0, offset}, Real(0.5), withFriction(Real(0.5), Real(0.5)));
            def.flags = kLockMove;
            const BodyId wheel = scene.add(def);
            def = ballDef({-2, 0}, Real(0.5), withFriction(Real(0.5), Real(0.5)));
            def.shape = Compound{{Circle{Real(0.5)}, Circle{Real(0.1), {0, Real(0.4)}}}};
            def.type = BodyType::Kinematic;
            def.velocity = {2, 0};
            scene.add(def);
            support::run(scene, 60);
            // The least lever arm in use is 1/11 of 0.5 m: 3 m/s cause 68 rad/s.
            EXPECT_LT(std::abs(scene[wheel].angularVelocity()), 70);
        }
    }
}

// Two kinematic bodies pinch a plank with kLockMove at unequal distances from its centre. Its
// impact impulses must not grow from one to the next within a step. Between walls that close, an
// elastic plank gains 2 x 3.5 m/s by the lever arm with each bounce, 70 rad/s at 0.1 m; one bounce
// and its friction are allowed in a step.
//
// Bound of an impulse: a soft contact holds 27 times the impulse that stops 6.5 m/s at 64 times the
// mass of the plank. The 6.5 m/s are 3.5 m/s of the walls and 3 m/s of push speed. The factor 4
// covers two contacts on each side, whose manifolds are found again within the step.
TEST(MotionLock, ImpulsesOnAPinchedLockMoveBodyStayBounded) {
    for (const Solver strategy : kSolvers) {
        for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(strategy) << ", " << restitution);
            World world({.settings = settingsOf(strategy)});
            const Material material = withFriction(Real(0.6), restitution);
            BodyDef def = boxDef({0, 0}, 2, Real(0.5), material);
            def.flags = kLockMove;
            const BodyId plank = world.add(def); // 1 kg
            def.type = BodyType::Kinematic;
            def.shape = Compound{{Box{Real(0.2), 1, {Real(-0.15), 0}}, Box{Real(0.2), 1, {1, 0}}}};
            def.position = {0, 1};
            def.velocity = {0, -3};
            def.angularVelocity = Real(0.5);
            world.add(def);
            def.position = {0, -1};
            def.velocity = {0, 3};
            world.add(def);
            for (int step = 0; step < 60; ++step) {
                const Real before = std::abs(world[plank].angularVelocity());
                world.step(kDt);
                EXPECT_LT(std::abs(world[plank].angularVelocity()), before + 100) << step;
                for (const CollisionRecord& record : world.collisions()) {
                    ASSERT_LT(record.maxImpulse, Real(27 * 64 * 6.5 * 4)) << step;
                }
            }
            EXPECT_TRUE(world.frozenBodies().empty());
        }
    }
}

TEST(BodyType, CanBeChangedBetweenSteps) {
    World world({.gravity = support::kEarth});
    const BodyId ball = world.add(ballDef({0, 10}, 1));
    world[ball].setType(BodyType::Kinematic);
    support::run(world, 10);
    EXPECT_EQ(world[ball].position(), (Vec2{0, 10}));
    world[ball].setType(BodyType::Dynamic);
    support::run(world, 10);
    EXPECT_LT(world[ball].position().y, 10);
    EXPECT_TRUE(near(world[ball].mass(), std::numbers::pi_v<long double>, 4 * support::kEpsilon));
}

// R8, R9: disabled or filtered bodies fall through the floor; others do not.
TEST(BodyFlags, DisabledOrFilteredBodiesDoNotCollide) {
    World world({.gravity = support::kEarth});
    BodyDef floor = boxDef({0, Real(-0.5)}, 100, 1);
    floor.type = BodyType::Kinematic;
    floor.flags = 0b01;
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
    // A change of flags applies at once.
    world[normal].setFlags(kDisabled);
    world[pleased].setRequired(0b10);
    support::run(world, 120);
    EXPECT_LT(world[normal].position().y, -5);
    EXPECT_LT(world[pleased].position().y, -5);
}

} // namespace
} // namespace kodo
