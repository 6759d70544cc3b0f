// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::ballDef;
using support::boxDef;
using support::byPrecision;
using support::near;

constexpr Real kRates[] = {60, 120, 240, 480}; // Hz

// x = x0 + v t + g t^2 / 2. Integration is exact for a constant force, which leaves rounding: 1e-9
// m in double. In float about a hundred roundings of 80 m, more at higher rates.
TEST(FreeFlight, AProjectileFollowsTheParabolaFor4s) {
    for (const Real rate : kRates) {
        SCOPED_TRACE(rate);
        World world({.gravity = support::kEarth});
        BodyDef def = ballDef({1, 2}, Real(0.5));
        def.velocity = {7, 19};
        const BodyId ball = world.add(def);
        const Real dt = 1 / rate;
        const int steps = static_cast<int>(4 * rate);
        for (int i = 1; i <= steps; ++i) {
            world.step(dt);
            const long double t = static_cast<long double>(i) * static_cast<long double>(dt);
            const BasicVec2<long double> expected{1 + 7 * t, 2 + 19 * t - 5 * t * t};
            ASSERT_TRUE(near(world[ball].position(), expected, byPrecision(1e-5, 1e-11) * rate))
                << "step " << i;
        }
    }
}

// v = v0 + g t.
TEST(FreeFlight, AProjectileHasTheRightSpeed) {
    World world({.gravity = {3, -10}});
    BodyDef def = ballDef({}, Real(0.5));
    def.velocity = {7, 19};
    const BodyId ball = world.add(def);
    support::run(world, 240);
    EXPECT_TRUE(near(world[ball].velocity(), Vec2{19, -21}, byPrecision(1e-4, 1e-12)));
}

// Without torque the angular velocity stays bitwise constant, and so does the velocity.
TEST(FreeFlight, AFreeSpinKeepsItsBits) {
    World world;
    BodyDef def = boxDef({3, 4}, 2, 1);
    def.angularVelocity = 10;
    def.velocity = {Real(0.1), Real(-0.3)};
    const BodyId box = world.add(def);
    support::run(world, 6000);
    EXPECT_EQ(world[box].angularVelocity(), 10);
    EXPECT_EQ(world[box].velocity(), (Vec2{Real(0.1), Real(-0.3)}));
    const Rot q = world[box].rotation();
    EXPECT_TRUE(near(length(Vec2{q.c, q.s}), 1, 4 * support::kEpsilon));
}

// The angle is omega t. First-order integration would err by (omega dt)^3 / 12 per step, 2.3 rad in
// total. Rotation on the unit circle leaves only rounding over 24,000 turns.
TEST(FreeFlight, AFreeSpinKeepsItsPhase) {
    World world;
    BodyDef def = boxDef({}, 2, 1);
    def.angularVelocity = 10;
    const BodyId box = world.add(def);
    const Real dt = Real(1) / 64; // exactly representable, so that the phase is known
    support::run(world, 6400, dt);
    // 1000 rad = 159 turns and 1000 - 159 * 2 pi.
    const long double phase = std::remainder(1000.0L, 2 * std::numbers::pi_v<long double>);
    EXPECT_TRUE(near(world[box].rotation().angle(), phase, byPrecision(6400 * 6e-8, 1e-11)));
}

// R3: a persistent applied force acts as a constant force.
TEST(FreeFlight, AConstantThrustGivesAParabola) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2)); // 4 kg
    for (int i = 0; i < 120; ++i) {
        world[box].applyForce({8, 0});
        world.step(support::kDt);
    }
    EXPECT_TRUE(near(world[box].position(), Vec2{4, 0}, byPrecision(1e-4, 1e-12)));
    EXPECT_TRUE(near(world[box].velocity(), Vec2{4, 0}, byPrecision(1e-4, 1e-12)));
}

// R3: a persistent torque acts as a constant torque: angle = T t^2 / (2 I). In float, 120 turns are
// rounded to 6e-8 each.
TEST(FreeFlight, AConstantTorqueGivesAParabolaOfTheAngle) {
    World world;
    const BodyId box = world.add(boxDef({}, 2, 2)); // I = 8/3 kg m^2
    for (int i = 0; i < 120; ++i) {
        world[box].applyTorque(Real(8) / 3);
        world.step(support::kDt);
    }
    EXPECT_TRUE(near(world[box].angularVelocity(), 2, byPrecision(6e-5, 1e-12)));
    EXPECT_TRUE(near(world[box].rotation().angle(), 2, byPrecision(6e-5, 1e-12)));
}

} // namespace
} // namespace kodo
