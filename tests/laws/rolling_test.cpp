// SPDX-License-Identifier: MIT
#include <support/scenes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// A sliding disc rolls from t = v0 / (3 mu g) on, after a distance of 5 v0^2 / (18 mu g). Then v =
// 2/3 v0 and omega r = v.
TEST(Rolling, ASlidingDiscRollsAtTwoThirdsOfItsSpeed) {
    World world({.gravity = support::kEarth});
    const Material material = withFriction(Real(0.3));
    support::addFloor(world, material);
    BodyDef def = support::ballDef({0, Real(0.5)}, Real(0.5), material);
    def.velocity = {6, 0};
    const BodyId ball = world.add(def);
    double rolls = 0;
    Real way = 0;
    for (int i = 1; i <= 180; ++i) {
        world.step(support::kDt);
        const Real slip = world[ball].velocity().x + Real(0.5) * world[ball].angularVelocity();
        if (rolls == 0 && slip < Real(0.01)) {
            rolls = i / 60.0;
            way = world[ball].position().x;
        }
    }
    EXPECT_TRUE(nearShare(world[ball].velocity().x, 4, 1e-3));
    EXPECT_TRUE(nearShare(world[ball].angularVelocity(), -8, 1e-3));
    const double time = 6 / 9.0;
    EXPECT_TRUE(near(rolls, time, 0.02 * time + 1 / 60.0)); // 2 %, plus one step for detection
    EXPECT_TRUE(near(way, 5 * 36 / (18 * 3.0), 0.02 * 3.33 + 4 / 60.0));
}

// A disc that rolls down an incline without slipping accelerates with 2/3 g sin, within 1 %.
TEST(Rolling, DownAnInclineHasTwoThirdsOfTheAcceleration) {
    for (const double degrees : {10.0, 30.0}) {
        SCOPED_TRACE(degrees);
        const double angle = degrees * 3.14159265358979 / 180;
        const Rot tilt = Rot::fromAngle(static_cast<Real>(-angle));
        World world({.gravity = support::kEarth});
        const Material material = withFriction(Real(0.6)); // more than tan / 3
        world.add({.shape = Box{400, 2},
                   .position = -1 * tilt.yAxis(),
                   .rotation = tilt,
                   .material = material,
                   .type = BodyType::Static});
        const BodyId ball =
            world.add(support::ballDef(Real(0.5) * tilt.yAxis(), Real(0.5), material));
        support::run(world, 120);
        const double v = 2.0 / 3 * 10 * std::sin(angle) * 2;
        EXPECT_TRUE(nearShare(dot(world[ball].velocity(), tilt.xAxis()), v, 0.01));
        EXPECT_TRUE(nearShare(world[ball].angularVelocity(), -v / 0.5, 0.01));
    }
}

// With friction below tan / 3 it slips: a = g (sin - mu cos), with an angular acceleration of 2 mu
// g cos / r.
TEST(Rolling, DownAnInclineSlipsWithoutEnoughFriction) {
    constexpr double kAngle = 3.14159265358979 / 6;
    constexpr double kFriction = 0.1; // tan / 3 = 0.19
    const Rot tilt = Rot::fromAngle(static_cast<Real>(-kAngle));
    World world({.gravity = support::kEarth});
    const Material material = withFriction(static_cast<Real>(kFriction));
    world.add({.shape = Box{400, 2},
               .position = -1 * tilt.yAxis(),
               .rotation = tilt,
               .material = material,
               .type = BodyType::Static});
    const BodyId ball = world.add(support::ballDef(Real(0.5) * tilt.yAxis(), Real(0.5), material));
    support::run(world, 120);
    const double press = 10 * std::cos(kAngle);
    const double v = 2 * (10 * std::sin(kAngle) - kFriction * press);
    EXPECT_TRUE(nearShare(dot(world[ball].velocity(), tilt.xAxis()), v, 0.01));
    EXPECT_TRUE(nearShare(world[ball].angularVelocity(), -2 * 2 * kFriction * press / 0.5, 0.01));
}

// R7: rolling without resistance keeps its speed, since friction does no work. The contact point is
// found once per step, in which the ball rotates by 0.1 rad. This loses a small part of the speed.
TEST(Rolling, WithoutResistanceKeepsItsSpeed) {
    World world({.gravity = support::kEarth});
    support::addFloor(world);
    BodyDef def = support::ballDef({0, Real(0.5)}, Real(0.5));
    def.velocity = {3, 0};
    def.angularVelocity = -6;
    const BodyId ball = world.add(def);
    support::run(world, 600);
    EXPECT_TRUE(near(world[ball].velocity().x, 3, Real(1e-3)));
}

// R7: rolling resistance c acts as a torque of c r m g. A rolling disc has an effective mass of 3/2
// m. It brakes with a = 2/3 c g and stops after v^2 / (2 a), within 2 %.
TEST(Rolling, WithResistanceStopsAtTheExactDistance) {
    World world({.gravity = support::kEarth});
    Material material = withFriction(Real(0.8));
    material.rollingResistance = Real(0.15);
    support::addFloor(world, material);
    BodyDef def = support::ballDef({0, Real(0.5)}, Real(0.5), material);
    def.velocity = {3, 0};
    def.angularVelocity = -6;
    const BodyId ball = world.add(def);
    support::run(world, 60);
    EXPECT_TRUE(nearShare(world[ball].velocity().x, 2, 0.02));
    support::run(world, 300);
    EXPECT_TRUE(near(world[ball].velocity().x, 0, byPrecision(1e-4, 1e-6)));
    EXPECT_TRUE(nearShare(world[ball].position().x, 4.5, 0.02));
}

} // namespace
} // namespace kodo
