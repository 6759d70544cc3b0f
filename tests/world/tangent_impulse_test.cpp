// SPDX-License-Identifier: MIT
// What a collision record says of friction.
#include "support/solver.hpp"
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace kodo {
namespace {

using support::byPrecision;
using support::nearShare;

constexpr Real kGravity = 10; // m/s^2

/// A crate of 1 kg that slides to `side` on a floor tilted by `slope` (rad); friction of `mu`.
struct Slide {
    World world;
    BodyId floor;
    BodyId crate;

    Slide(const StepSettings& settings, Real slope, Real mu, Real speed)
        : world({.gravity = kGravity * Vec2{std::sin(slope), -std::cos(slope)},
                 .settings = settings}) {
        const Material rough = withFriction(mu);
        floor = world.add({.shape = Box{400, 1},
                           .position = {0, Real(-0.5)},
                           .material = rough,
                           .type = BodyType::Static});
        BodyDef def = support::boxDef({0, Real(0.5)}, 1, 1);
        def.material = rough;
        def.velocity = {speed, 0};
        crate = world.add(def);
        world[crate].setFlags(kNeverSleep);
    }
};

// J_t = -mu J_n against the motion of b, at any rate, to both sides, by both solvers.
TEST(TangentImpulse, OfASlidingCrateIsFrictionTimesTheNormalImpulse) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real rate : {Real(30), Real(60), Real(240)}) {
            for (const Real side : {Real(-1), Real(1)}) {
                SCOPED_TRACE(testing::Message() << "rate " << rate << " side " << side);
                Slide slide(support::settingsOf(solver), 0, Real(0.3), side * 20);
                for (int i = 0; i < 20; ++i) {
                    slide.world.step(1 / rate);
                }
                const CollisionRecord* hit =
                    support::recordOf(slide.world, slide.floor, slide.crate);
                ASSERT_NE(hit, nullptr);
                const Real onCrate =
                    (hit->b == slide.crate ? 1 : -1) * hit->tangentImpulse * perp(hit->normal).x;
                EXPECT_TRUE(nearShare(-side * onCrate, Real(0.3) * hit->totalImpulse,
                                      byPrecision(1e-5, 1e-9)));
                EXPECT_TRUE(nearShare(hit->totalImpulse, kGravity / rate, byPrecision(1e-3, 1e-3)));
            }
        }
    }
}

// On a slope friction carries m g sin(slope), in each step.
TEST(TangentImpulse, OfARestingCrateCarriesItsWeightAlongTheSlope) {
    for (const support::Solver solver : support::kSolvers) {
        for (const Real slope : {Real(-0.4), Real(0.1), Real(0.4)}) {
            SCOPED_TRACE(slope);
            Slide slide(support::settingsOf(solver), slope, Real(0.6), 0);
            for (int i = 0; i < 240; ++i) {
                slide.world.step(support::kDt);
            }
            const CollisionRecord* hit = support::recordOf(slide.world, slide.floor, slide.crate);
            ASSERT_NE(hit, nullptr);
            const Real onCrate = hit->tangentImpulse * perp(hit->normal).x;
            EXPECT_TRUE(nearShare(-onCrate, kGravity * std::sin(slope) * support::kDt,
                                  byPrecision(2e-3, 2e-3)));
        }
    }
}

/// N s; impulse of all contacts on the body in the last step.
Vec2 impulseOn(const World& world, BodyId body) {
    Vec2 sum{};
    for (const CollisionRecord& hit : world.collisions(body)) {
        const Vec2 onB = hit.totalImpulse * hit.normal + hit.tangentImpulse * perp(hit.normal);
        sum += hit.b == body ? onB : -onB;
    }
    return sum;
}

// m (v' - v) along the ground is the impulse of friction: nothing that acts on a disc which lands
// with a spin, bounces and rolls is left out.
TEST(TangentImpulse, IsTheChangeOfMomentumAlongTheGround) {
    for (const support::Solver solver : support::kSolvers) {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            SCOPED_TRACE(seed);
            std::mt19937 random(seed);
            std::uniform_real_distribution<Real> any(-1, 1);
            World world({.gravity = {0, -kGravity}, .settings = support::settingsOf(solver)});
            const Material rough = withFriction(Real(0.5), Real(0.4));
            world.add({.shape = Box{200, 1}, .material = rough, .type = BodyType::Static});
            BodyDef def = support::ballDef({0, 3}, Real(0.5), rough);
            def.velocity = {5 * any(random), 2 * any(random)};
            def.angularVelocity = 40 * any(random);
            const BodyId body = world.add(def);
            const Real mass = world[body].mass();
            for (int i = 0; i < 120 && !world[body].isAsleep(); ++i) {
                const Real before = world[body].velocity().x;
                world.step(support::kDt);
                const Real change = mass * (world[body].velocity().x - before);
                ASSERT_LT(std::abs(change - impulseOn(world, body).x),
                          mass * byPrecision(1e-5, 1e-12))
                    << "step " << i;
            }
        }
    }
}

} // namespace
} // namespace kodo
