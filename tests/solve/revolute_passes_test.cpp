// SPDX-License-Identifier: MIT
#include <support/near.hpp>
#include <support/same_bits.hpp>

#include <gtest/gtest.h>
#include <solve/random_revolutes.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::sameBits;

// The fastest passes are those for AVX2 if build and machine have it, else the baseline.
TEST(RevolutePasses, BaselineAndFastestGiveTheSameBits) {
    const RevolutePasses* const avx2 = RevolutePasses::avx2();
    ASSERT_EQ(&RevolutePasses::best(), avx2 != nullptr ? avx2 : &RevolutePasses::baseline());
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        RandomPins wide(seed, true);
        RandomPins narrow(seed, true);
        wide.runAll(RevolutePasses::best());
        narrow.runAll(RevolutePasses::baseline());
        EXPECT_TRUE(sameBits(wide.motion, narrow.motion));
        EXPECT_TRUE(sameBits(wide.blocks, narrow.blocks));
        EXPECT_TRUE(sameBits(wide.angles, narrow.angles));
    }
}

// Up to a few roundings of the result, also after a rotation by a hundred radians.
TEST(RevolutePasses, RotateArmsByAnyAngle) {
    RandomPins pins(3);
    pins.run(RevolutePasses::best().rotate, {});
    double farthest = 0;
    pins.forEach(
        [&](std::uint32_t a, std::uint32_t b, const RevoluteBlock& block, std::size_t lane) {
            const auto expectTurned = [&](std::uint32_t body, Vec2 from, Vec2 to) {
                const auto turn = static_cast<double>(pins.motion[body].deltaAngle);
                const auto x = static_cast<double>(from.x);
                const auto y = static_cast<double>(from.y);
                const Real most = 16 * support::kEpsilon;
                EXPECT_TRUE(near(to.x, std::cos(turn) * x - std::sin(turn) * y, most)) << turn;
                EXPECT_TRUE(near(to.y, std::sin(turn) * x + std::cos(turn) * y, most)) << turn;
                farthest = std::max(farthest, std::abs(turn));
            };
            // body a has its arm to anchor b, which is farther by the gap
            expectTurned(a, RandomPins::get(block.startA, lane),
                         RandomPins::get(block.armA, lane) - RandomPins::get(block.gap, lane));
            expectTurned(b, RandomPins::get(block.startB, lane), RandomPins::get(block.armB, lane));
        });
    EXPECT_GT(farthest, 50);
}

// The result of PointConstraint for a single joint, also for bodies that cannot rotate and for
// locked ones. Tolerance: the rounding of some dozen operations on numbers of size 100.
TEST(RevolutePasses, AgreeWithASinglePointConstraint) {
    RandomPins pins(5);
    pins.run(RevolutePasses::best().rotate, {});
    RandomPins solved = pins;
    const Softness soft = Softness::from(60, 2, RandomPins::kStep);
    solved.run(RevolutePasses::best().relax, soft);
    std::size_t pushed = 0;
    pins.forEach(
        [&](std::uint32_t a, std::uint32_t b, const RevoluteBlock& block, std::size_t lane) {
            const PointConstraint point{RandomPins::get(block.armA, lane),
                                        RandomPins::get(block.armB, lane),
                                        RandomPins::get(block.gap, lane), soft};
            Vec2 impulse = RandomPins::get(block.impulse, lane);
            point.solve(pins.motion[a], pins.motion[b], impulse, false);
            const Real most = byPrecision(1e-3, 1e-11);
            for (const std::uint32_t body : {a, b}) {
                const BodyVelocity& now = solved.motion[body];
                EXPECT_TRUE(near(now.velocity, pins.motion[body].velocity, most));
                EXPECT_TRUE(near(now.angularVelocity, pins.motion[body].angularVelocity, most));
            }
            pushed += impulse != RandomPins::get(block.impulse, lane) ? 1 : 0;
        });
    EXPECT_GT(pushed, kPinBlocks * kPinLanes / 2);
    EXPECT_EQ(std::memcmp(&solved.motion[0], &pins.motion[0], sizeof(BodyVelocity)), 0);
}

// A rigid revolute joint closes its gap within the substep, although its anchors move on arcs: up
// to the fifth order of the rotation q, q^5 / 120 of an arm.
TEST(RevolutePasses, CloseGapsAlongArcs) {
    RandomPins pins(7);
    support::RandomNumbers random(8);
    for (std::size_t body = 1; body < pins.motion.size(); ++body) {
        pins.motion[body].invMass = 1;
        pins.motion[body].invInertia = 1;
        pins.motion[body].clearDisplacement();
    }
    for (std::size_t i = 0; i < kPinBlocks; ++i) {
        RevoluteBlock& block = pins.blocks[i];
        pins.use[i] = {0xff, 0xff};
        for (std::size_t lane = 0; lane < kPinLanes && block.a[lane] != block.b[lane]; ++lane) {
            const Vec2 apart =
                RandomPins::get(block.startA, lane) - RandomPins::get(block.startB, lane);
            RandomPins::set(block.between, lane, apart + random.point(0.01));
            block.mass[lane] = 2;
            block.inertiaA[lane] = block.inertiaB[lane] = 1;
        }
    }
    constexpr Real kH = RandomPins::kStep;
    const RevolutePasses& passes = RevolutePasses::best();
    pins.run(passes.rotate, {});
    for (int pass = 0; pass < 20; ++pass) { // the curvature follows the spin before the impulse
        pins.run(passes.solve, Softness::rigid(kH));
    }
    Real widest = 0;
    for (BodyVelocity& body : pins.motion) {
        body.deltaPosition += kH * body.velocity;
        body.deltaAngle += kH * body.angularVelocity;
        widest = std::max(widest, std::abs(body.deltaAngle));
    }
    EXPECT_GT(widest, Real(0.03));
    EXPECT_LT(widest, Real(0.06));
    pins.run(passes.rotate, {});
    pins.forEach([&](std::uint32_t, std::uint32_t, const RevoluteBlock& block, std::size_t lane) {
        EXPECT_LT(length(RandomPins::get(block.gap, lane)), byPrecision(1e-6, 1e-8));
    });
}

} // namespace
} // namespace kodo
