// SPDX-License-Identifier: MIT
// A blow that several contacts of a body share at one instant, with what moves on its path: a bar
// that meets two parts, tiles of a lift that meet a crate across their seam.
#include <kodo/world.hpp>
#include <support/draws.hpp>
#include <support/random_numbers.hpp>
#include <support/scenes.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace kodo {
namespace {

using support::draws;
using support::RandomNumbers;

constexpr int kFrameRates[] = {60, 30, 120, 240}; // Hz

// Closed form: the blow on both parts goes through the centre of a symmetric body, which leaves at
// (1 + e) u, with the record of its whole momentum. Regression: one part alone took the blow of a
// bar within the step, and 241 to 384 of 400 bodies were turned, by up to 0.73 u.
TEST(SharedBlow, ABarThatMeetsTwoPartsTurnsNothing) {
    for (const StepSettings& settings : {balanced(), fast()}) {
        for (const int rate : kFrameRates) {
            RandomNumbers random(1);
            for (int i = 0; i < draws(200); ++i) {
                const Real u = random.between(1, 5);
                const Real e = random.between(0.2, 1);
                const Real half = random.between(0.3, 0.8);
                const Rot turn = i % 2 == 0 ? Rot{} : random.rotation();
                const Vec2 drift = random.point(3);
                World world({.gravity = {}, .settings = settings});
                const Material material = withFriction(0, e);
                world.add({.shape = Box{6, Real(0.4)},
                           .rotation = turn,
                           .velocity = turn * Vec2{0, u} + drift,
                           .material = material,
                           .type = BodyType::Kinematic});
                const Compound parts{
                    {Box{Real(0.4), Real(0.4), {-half, 0}}, Box{Real(0.4), Real(0.4), {half, 0}}}};
                const BodyId body =
                    world.add({.shape = parts,
                               .position = turn * Vec2{0, random.between(0.45, 1.4)},
                               .rotation = turn,
                               .velocity = drift,
                               .material = material});
                Real told = 0; // N s
                for (int step = 0; step < 2 * rate; ++step) {
                    world.step(1 / static_cast<Real>(rate));
                    for (const CollisionRecord& hit : world.hits(0)) {
                        told += hit.totalImpulse;
                    }
                }
                SCOPED_TRACE(testing::Message() << "draw " << i << ", " << rate << " Hz");
                // A turned bar meets one part a rounding error before the other.
                const Real arms = (half + Real(0.2)) * std::abs(world[body].angularVelocity());
                EXPECT_LT(arms, u / 1000);
                const Real left = dot(turn * Vec2{0, 1}, world[body].velocity() - drift);
                EXPECT_NEAR(left, (1 + e) * u, u / 100);
                EXPECT_NEAR(told, world[body].mass() * left, world[body].mass() * u / 100);
            }
        }
    }
}

// A level crate that falls across a seam of a lift, or of a floor one side of which creeps away.
// Regression: each tile that moved hit it for itself, and half of 200 crates were turned, at up to
// 46 rad/s.
TEST(SharedBlow, TilesOfALiftTurnNoLevelCrate) {
    for (const bool all : {true, false}) {
        for (const int rate : kFrameRates) {
            RandomNumbers random(2);
            for (int i = 0; i < draws(200); ++i) {
                const Material material = withFriction(Real(0.5), random.between(0.02, 0.3));
                const Real side = random.between(0.3, 0.9);
                const Vec2 motion = all ? random.point(1) : Vec2{Real(-0.001), 0};
                World world({.gravity = support::kEarth});
                for (int k = -2; k < 2; ++k) {
                    const bool moves = all || k < 0;
                    world.add({.shape = Box{1, Real(0.5)},
                               .position = {Real(k) + Real(0.5), Real(-0.25)},
                               .velocity = moves ? motion : Vec2{},
                               .material = material,
                               .type = moves ? BodyType::Kinematic : BodyType::Static});
                }
                BodyDef crate{.shape = Box{side, side}, .material = material};
                crate.velocity.x = all ? motion.x : Real(0);
                crate.position = {random.between(-0.45, 0.45) * side,
                                  side / 2 + random.between(0.5, 2)};
                const BodyId body = world.add(crate);
                int hits = 0;
                for (int step = 0; step < rate && hits == 0; ++step) {
                    world.step(1 / static_cast<Real>(rate));
                    hits = static_cast<int>(world.hits(1).size());
                }
                EXPECT_GT(hits, 0);
                EXPECT_LT(std::abs(world[body].angularVelocity()), Real(0.2))
                    << "draw " << i << ", " << rate << " Hz, all " << all;
            }
        }
    }
}

} // namespace
} // namespace kodo
