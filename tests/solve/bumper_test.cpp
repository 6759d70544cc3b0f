// SPDX-License-Identifier: MIT
// Restitution above 1: impacts that add energy.
#include <kodo/world.hpp>
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <cmath>

namespace kodo {
namespace {

using support::near;

Material bumperOf(Real restitution, Real friction = 0) {
    Material material = withFriction(friction, restitution);
    material.restitutionRule = MixRule::Maximum;
    return material;
}

/// Runs until the ball leaves the floor.
void runUntilItRises(World& world, BodyId ball) {
    for (int step = 0; step < 120 && !(world[ball].velocity().y > 0); ++step) {
        world.step(support::kDt);
    }
}

// v' = e v, J = (1 + e) m v. A ball without restitution does not take part in the choice.
TEST(Bumper, ThrowsABallBackFasterThanItCame) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real restitution : {Real(1.25), kMaxRestitution}) {
            World world({.settings = support::settingsOf(solver)});
            const BodyId floor = support::addFloor(world, bumperOf(restitution));
            BodyDef def = support::ballDef({0, 2}, Real(0.5), support::slippery());
            def.velocity = {1, -4};
            const BodyId ball = world.add(def);
            Real impulse = 0;
            for (int step = 0; step < 120 && !(world[ball].velocity().y > 0); ++step) {
                world.step(support::kDt);
                const CollisionRecord* const record = support::recordOf(world, floor, ball);
                impulse = record != nullptr ? record->totalImpulse : impulse;
            }
            EXPECT_TRUE(near(world[ball].velocity().y, 4 * restitution, 1e-4));
            EXPECT_TRUE(near(world[ball].velocity().x, 1, 1e-4));
            EXPECT_TRUE(near(impulse, (1 + restitution) * 4 * world[ball].mass(), 1e-3));
        }
    }
}

// Two bumpers at once, with friction, which adds no energy of its own.
TEST(Bumper, ThrowsABallBackFromTwoBumpersAtOnce) {
    World world;
    for (const Real x : {Real(-10), Real(10)}) {
        world.add({.shape = Box{20, 1},
                   .position = {x, Real(-0.5)},
                   .material = bumperOf(Real(1.5), 1),
                   .type = BodyType::Static});
    }
    BodyDef def = support::ballDef({0, 2}, Real(0.5), withFriction(1));
    def.velocity = {0, -4};
    const BodyId ball = world.add(def);
    runUntilItRises(world, ball);
    EXPECT_TRUE(near(world[ball].velocity().y, 6, 1e-4));
}

// Of an oblique impact with spin: the normal speed is e times that before, and friction takes
// energy: the tangential energy does not grow.
TEST(Bumper, GainsEnergyByRestitutionAlone) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real spin : {Real(-30), Real(0), Real(7), Real(60)}) {
            World world({.settings = support::settingsOf(solver)});
            support::addFloor(world, bumperOf(2, Real(0.8)));
            BodyDef def = support::ballDef({0, 2}, Real(0.5), withFriction(Real(0.8)));
            def.velocity = {5, -3};
            def.angularVelocity = spin;
            const BodyId ball = world.add(def);
            const auto tangential = [&] {
                const BodyView body = world[ball];
                const Real v = body.velocity().x;
                const Real w = body.angularVelocity();
                return (body.mass() * v * v + body.inertia() * w * w) / 2;
            };
            const Real before = tangential();
            runUntilItRises(world, ball);
            EXPECT_TRUE(near(world[ball].velocity().y, 6, 1e-4)) << spin;
            EXPECT_LE(tangential(), Real(1.0001) * before) << spin;
        }
    }
}

// Boxes give K_nt: friction and the normal impulse act on each other.
TEST(Bumper, KeepsATumblingBoxFinite) {
    for (const support::Solver solver : support::kSolvers) {
        WorldDef def{.gravity = support::kEarth, .settings = support::settingsOf(solver)};
        World world(def);
        support::addFloor(world, bumperOf(Real(1.2), 1));
        for (int i = 0; i < 8; ++i) {
            BodyDef box = support::boxDef({Real(3) * static_cast<Real>(i), 3}, 1, Real(0.5));
            box.rotation = Rot::fromAngle(Real(0.37) * static_cast<Real>(i));
            box.angularVelocity = static_cast<Real>(i) - 4;
            world.add(box);
        }
        support::run(world, 300);
        EXPECT_TRUE(world.frozenBodies().empty());
        for (const BodyId id : world.bodies()) {
            EXPECT_TRUE(isFinite(world[id].position())) << id.index;
        }
    }
}

} // namespace
} // namespace kodo
