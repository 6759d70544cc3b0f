// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>
#include <support/solver.hpp>

#include <cmath>

namespace kodo {
namespace {

using support::settingsOf;

// F1: a smooth ball of mass m meets an equal one, locked along y, with a normal n at 30 degrees to
// its way. The impulse P along n changes the ball's velocity by P / m and the locked one's by
// n_x P / m. Without restitution P (1 + n_x^2) / m = v n_x. With restitution 1 the impact comes
// first, P = v n_x m, and the groove takes the part across it: see lockAxis().
TEST(AxisLock, ABlowMovesItAlongTheFreeAxisAlone) {
    for (const double restitution : {0.0, 1.0}) {
        for (const double rate : {30.0, 60.0, 240.0}) {
            for (const Vec2 place : {Vec2{}, Vec2{900, 400}}) {
                SCOPED_TRACE(testing::Message() << restitution << " at " << rate << " Hz");
                World world;
                const auto addDisc = [&](Vec2 at, Vec2 velocity) {
                    return world.add({.shape = Circle{Real(0.5)},
                                      .position = place + at,
                                      .velocity = velocity,
                                      .material = withFriction(0, static_cast<Real>(restitution))});
                };
                const BodyId held = addDisc({0, 0}, {});
                const BodyId ball = addDisc({-2, Real(0.5)}, {10, 0});
                lockAxis(world, held, {0, 1});
                for (int step = 0; step < static_cast<int>(rate); ++step) {
                    world.step(static_cast<Real>(1 / rate));
                }
                const double nx = std::sqrt(0.75);
                const double gained = 10 * nx * nx / (restitution > 0 ? 1 : 1 + nx * nx);
                // At 30 Hz the ball slides by a third of its size while the normal stays.
                const double within = (rate < 60 ? 0.07 : 0.02) * gained;
                EXPECT_NEAR(world[held].velocity().x, gained, within);
                EXPECT_NEAR(world[ball].velocity().x, 10 - gained, within);
                EXPECT_NEAR(world[held].position().y, place.y, 0.003);
                EXPECT_NEAR(world[held].velocity().y, 0, 0.01);
            }
        }
    }
}

// A crate that may only rise and sink carries its weight by the floor, and slides on no slope.
TEST(AxisLock, ACrateThatMayOnlySinkStaysInItsColumn) {
    for (const support::Solver solver : support::kSolvers) {
        World world({.gravity = {3, -10}, .settings = settingsOf(solver)});
        world.add({.shape = Plane{.normal = {0, 1}}, .type = BodyType::Static});
        const BodyId crate =
            world.add({.shape = Box{1, 1}, .position = {0, 2}, .flags = kLockRotate});
        lockAxis(world, crate, {1, 0});
        support::run(world, 180);
        EXPECT_NEAR(world[crate].position().x, 0, 0.003);
        EXPECT_NEAR(world[crate].position().y, 0.5, 0.01);
        EXPECT_EQ(world[crate].rotation().angle(), 0);
    }
}

TEST(AxisLock, HoldsALargeBodyFarFromItsFrame) {
    World world({.lengthUnit = 1000});
    const BodyId disc = world.add({.shape = Circle{500, {Real(2e5), 0}}, .velocity = {50, 50}});
    lockAxis(world, disc, {1, 0});
    support::run(world, 60);
    EXPECT_NEAR(world[disc].center().x, 2e5, 1);
    EXPECT_NEAR(world[disc].center().y, 50, 1);
}

// The rotation stays free, about the centre of mass: a bar that is off its frame's origin.
TEST(AxisLock, LeavesTheRotationFree) {
    World world;
    const BodyId bar =
        world.add({.shape = Box{1, Real(0.2), {3, 0}}, .velocity = {2, 1}, .angularVelocity = 4});
    const Vec2 center = world[bar].center();
    world[bar].setVelocity({2, 1});
    lockAxis(world, bar, {0, 1});
    support::run(world, 120);
    EXPECT_NEAR(world[bar].angularVelocity(), 4, 0.01);
    EXPECT_NEAR(world[bar].center().x, center.x + 4, 0.02);
    EXPECT_NEAR(world[bar].center().y, center.y, 0.003);
}

TEST(AxisLock, EndsWithItsGroove) {
    World world({.gravity = {0, -10}});
    const BodyId ball = world.add({.shape = Circle{1}});
    const BodyId groove = lockAxis(world, ball, {0, 1});
    support::run(world, 60);
    EXPECT_NEAR(world[ball].position().y, 0, 0.003);
    EXPECT_TRUE(world.collisions().empty());
    EXPECT_FALSE(rayCast(world, {0, 5}, {0, Real(1.5)}));
    world.remove(groove);
    EXPECT_TRUE(world.joints().empty());
    support::run(world, 60);
    EXPECT_LT(world[ball].position().y, -4);
}

TEST(AxisLock, RefusesBadAxesAndBodies) {
    World world;
    const BodyId ball = world.add({});
    EXPECT_THROW(lockAxis(world, ball, {2, 0}), BadDefinition);
    EXPECT_THROW(lockAxis(world, ball, {}), BadDefinition);
    EXPECT_EQ(world.bodies().size(), 1u);
    world[ball].setType(BodyType::Kinematic);
    EXPECT_THROW(lockAxis(world, ball, {1, 0}), BadDefinition);
    world.remove(ball);
    EXPECT_THROW(lockAxis(world, ball, {1, 0}), BadBodyId);
    EXPECT_TRUE(world.bodies().empty());
}

} // namespace
} // namespace kodo
