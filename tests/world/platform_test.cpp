// SPDX-License-Identifier: MIT
#include <support/resting.hpp>

#include <algorithm>
#include <cmath>

namespace kodo {
namespace {

using support::addFloor;
using support::ballDef;
using support::boxDef;
using support::byPrecision;
using support::kDt;
using support::near;
using support::nearShare;
using support::run;

/// A line of 6 m that is solid from above only.
BodyDef oneSidedDef(Vec2 position) {
    BodyDef def;
    def.shape = Segment{{-3, 0}, {3, 0}, true, {}, {}};
    def.position = position;
    def.flags = kLocked;
    return def;
}

BodyDef moverDef(int kind, Vec2 position) {
    return kind == 0 ? ballDef(position, Real(0.4)) : boxDef(position, Real(0.8), Real(0.8));
}

// F2: from below one jumps through it, and lands on it: slow, fast, balls and boxes.
TEST(OneSidedPlatform, LetsUpAndCarriesWhatComesDown) {
    for (const int kind : {0, 1}) {
        for (const Real height : {Real(1), Real(1.5), Real(3), Real(20), Real(300)}) {
            World world({.gravity = support::kEarth});
            const BodyId platform = world.add(oneSidedDef({0, 0}));
            BodyDef def = moverDef(kind, {Real(0.3), -2});
            def.velocity = {0, std::sqrt(2 * 10 * (height + 2))};
            const BodyId jumper = world.add(def);
            Real highest = -2;
            for (int step = 0; step < 1500; ++step) {
                world.step(kDt);
                highest = std::max(highest, world[jumper].position().y);
                if (world[jumper].velocity().y > 1) {
                    ASSERT_EQ(support::recordOf(world, platform, jumper), nullptr) << height;
                }
            }
            // Free flight is exact, so the apex lies within a step of it: g (dt / 2)^2 / 2.
            EXPECT_TRUE(near(highest, height, byPrecision(1e-3, 4e-4) * std::max(Real(1), height)));
            EXPECT_TRUE(near(world[jumper].position().y, Real(0.4), world.tolerances().slop))
                << kind << " " << height;
            EXPECT_TRUE(support::rests(world, jumper));
        }
    }
}

// F2: up through it as if it were not there, to the bit, and down onto it.
TEST(OneSidedPlatform, CarriesWhatHasJumpedThroughIt) {
    for (const Shape& shape : {Shape(Circle{Real(0.5)}), Shape(Box{1, 1})}) {
        for (const Real speed : {Real(8), Real(8.5), Real(12), Real(60)}) {
            World world({.gravity = support::kEarth});
            world.add(oneSidedDef({0, 2}));
            World empty({.gravity = support::kEarth});
            const BodyDef jumper{.shape = shape, .velocity = {0, speed}};
            const BodyId body = world.add(jumper);
            const BodyId free = empty.add(jumper);
            for (int i = 0; i < 600 && empty[free].velocity().y > 0; ++i) {
                world.step(kDt);
                empty.step(kDt);
                ASSERT_EQ(world[body].position(), empty[free].position()) << speed << ", " << i;
            }
            run(world, 900);
            EXPECT_TRUE(near(world[body].position().y, 2.5, 0.02)) << speed;
        }
    }
}

// F2: a step or two may begin so close above it that a body might be touched. There its flight is
// no exact parabola: each is off by g dt^2 / 2 of a substep, five times, 0.28 mm, and by no more.
TEST(OneSidedPlatform, IsNotThereForWhatComesFromBelow) {
    for (const int kind : {0, 1}) {
        for (const Real speed : {Real(8), Real(8.5), Real(12), Real(60)}) {
            World world({.gravity = support::kEarth});
            World empty = world;
            const BodyId platform = world.add(oneSidedDef({0, 0}));
            empty.add(ballDef({1000, 0}, 1)); // in its place, so that ids are alike
            BodyDef def = moverDef(kind, {Real(0.3), -2});
            def.velocity = {0, speed};
            const BodyId jumper = world.add(def);
            ASSERT_EQ(empty.add(def), jumper);
            while (empty[jumper].velocity().y > 0) {
                world.step(kDt);
                empty.step(kDt);
                ASSERT_TRUE(near(world[jumper].position(), empty[jumper].position(), Real(6e-4)))
                    << kind << " " << speed;
            }
            EXPECT_GT(world[jumper].position().y, world[platform].position().y + 1);
        }
    }
}

// One that does not get through falls back, unpushed, from wherever it turns.
TEST(OneSidedPlatform, LetsFallBackWhatDoesNotGetThrough) {
    for (const int kind : {0, 1}) {
        for (const Real height : {Real(-0.3), Real(0), Real(0.2), Real(0.35)}) {
            World world({.gravity = support::kEarth});
            world.add(oneSidedDef({0, 0}));
            BodyDef def = moverDef(kind, {Real(0.3), -2});
            def.velocity = {0, std::sqrt(2 * 10 * (height + 2))};
            const BodyId jumper = world.add(def);
            run(world, 90);
            const Real t = 90 * kDt;
            EXPECT_TRUE(near(world[jumper].position().y, -2 + def.velocity.y * t - 5 * t * t,
                             byPrecision(2e-4, 1e-12)))
                << kind << " " << height;
        }
    }
}

// From above nothing comes through, however fast.
TEST(OneSidedPlatform, StopsWhatComesFromAbove) {
    for (const int kind : {0, 1}) {
        for (const Real speed : {Real(10), Real(300), Real(10000)}) {
            World world({.gravity = support::kEarth});
            world.add(oneSidedDef({0, 0}));
            BodyDef def = moverDef(kind, {0, 5});
            def.velocity = {0, -speed};
            const BodyId body = world.add(def);
            run(world, 60);
            EXPECT_GT(world[body].position().y, Real(0.3)) << kind << " " << speed;
        }
    }
}

// It carries while it moves, and what it comes upon from below it leaves alone.
TEST(OneSidedPlatform, CarriesAsALift) {
    World world({.gravity = support::kEarth});
    const BodyId lift = world.add(oneSidedDef({0, 0}));
    const BodyId rider = world.add(boxDef({1, Real(0.5)}, 1, 1));
    const BodyId ledge = world.add({.shape = Box{1, 1}, .position = {-2, 4}, .flags = kLocked});
    const BodyId lying = world.add(ballDef({-2, 5}, Real(0.5)));
    run(world, 30);
    world[lift].setVelocity({0, 2});
    run(world, 240); // 8 m
    EXPECT_TRUE(near(world[rider].position().y, Real(8.5), Real(0.01)));
    EXPECT_TRUE(near(world[ledge].position(), Vec2{-2, 4}, 0));
    EXPECT_GT(world[lying].position().y, 5); // that one lay above the line, and rode along
}

// MoveTo gives the right velocity at the contact: a box on a platform is taken along by friction,
// with mu g until it has the speed of the platform, and then rides without slipping.
TEST(MovingPlatform, TakesABoxAlongByFriction) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, Real(-0.5)}, 40, 1, withFriction(Real(0.5)));
    def.flags = kLocked;
    const BodyId platform = world.add(def);
    const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1, withFriction(Real(0.5))));
    run(world, 30);
    const auto move = [&](int steps) {
        for (int step = 0; step < steps; ++step) {
            const Vec2 place = world[platform].position();
            world[platform].moveTo(place + Vec2{3 * kDt, 0}, kDt);
            world.step(kDt);
        }
    };
    move(24); // 0.4 s: 5 m/s^2, 2 m/s
    EXPECT_TRUE(nearShare(world[box].velocity().x, 2, 0.01));
    move(24); // it has caught up after 0.6 s
    // In float the speed that moveTo finds is off by a rounding of 2.4 m over dt; else a little is
    // left of the way in which the box leant on its edge.
    EXPECT_TRUE(near(world[box].velocity().x, 3, byPrecision(2e-5, 2e-7)));
    const Real lag = world[platform].position().x - world[box].position().x;
    EXPECT_TRUE(nearShare(lag, 3 * 0.6 / 2, 0.01)); // v^2 / (2 mu g)
    move(240);
    EXPECT_TRUE(near(world[platform].position().x - world[box].position().x, lag, Real(1e-3)));
}

// To and fro, gently enough for the friction to hold: a = A w^2 = 2.4 m/s^2 < mu g = 6 m/s^2.
TEST(MovingPlatform, CarriesAStackToAndFro) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, Real(-0.5)}, 10, 1);
    def.flags = kLocked;
    const BodyId platform = world.add(def);
    const std::vector<BodyId> stack = support::addStack(world, 3);
    run(world, 30);
    for (int step = 1; step <= 1200; ++step) {
        const double t = step * static_cast<double>(kDt);
        world[platform].moveTo({static_cast<Real>(0.6 * (1 - std::cos(2 * t))), Real(-0.5)}, kDt);
        world.step(kDt);
        for (std::size_t i = 0; i < stack.size(); ++i) {
            const Vec2 place = world[stack[i]].position() - world[platform].position();
            ASSERT_TRUE(near(place, Vec2{0, static_cast<Real>(i) + 1}, Real(0.02)))
                << "box " << i << ", step " << step;
        }
    }
}

// A lift that starts, rises and stops within reason (a < g) never loses its load, and the record
// tells m (g + a) in every step.
TEST(MovingPlatform, LiftsWithoutLosingItsLoad) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, Real(-0.5)}, 10, 1);
    def.flags = kLocked;
    const BodyId lift = world.add(def);
    const BodyId box = world.add(boxDef({0, Real(0.5)}, 1, 1));
    run(world, 20);
    Real speed = 0;
    for (int step = 0; step < 360; ++step) {
        const Real a = step < 120 ? Real(2) : step < 240 ? Real(0) : Real(-2);
        speed += a * kDt;
        world[lift].moveTo(world[lift].position() + Vec2{0, speed * kDt}, kDt);
        world.step(kDt);
        const CollisionRecord* record = support::recordOf(world, lift, box);
        ASSERT_NE(record, nullptr) << step;
        if (step % 120 > 30) { // settled to the new acceleration
            ASSERT_TRUE(nearShare(record->totalImpulse / kDt, 10 + a, 0.01)) << step;
        }
    }
    EXPECT_TRUE(near(world[box].position().y - world[lift].position().y, 1, Real(0.01)));
    EXPECT_GT(world[lift].position().y, 10);
}

// A turntable's rim moves with w r: a ball that touches it there is rubbed up to that speed.
TEST(MovingPlatform, ATurningWheelRubsWithItsRimSpeed) {
    World world({.gravity = support::kEarth});
    BodyDef drum = ballDef({0, -2}, 2, withFriction(1));
    drum.flags = kLocked;
    const BodyId wheel = world.add(drum);
    BodyDef def = boxDef({0, Real(0.05)}, Real(0.1), Real(0.1), withFriction(1));
    def.flags = kLockRotate;
    const BodyId box = world.add(def);
    for (int step = 0; step < 12; ++step) {
        world[wheel].moveTo({0, -2}, Rot::fromAngle(Real(-0.5) * kDt * static_cast<Real>(step + 1)),
                            kDt);
        world.step(kDt);
    }
    EXPECT_TRUE(near(world[box].velocity().x, 1, Real(0.01))); // 0.5 rad/s at 2 m
}

} // namespace
} // namespace kodo
