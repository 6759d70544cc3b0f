// SPDX-License-Identifier: MIT
#include <support/sleeping.hpp>

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

/// A segment of 6 m that is solid from above only.
BodyDef oneSidedDef(Vec2 position) {
    BodyDef def;
    def.shape = Segment{{-3, 0}, {3, 0}, true};
    def.position = position;
    def.type = BodyType::Kinematic;
    return def;
}

BodyDef moverDef(int kind, Vec2 position) {
    return kind == 0 ? ballDef(position, Real(0.4)) : boxDef(position, Real(0.8), Real(0.8));
}

// F2: balls and boxes pass it from below at any speed and land on it.
TEST(OneSidedPlatform, LetsBodiesRiseAndCarriesThemFromAbove) {
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
            // Free flight is exact; sampling misses the apex by at most g (dt / 2)^2 / 2.
            EXPECT_TRUE(near(highest, height, byPrecision(1e-3, 4e-4) * std::max(Real(1), height)));
            EXPECT_TRUE(near(world[jumper].position().y, Real(0.4), world.tolerances().slop))
                << kind << " " << height;
            EXPECT_TRUE(support::isAsleep(world, jumper));
        }
    }
}

// F2: a rise through it has the same bits as without it. Afterwards the body lands on it.
TEST(OneSidedPlatform, DoesNotAffectARisingBodyAndCarriesItAfterwards) {
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

// F2: in one or two steps the body is close enough above it for a contact and moves in substeps.
// Each such step deviates from the parabola by 5 g h^2 / 2 = 0.28 mm for substeps of h.
TEST(OneSidedPlatform, KeepsARisingBodyOnItsParabola) {
    for (const int kind : {0, 1}) {
        for (const Real speed : {Real(8), Real(8.5), Real(12), Real(60)}) {
            World world({.gravity = support::kEarth});
            World empty = world;
            const BodyId platform = world.add(oneSidedDef({0, 0}));
            empty.add(ballDef({1000, 0}, 1)); // in its place, for equal ids
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

// A body that does not get through falls back without any impulse, from any apex.
TEST(OneSidedPlatform, DoesNotPushABodyThatFallsBack) {
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

TEST(OneSidedPlatform, StopsBodiesFromAboveAtAnySpeed) {
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

// A moving platform carries its load. It does not affect bodies that it passes from below.
TEST(OneSidedPlatform, CarriesItsLoadAsALift) {
    World world({.gravity = support::kEarth});
    const BodyId lift = world.add(oneSidedDef({0, 0}));
    const BodyId rider = world.add(boxDef({1, Real(0.5)}, 1, 1));
    const BodyId ledge =
        world.add({.shape = Box{1, 1}, .position = {-2, 4}, .type = BodyType::Kinematic});
    const BodyId lying = world.add(ballDef({-2, 5}, Real(0.5)));
    run(world, 30);
    world[lift].setVelocity({0, 2});
    run(world, 240); // 8 m
    EXPECT_TRUE(near(world[rider].position().y, Real(8.5), Real(0.01)));
    EXPECT_TRUE(near(world[ledge].position(), Vec2{-2, 4}, 0));
    EXPECT_GT(world[lying].position().y, 5); // it lay above the segment and was lifted
}

// moveTo() gives the velocity at the contact. Friction accelerates a box on a moving platform with
// mu g, until it has the speed of the platform.
TEST(MovingPlatform, AcceleratesABoxByFriction) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, Real(-0.5)}, 40, 1, withFriction(Real(0.5)));
    def.type = BodyType::Kinematic;
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
    move(24); // equal speeds after 0.6 s
    // In float, the velocity from moveTo() contains a rounding of 2.4 m over dt. In double, a
    // remainder of the tilt during the acceleration is left.
    EXPECT_TRUE(near(world[box].velocity().x, 3, byPrecision(2e-5, 2e-7)));
    const Real lag = world[platform].position().x - world[box].position().x;
    EXPECT_TRUE(nearShare(lag, 3 * 0.6 / 2, 0.01)); // v^2 / (2 mu g)
    move(240);
    EXPECT_TRUE(near(world[platform].position().x - world[box].position().x, lag, Real(1e-3)));
}

// The stack does not slip: a = A w^2 = 2.4 m/s^2 < mu g = 6 m/s^2.
TEST(MovingPlatform, CarriesAStackToAndFro) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, Real(-0.5)}, 10, 1);
    def.type = BodyType::Kinematic;
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

// A lift with |a| < g never loses its load. The recorded force is m (g + a).
TEST(MovingPlatform, LiftsWithoutLosingItsLoad) {
    World world({.gravity = support::kEarth});
    BodyDef def = boxDef({0, Real(-0.5)}, 10, 1);
    def.type = BodyType::Kinematic;
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

// The rim moves with w r. Friction accelerates a box that touches it to that speed.
TEST(MovingPlatform, ARotatingWheelAcceleratesABoxToItsRimSpeed) {
    World world({.gravity = support::kEarth});
    BodyDef drum = ballDef({0, -2}, 2, withFriction(1));
    drum.type = BodyType::Kinematic;
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
