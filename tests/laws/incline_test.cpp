// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

/// A flat box, which cannot tip over, on a slope through the origin that rises to the right.
struct Slope {
    World world{support::withoutSleep()};
    BodyId box;
    Vec2 start;
    Vec2 downhill;

    Slope(Real degrees, const Material& material) {
        const Rot tilt = Rot::fromAngle(degrees * std::numbers::pi_v<Real> / 180);
        downhill = -tilt.xAxis();
        world.add({.shape = Box{400, 2},
                   .position = -1 * tilt.yAxis(),
                   .rotation = tilt,
                   .material = material,
                   .type = BodyType::Static});
        start = Real(0.25) * tilt.yAxis();
        box = world.add({.shape = Box{2, Real(0.5)},
                         .position = start,
                         .rotation = tilt,
                         .material = material});
    }
    Real way() const { return dot(world[box].position() - start, downhill); }
    Real speed() const { return dot(world[box].velocity(), downhill); }
};

// R7: the box sticks while tan(slope) < mu and slips beyond, within 1e-3.
TEST(Incline, HoldsUpToTheAngleOfFriction) {
    for (const Real degrees : {Real(5), Real(15), Real(30), Real(45), Real(60)}) {
        const Real critical =
            static_cast<Real>(std::tan(static_cast<double>(degrees) * 3.14159265358979 / 180));
        Slope holds(degrees, withFriction(critical * Real(1.001)));
        Slope slips(degrees, withFriction(critical * Real(0.999)));
        support::run(holds.world, 300);
        support::run(slips.world, 300);
        // Just beyond the threshold it accelerates with 0.001 g sin: at least 4 mm/s after 5 s.
        EXPECT_LT(holds.speed(), Real(5e-4)) << degrees;
        EXPECT_GT(slips.speed(), Real(3e-3)) << degrees;
    }
}

// a = g (sin - mu cos). After 2 s, v = a t within 1 % and s = a t^2 / 2 within 3 %.
TEST(Incline, SlipsWithTheExactAcceleration) {
    for (const double mu : {0.0, 0.2, 0.4}) {
        SCOPED_TRACE(mu);
        Slope slope(30, withFriction(static_cast<Real>(mu)));
        support::run(slope.world, 120);
        const double a = 10 * (0.5 - mu * std::sqrt(0.75));
        EXPECT_TRUE(nearShare(slope.speed(), a * 2, 0.01));
        EXPECT_TRUE(nearShare(slope.way(), a * 2, 0.03));
    }
}

// A sticking box does not creep: 1e-6 m in 20 s once the contact is established. In float each of
// the 6000 substeps may round by 3e-9 m.
TEST(Incline, DoesNotCreep) {
    Slope slope(20, withFriction(Real(0.6)));
    support::run(slope.world, 60);
    const Real before = slope.way();
    support::run(slope.world, 1200);
    EXPECT_TRUE(near(slope.way(), before, byPrecision(2e-5, 1e-6)));
}

// No creep in 1e6 steps (4.6 hours). A creep of a millionth of the slop per step would show.
TEST(Incline, DoesNotCreepInAMillionSteps) {
    Slope slope(20, withFriction(Real(0.6)));
    support::run(slope.world, 600);
    const Real before = slope.way();
    support::run(slope.world, support::kSanitized ? 100000 : 1000000);
    EXPECT_TRUE(near(slope.way(), before, byPrecision(2e-5, 1e-6)));
}

// R7: with static and kinetic friction, between the two thresholds a resting box stays and a moving
// one slides on.
TEST(Incline, StaysOrSlidesBetweenTheTwoFrictions) {
    const Material material{Real(0.7), Real(0.4), 0, 0}; // tan 30 degrees = 0.577
    Slope asleep(30, material);
    support::run(asleep.world, 120);
    EXPECT_TRUE(near(asleep.speed(), 0, Real(1e-3)));
    Slope pushed(30, material);
    pushed.world[pushed.box].setVelocity(pushed.downhill);
    support::run(pushed.world, 120);
    const double a = 10 * (0.5 - 0.4 * std::sqrt(0.75));
    EXPECT_TRUE(nearShare(pushed.speed(), 1 + a * 2, 0.01));
}

} // namespace
} // namespace kodo
