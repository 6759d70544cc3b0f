// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kodo {
namespace {

const std::vector<StepSettings> kImpactSolvers{{}, thesis2006()};

// B1: a paddle that moves farther in a step than it is thick. No ball ends up behind it, whatever
// the restitution e and the place of the ball in the step, and it leaves at (1 + e) times the
// speed.
TEST(KinematicImpact, AFastPaddlePassesThroughNoBall) {
    for (const StepSettings& settings : kImpactSolvers) {
        for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
            for (const Real speed : {Real(10), Real(40), Real(100)}) {
                for (const Real rate : {Real(60), Real(144)}) {
                    const Material material = withFriction(Real(0.3), restitution);
                    for (int i = 0; i < 40; ++i) {
                        World world({.settings = settings});
                        const BodyId paddle = world.add({.shape = Box{Real(0.2), 2},
                                                         .velocity = {speed, 0},
                                                         .material = material,
                                                         .type = BodyType::Kinematic});
                        const Real start = 1 + static_cast<Real>(i) * speed / rate / 40;
                        BodyDef def = support::ballDef({start, Real(0.3)}, Real(0.1), material);
                        const BodyId ball = world.add(def);
                        support::run(world, 60, 1 / rate);
                        ASSERT_GT(world[ball].position().x, world[paddle].position().x)
                            << "e " << restitution << ", " << speed << " m/s, place " << i;
                        ASSERT_NEAR(world[ball].velocity().x, speed * (1 + restitution),
                                    speed / 1000);
                    }
                }
            }
        }
    }
}

// B1: a bar that turns by up to 2 rad in a step about its middle hits a ball at each place that it
// passes over.
TEST(KinematicImpact, AFastBarHitsEachBallInItsWay) {
    for (const StepSettings& settings : kImpactSolvers) {
        for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
            for (const Real turn : {Real(0.6), Real(1), Real(2)}) { // rad per step
                const Material material = withFriction(Real(0.3), restitution);
                for (int i = 0; i < 60; ++i) {
                    World world({.settings = settings});
                    world.add({.shape = Box{4, Real(0.1)},
                               .angularVelocity = turn / support::kDt,
                               .material = material,
                               .type = BodyType::Kinematic});
                    const Real angle = Real(0.3) + Real(0.045) * static_cast<Real>(i);
                    const Vec2 place = Real(1.5) * Vec2{std::cos(angle), std::sin(angle)};
                    const BodyId ball = world.add(support::ballDef(place, Real(0.1), material));
                    support::run(world, static_cast<int>(Real(3.2) / turn) + 1);
                    ASSERT_GT(length(world[ball].position() - place), Real(0.01))
                        << "e " << restitution << ", " << turn << " rad, place " << i;
                }
            }
        }
    }
}

/// Velocity after the impact with a floor that recedes at `speed`, of a ball that comes at 5 m/s;
/// 0 if there is none within 2 s.
Real reboundFrom(const StepSettings& settings, const Shape& floor, Real restitution, Real speed,
                 Real rate, Real height) {
    World world({.settings = settings});
    const Material material = withFriction(0, restitution);
    world.add({.shape = floor,
               .velocity = {0, -speed},
               .material = material,
               .type = BodyType::Kinematic});
    BodyDef def = support::ballDef({0, height + Real(0.1)}, Real(0.1), material);
    def.velocity = {0, -5};
    const BodyId ball = world.add(def);
    const int last = static_cast<int>((height / (5 - speed)) * rate) + 3;
    for (int step = 0; step < last; ++step) {
        world.step(1 / rate);
    }
    return world[ball].velocity().y > Real(-4.99) ? world[ball].velocity().y : 0;
}

// B8: a floor that recedes within the rest of the step in which a ball meets it. The impact gives
// v' = -u + e (5 - u).
TEST(KinematicImpact, ABallReboundsFromAFloorThatRecedes) {
    const Shape floors[] = {Box{10, 1, {0, Real(-0.5)}}, Plane{}};
    for (const StepSettings& settings : kImpactSolvers) {
        for (const Shape& floor : floors) {
            for (const Real restitution : {Real(0.1), Real(0.5), Real(1)}) {
                for (const Real rate : {Real(60), Real(240)}) {
                    for (const Real speed : {Real(0.1), Real(0.5), Real(1), Real(2), Real(4)}) {
                        for (int place = 0; place < 20; ++place) {
                            const Real height = Real(0.5) + Real(0.0043) * static_cast<Real>(place);
                            const Real wanted = -speed + restitution * (5 - speed);
                            ASSERT_NEAR(
                                reboundFrom(settings, floor, restitution, speed, rate, height),
                                wanted, Real(1e-3))
                                << speed << " m/s, e " << restitution << ", " << rate
                                << " Hz, place " << place;
                        }
                    }
                }
            }
        }
    }
}

/// A hollow box of 4 m that turns.
BodyDef turningBox(Real wall, Real speed, const Material& material) {
    Compound walls;
    for (const Real side : {Real(-2), Real(2)}) {
        walls.parts.push_back(Box{4 + wall, wall, {0, side}});
        walls.parts.push_back(Box{wall, 4 + wall, {side, 0}});
    }
    return {.shape = walls,
            .angularVelocity = speed,
            .material = material,
            .type = BodyType::Kinematic};
}

// B1: a ball in a closed box that turns, while one wall recedes from it and another comes. Neither
// does it leave, nor does it hang in the air at a speed with which it does not move.
TEST(KinematicImpact, ABallStaysInAClosedBoxThatTurns) {
    for (const StepSettings& settings : kImpactSolvers) {
        for (const Real restitution : {Real(0), Real(0.1), Real(0.5)}) {
            for (const Real speed : {Real(0.3), Real(0.5), Real(1)}) { // rad/s
                for (int start = 0; start < 12; ++start) {
                    World world({.gravity = {0, -10}, .settings = settings});
                    const Material material = withFriction(Real(0.3), restitution);
                    const BodyId box = world.add(turningBox(Real(0.1), speed, material));
                    const Real x = Real(-1.2) + Real(0.2) * static_cast<Real>(start);
                    const BodyId ball =
                        world.add(support::ballDef({x, Real(-0.7)}, Real(0.1), material));
                    int hanging = 0;
                    for (int step = 0; step < 300; ++step) {
                        const Vec2 before = world[ball].position();
                        world.step(support::kDt);
                        const Real moved = length(world[ball].position() - before) / support::kDt;
                        const Real fast = length(world[ball].velocity());
                        hanging = fast > 2 && moved < fast / 2 ? hanging + 1 : 0;
                        ASSERT_LE(hanging, 3) << "step " << step;
                        const Vec2 place = toLocal(world[box].transform(), world[ball].position());
                        ASSERT_LT(std::max(std::abs(place.x), std::abs(place.y)), 2)
                            << speed << " rad/s, e " << restitution << ", start " << start;
                    }
                }
            }
        }
    }
}

// F5: a disc that moves by its radius in a step, and a ball off its line. The ball leaves along the
// normal of the first touch, wherever in the step that is.
TEST(KinematicImpact, ABallOffTheLineOfADiscLeavesAlongTheNormal) {
    const Material smooth = support::slippery();
    const Real aside = Real(0.4);
    const Real reach = Real(0.75); // m, of both radii
    const Vec2 normal{std::sqrt(reach * reach - aside * aside) / reach, aside / reach};
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        World world;
        world.add({.shape = Circle{Real(0.5)},
                   .velocity = {30, 0},
                   .material = smooth,
                   .type = BodyType::Kinematic});
        const Real start = 2 + Real(0.005) * static_cast<Real>(i);
        const BodyId ball = world.add(
            {.shape = Circle{Real(0.25)}, .position = {start, aside}, .material = smooth});
        support::run(world, 20);
        const Vec2 velocity = world[ball].velocity();
        const Real speed = 30 * normal.x; // of the disc along the normal
        EXPECT_NEAR(dot(velocity, normal), speed, Real(0.01) * speed);
        EXPECT_NEAR(cross(velocity, normal), 0, Real(0.02) * speed);
    }
}

// F6: a bar that turns by up to 2 rad in a step. A ball that it meets within the step leaves along
// the normal of the touch, at (1 + e) times the speed of the bar there, and with one record of its
// whole impulse. Tolerance: a ball within the slop of the bar at the start of a step is hit then.
TEST(KinematicImpact, ABallLeavesATurningBarAlongTheNormalOfTheTouch) {
    const Real radius = Real(0.15);
    const Real half = Real(0.05); // m, of the bar's thickness
    for (const Real rate : {Real(30), Real(60), Real(240)}) {
        for (const Real restitution : {Real(0.5), Real(1)}) {
            for (const Real turn : {Real(0.1), Real(0.3), Real(0.6), Real(1), Real(-2)}) {
                int late = 0;
                for (int i = 0; i < 40; ++i) {
                    World world;
                    const Material smooth = support::slippery(restitution);
                    world.add({.shape = Box{2, 2 * half},
                               .angularVelocity = turn * rate,
                               .material = smooth,
                               .type = BodyType::Kinematic});
                    const Real reach = Real(0.45) + Real(0.009) * static_cast<Real>(i);
                    const Real lead = Real(0.75) + Real(0.037) * static_cast<Real>(i);
                    const Real before = std::asin((radius + half) / reach);
                    const Real sign = turn > 0 ? Real(1) : Real(-1);
                    const BodyId ball = world.add(
                        {.shape = Circle{radius},
                         .position = {reach * std::cos(lead), sign * reach * std::sin(lead)},
                         .material = smooth});
                    Real impulse = 0;
                    for (Real way = 0; way < Real(2.4) && impulse == 0; way += std::abs(turn)) {
                        world.step(1 / rate);
                        for (const CollisionRecord& hit : world.hits(0)) {
                            impulse += hit.totalImpulse;
                        }
                    }
                    const Vec2 normal{-std::sin(lead - before), sign * std::cos(lead - before)};
                    const Real arm = reach * std::cos(before);
                    const Real speed = (1 + restitution) * std::abs(turn) * rate * arm;
                    const Vec2 velocity = world[ball].velocity();
                    ASSERT_NEAR(impulse, world[ball].mass() * length(velocity),
                                Real(1e-3) * impulse);
                    ASSERT_GT(impulse, 0) << turn << " rad, place " << i;
                    late += length(velocity - speed * normal) > Real(1e-3) * speed ? 1 : 0;
                }
                EXPECT_LE(late, 2) << rate << " Hz, " << turn << " rad, e " << restitution;
            }
        }
    }
}

// A ball meets a wall, and within the same step the paddle below it, which goes on towards the
// wall. The paddle carries it, but not into the wall: it was pressed in by up to 0.2 m, and had no
// record of its impact there.
TEST(KinematicImpact, APaddlePressesNoBallIntoTheWallThatItHasMet) {
    for (const Real restitution : {Real(0), Real(0.5), Real(1)}) {
        for (const Real rate : {Real(60), Real(120), Real(240)}) {
            for (int i = 1; i <= 20; ++i) {
                World world;
                const Material material = withFriction(0, restitution);
                world.add({.shape = Box{1, 10},
                           .position = {Real(0.5), 0},
                           .material = material,
                           .type = BodyType::Static});
                const Real gap = Real(0.1) * static_cast<Real>(i) / 20;
                const Vec2 place{-gap - Real(0.2), 0};
                BodyDef def = support::ballDef(place, Real(0.2), material);
                def.velocity = {Real(0.3) * rate, Real(0.3) * rate};
                const BodyId ball = world.add(def);
                world.add({.shape = Circle{Real(0.5)},
                           .position = place - Real(0.71) * normalize(Vec2{1, Real(1.4)}),
                           .velocity = {Real(0.4) * rate, Real(0.3) * rate},
                           .material = material,
                           .type = BodyType::Kinematic});
                world.step(1 / rate);
                EXPECT_LT(world[ball].position().x + Real(0.2), 2 * world.tolerances().slop)
                    << "e " << restitution << " at " << rate << " Hz, gap " << gap;
            }
        }
    }
}

} // namespace
} // namespace kodo
