// SPDX-License-Identifier: MIT
// C1: static friction holds to its limit, also where the kinetic one is far below.
#include <kodo/world.hpp>
#include <support/scenes.hpp>

#include <cmath>
#include <utility>

namespace kodo {
namespace {

using support::kEarth;

constexpr Real kKinetic = Real(0.2);

/// Distance (m) that a box laid on a slope of tan 0.5 slides in 3 s.
Real slideOf(Real coefficient, Real rate, Real height, Real depth) {
    const Real angle = std::atan(Real(0.5));
    const Rot rotation = Rot::fromAngle(angle);
    const Vec2 up = rotation.yAxis();
    const Material material{coefficient, kKinetic, 0, 0};
    World world({.gravity = kEarth});
    world.add({.shape = Box{40, 2},
               .position = -up,
               .rotation = rotation,
               .material = material,
               .type = BodyType::Static});
    BodyDef def = support::boxDef((height / 2 - depth) * up, 1, height, material);
    def.rotation = rotation;
    const BodyId box = world.add(def);
    const Vec2 start = world[box].position();
    support::run(world, static_cast<int>(3 * rate), 1 / rate);
    return length(world[box].position() - start);
}

// From 1 % above the limit on it sticks in the first substep as in all. The tolerance is a slop.
TEST(StaticFriction, HoldsOnASlopeToItsLimit) {
    for (const Real rate : {Real(30), Real(60), Real(120), Real(240)}) {
        for (const Real height : {Real(0.5), Real(1)}) {
            for (const Real depth : {Real(0), Real(0.002)}) {
                for (const Real coefficient : {Real(0.505), Real(0.52), Real(0.6), Real(0.65)}) {
                    EXPECT_LT(slideOf(coefficient, rate, height, depth), Real(0.004))
                        << "rate " << rate << ", height " << height << ", depth " << depth
                        << ", static " << coefficient;
                }
            }
        }
    }
}

// 1 % below the limit it slides with the kinetic coefficient from the first step on:
// s = g (sin - mu cos) t^2 / 2, less by a step of delay.
TEST(StaticFriction, LetsGoBelowItsLimit) {
    const Real angle = std::atan(Real(0.5));
    const Real acceleration = 10 * (std::sin(angle) - kKinetic * std::cos(angle));
    for (const Real rate : {Real(60), Real(240)}) {
        const Real distance = slideOf(Real(0.495), rate, Real(0.5), 0);
        EXPECT_LT(distance, Real(1.01) * acceleration * Real(4.5));
        EXPECT_GT(distance, Real(0.98) * acceleration * Real(4.5));
    }
}

struct Belt {
    World world;
    BodyId belt;
    BodyId box;
};

/// A box on a belt, with a static friction of 0.6.
Belt makeBelt() {
    const Material material{Real(0.6), kKinetic, 0, 0};
    World world({.gravity = kEarth});
    const BodyId belt = world.add({.shape = Box{400, 1},
                                   .position = {0, Real(-0.5)},
                                   .material = material,
                                   .type = BodyType::Kinematic});
    const BodyId box = world.add(support::boxDef({0, Real(0.25)}, 1, Real(0.5), material));
    return {std::move(world), belt, box};
}

// A belt that speeds up carries a box while its acceleration is below mu g = 6 m/s^2. It changes
// its speed once a step; the substeps share that.
TEST(StaticFriction, CarriesABoxOnABeltThatSpeedsUp) {
    for (const Real rate : {Real(30), Real(60), Real(240)}) {
        for (const Real acceleration : {Real(3), Real(4.5), Real(5.5), Real(5.9)}) {
            auto [world, belt, box] = makeBelt();
            support::run(world, static_cast<int>(rate), 1 / rate);
            for (int step = 1; step <= static_cast<int>(2 * rate); ++step) {
                world[belt].setVelocity({acceleration * static_cast<Real>(step) / rate, 0});
                world.step(1 / rate);
                ASSERT_LT(std::abs(world[belt].velocity().x - world[box].velocity().x), Real(0.02))
                    << "rate " << rate << ", acceleration " << acceleration << ", step " << step;
            }
        }
    }
}

// Above that it slides with the kinetic coefficient: a box gains 2 m/s in a second.
TEST(StaticFriction, LeavesABoxBehindOnAFasterBelt) {
    auto [world, belt, box] = makeBelt();
    support::run(world, 60);
    for (int step = 1; step <= 60; ++step) {
        world[belt].setVelocity({10 * static_cast<Real>(step) / 60, 0});
        world.step(support::kDt);
    }
    EXPECT_TRUE(support::near(world[box].velocity().x, 2, Real(0.1)));
}

// The impact is solved at a gap below 1e-7 m, of which half lengthens the lever of the friction.
constexpr Real kGapError = support::byPrecision(1e-5, 1e-7);

/// Horizontal speed (m/s) and spin (rad/s, clockwise) after the impact of a disc with restitution
/// 0.5, a static friction of 0.6 and a kinetic one of 0.2, that falls at 2 m/s without spin.
struct AfterImpact {
    Real speed;
    Real spin;
};

AfterImpact afterImpactAt(Real speed) {
    const Material material{
        .staticFriction = Real(0.6), .kineticFriction = kKinetic, .restitution = Real(0.5)};
    World world;
    support::addFloor(world, material);
    BodyDef def = support::ballDef({0, 2}, 1, material);
    def.velocity = {speed, -2};
    const BodyId disc = world.add(def);
    for (int step = 0; step < 120 && world[disc].velocity().y < 0; ++step) {
        world.step(support::kDt);
    }
    EXPECT_TRUE(support::near(world[disc].velocity().y, 1, kGapError));
    return {world[disc].velocity().x, -world[disc].angularVelocity()};
}

// The normal impulse is (1 + e) v_n = 3 N s per kg. A disc of inertia m r^2 / 2 rolls after a
// tangential impulse of a third of its speed, which static friction applies up to 0.6 * 3 = 1.8,
// where the kinetic one ends at 0.6.
TEST(StaticFriction, MakesADiscRollInAnObliqueImpactToItsLimit) {
    for (const Real speed : {Real(1), Real(2.5), Real(4), Real(5.3), Real(-5.3)}) {
        const AfterImpact after = afterImpactAt(speed);
        EXPECT_TRUE(support::near(after.speed, 2 * speed / 3, kGapError)) << "speed " << speed;
        EXPECT_TRUE(support::near(after.spin, 2 * speed / 3, kGapError)) << "speed " << speed;
    }
}

// Above it the disc slides with the kinetic coefficient: it loses 0.2 * 3 = 0.6 m/s, and spins by
// twice that.
TEST(StaticFriction, LeavesKineticFrictionInAnObliqueImpactBeyondItsLimit) {
    for (const Real speed : {Real(5.5), Real(8), Real(-5.5)}) {
        const AfterImpact after = afterImpactAt(speed);
        const Real loss = std::copysign(Real(0.6), speed);
        EXPECT_TRUE(support::near(after.speed, speed - loss, kGapError)) << "speed " << speed;
        EXPECT_TRUE(support::near(after.spin, 2 * loss, kGapError)) << "speed " << speed;
    }
}

} // namespace
} // namespace kodo
