// SPDX-License-Identifier: MIT
#include <support/near.hpp>
#include <support/same_bits.hpp>

#include <gtest/gtest.h>
#include <solve/random_pins.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::sameBits;

// The fastest are those for AVX2, where the machine and the build have it, and else the others.
TEST(PinPasses, ForAllMachinesAndTheFastestGiveTheSameBits) {
    const PinPasses* const avx2 = PinPasses::avx2();
    ASSERT_EQ(&PinPasses::best(), avx2 != nullptr ? avx2 : &PinPasses::baseline());
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        RandomPins wide(seed);
        RandomPins narrow(seed);
        wide.runAll(PinPasses::best());
        narrow.runAll(PinPasses::baseline());
        EXPECT_TRUE(sameBits(wide.motion, narrow.motion));
        EXPECT_TRUE(sameBits(wide.blocks, narrow.blocks));
    }
}

// To a few roundings, or after a hundred radians to as many as that has.
TEST(PinPasses, TurnArmsByAnyAngle) {
    RandomPins pins(3);
    pins.run(PinPasses::best().turn, {});
    double farthest = 0;
    pins.forEach([&](std::uint32_t a, std::uint32_t b, const PinBlock& block, std::size_t lane) {
        const auto expectTurned = [&](std::uint32_t body, Vec2 from, Vec2 to) {
            const auto turn = static_cast<double>(pins.motion[body].turn);
            const auto x = static_cast<double>(from.x);
            const auto y = static_cast<double>(from.y);
            const Real most = 8 * support::kEpsilon;
            EXPECT_TRUE(near(to.x, std::cos(turn) * x - std::sin(turn) * y, most)) << turn;
            EXPECT_TRUE(near(to.y, std::sin(turn) * x + std::cos(turn) * y, most)) << turn;
            farthest = std::max(farthest, std::abs(turn));
        };
        expectTurned(a, RandomPins::get(block.startA, lane), RandomPins::get(block.armA, lane));
        expectTurned(b, RandomPins::get(block.startB, lane), RandomPins::get(block.armB, lane));
    });
    EXPECT_GT(farthest, 50);
}

// What PointConstraint does for one joint, also between bodies that turn only, and that nothing can
// push: to the rounding of some dozen operations on numbers of size 100.
TEST(PinPasses, DoWhatOneConstraintDoes) {
    RandomPins pins(5);
    pins.run(PinPasses::best().turn, {});
    RandomPins solved = pins;
    const Softness soft = Softness::from(60, 2, RandomPins::kStep);
    solved.run(PinPasses::best().relax, soft);
    std::size_t pushed = 0;
    pins.forEach([&](std::uint32_t a, std::uint32_t b, const PinBlock& block, std::size_t lane) {
        const PointConstraint point{RandomPins::get(block.armA, lane),
                                    RandomPins::get(block.armB, lane),
                                    RandomPins::get(block.gap, lane), soft};
        Vec2 impulse = RandomPins::get(block.impulse, lane);
        point.solve(pins.motion[a], pins.motion[b], impulse, false);
        const Real most = byPrecision(1e-3, 1e-11);
        for (const std::uint32_t body : {a, b}) {
            const Motion& now = solved.motion[body];
            EXPECT_TRUE(near(now.velocity, pins.motion[body].velocity, most));
            EXPECT_TRUE(near(now.angularVelocity, pins.motion[body].angularVelocity, most));
        }
        pushed += impulse != RandomPins::get(block.impulse, lane) ? 1 : 0;
    });
    EXPECT_GT(pushed, kPinBlocks * kPinLanes / 2);
    EXPECT_EQ(std::memcmp(&solved.motion[0], &pins.motion[0], sizeof(Motion)), 0);
}

// A stiff pin closes its gap within the substep, though its anchors move on arcs: to the fifth
// order of their turns, q^5 / 120 of an arm.
TEST(PinPasses, CloseAGapAlongArcs) {
    RandomPins pins(7);
    support::RandomNumbers random(8);
    for (std::size_t body = 1; body < pins.motion.size(); ++body) {
        pins.motion[body].invMass = 1;
        pins.motion[body].invInertia = 1;
        pins.motion[body].halt();
    }
    for (std::size_t i = 0; i < kPinBlocks; ++i) {
        PinBlock& block = pins.blocks[i];
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
    const PinPasses& passes = PinPasses::best();
    pins.run(passes.turn, {});
    for (int pass = 0; pass < 20; ++pass) { // the bend goes by the spin before the push
        pins.run(passes.solve, Softness::rigid(kH));
    }
    Real widest = 0;
    for (Motion& body : pins.motion) {
        body.move += kH * body.velocity;
        body.turn += kH * body.angularVelocity;
        widest = std::max(widest, std::abs(body.turn));
    }
    EXPECT_GT(widest, Real(0.03));
    EXPECT_LT(widest, Real(0.06));
    pins.run(passes.turn, {});
    pins.forEach([&](std::uint32_t, std::uint32_t, const PinBlock& block, std::size_t lane) {
        EXPECT_LT(length(RandomPins::get(block.gap, lane)), byPrecision(1e-6, 1e-8));
    });
}

} // namespace
} // namespace kodo
