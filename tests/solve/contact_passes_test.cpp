// SPDX-License-Identifier: MIT
#include <support/same_bits.hpp>

#include <gtest/gtest.h>
#include <solve/random_blocks.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace kodo {
namespace {

using support::sameBits;

// The fastest passes are those for AVX2 if build and machine have it, else the baseline.
TEST(ContactPasses, BaselineAndFastestGiveTheSameBits) {
    const ContactPasses* const avx2 = ContactPasses::avx2();
    ASSERT_EQ(&ContactPasses::best(), avx2 != nullptr ? avx2 : &ContactPasses::baseline());
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        RandomBlocks wide(seed);
        RandomBlocks narrow(seed);
        wide.run(ContactPasses::best());
        narrow.run(ContactPasses::baseline());
        EXPECT_TRUE(sameBits(wide.motion, narrow.motion));
        EXPECT_TRUE(sameBits(wide.blocks, narrow.blocks));
        EXPECT_TRUE(sameBits(wide.surfaces, narrow.surfaces));
    }
}

// Impulses act between two bodies, so the passes conserve momentum: up to the rounding of some
// hundred operations on numbers of size 10.
TEST(ContactPasses, ConserveMomentum) {
    RandomBlocks blocks(7);
    const std::vector<BodyVelocity> before = blocks.motion;
    blocks.run(ContactPasses::best());
    constexpr double kRounding = sizeof(Real) == 4 ? 1e-4 : 1e-12;
    std::size_t pushed = 0;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        for (std::size_t lane = 0; lane < kContacts && !blocks.use[i].onLocked; ++lane) {
            const std::uint32_t a = bodyOfPlace(blocks.blocks[i].a[lane]);
            const std::uint32_t b = bodyOfPlace(blocks.blocks[i].b[lane]);
            const auto momentum = [&](const std::vector<BodyVelocity>& motion) {
                return motion[a].velocity / motion[a].invMass +
                       motion[b].velocity / motion[b].invMass;
            };
            EXPECT_LE(length(momentum(blocks.motion) - momentum(before)), kRounding)
                << "block " << i << ", lane " << lane;
            pushed += blocks.motion[a].velocity != before[a].velocity ? 1 : 0;
        }
    }
    EXPECT_GT(pushed, kBlocks); // most of them
}

// After the passes normal impulses are at least 0, and friction stays within the static cone.
TEST(ContactPasses, ImpulsesNeverPullAndFrictionStaysInItsCone) {
    RandomBlocks blocks(9);
    blocks.run(ContactPasses::best());
    for (const ContactBlock& block : blocks.blocks) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const Real first = block.points[0].impulse[lane];
            const Real second = block.points[1].impulse[lane];
            EXPECT_GE(first, 0);
            EXPECT_GE(second, 0);
            EXPECT_LE(std::abs(block.friction[lane]),
                      std::abs(block.staticFriction[lane]) * (first + second));
        }
    }
}

/// One contact of a block, evaluated in double.
struct Alone {
    const BodyVelocity& a;
    const BodyVelocity& b;
    Vec2 normal;

    Alone(const std::vector<BodyVelocity>& motion, const ContactBlock& block, std::size_t lane)
        : a(motion[bodyOfPlace(block.a[lane])]),
          b(motion[bodyOfPlace(block.b[lane])]),
          normal{block.normalX[lane], block.normalY[lane]} {}

    double speed(Vec2 direction, Real leverA, Real leverB) const {
        return double(dot(direction, b.velocity - a.velocity)) +
               double(leverB) * double(b.angularVelocity) -
               double(leverA) * double(a.angularVelocity);
    }
    double gap(const ContactBlock::Point& point, std::size_t lane) const {
        return double(point.separation[lane]) +
               double(dot(normal, b.deltaPosition - a.deltaPosition)) +
               double(point.leverB[lane]) * double(b.deltaAngle) -
               double(point.leverA[lane]) * double(a.deltaAngle);
    }
};

// The passes combine the two scales of Softness. Tolerance: the rounding of numbers of up to 50.
TEST(ContactPasses, ImpulsesFollowTheFormulaOfSoftness) {
    const RandomBlocks before(13);
    RandomBlocks after(13);
    const ContactPassArguments pass = after.pass();
    ContactPasses::best().solve(pass);
    constexpr double kRounding = sizeof(Real) == 4 ? 1e-4 : 1e-12;
    int gaps = 0;
    int pushed = 0;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        const Softness& soft = before.use[i].onLocked ? pass.settings.onLocked : pass.settings.soft;
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const ContactBlock& block = before.blocks[i];
            const ContactBlock::Point& point = block.points[0];
            const Alone alone(before.motion, block, lane);
            const double s = alone.gap(point, lane);
            const double deepest = std::min(s, alone.gap(block.points[1], lane));
            if (before.use[i].twoPoints &&
                double(soft.biasRate) * deepest < -double(pass.settings.pushSpeed) / 40) {
                continue; // both points at once; see sequential_impulses_test.cpp
            }
            const double v = alone.speed(alone.normal, point.leverA[lane], point.leverB[lane]);
            const double m = double(point.mass[lane]);
            const double sum = double(point.impulse[lane]);
            const double overlap =
                std::max(double(soft.biasRate) * s, -double(block.pushSpeed[lane]));
            const double wanted = s > 0 ? sum - m * (v + double(pass.settings.invH) * s)
                                        : sum - double(soft.massScale) * m * (v + overlap) -
                                              double(soft.impulseScale) * sum;
            const double given = double(after.blocks[i].points[0].impulse[lane]);
            EXPECT_NEAR(given, std::max(wanted, 0.0), kRounding) << "block " << i << ", " << lane;
            gaps += s > 0 ? 1 : 0;
            pushed += given > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(gaps, 20);
    EXPECT_GT(pushed, 100);
}

// Sticking friction leaves no speed along the tangent, although it is computed from the speeds
// before the normal impulse.
TEST(ContactPasses, StickingFrictionStopsAllSliding) {
    RandomBlocks blocks(15);
    for (ContactBlock& block : blocks.blocks) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const Alone alone(blocks.motion, block, lane);
            const Real leverA = block.tangentLeverA[lane];
            const Real leverB = block.tangentLeverB[lane];
            block.tangentMass[lane] =
                1 / (alone.a.invMass + alone.b.invMass + alone.a.invInertia * leverA * leverA +
                     alone.b.invInertia * leverB * leverB);
            block.staticFriction[lane] = 1000;
            block.kineticFriction[lane] = 1000;
        }
    }
    ContactPasses::best().relax(blocks.pass());
    constexpr double kRounding = sizeof(Real) == 4 ? 1e-4 : 1e-12;
    int held = 0;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        const ContactBlock& block = blocks.blocks[i];
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const Real pressed = block.points[0].impulse[lane] + block.points[1].impulse[lane];
            if (blocks.use[i].surface >= 0 || pressed < Real(0.1)) {
                continue; // rolling changes the spin later; no pressure, no friction
            }
            const Alone alone(blocks.motion, block, lane);
            EXPECT_NEAR(alone.speed(perp(alone.normal), block.tangentLeverA[lane],
                                    block.tangentLeverB[lane]),
                        0, kRounding)
                << "block " << i << ", " << lane;
            ++held;
        }
    }
    EXPECT_GT(held, 50);
}

// The first substep of a step resets the sums of the last step.
TEST(ContactPasses, SumsStartInTheFirstSubstep) {
    RandomBlocks blocks(19);
    for (ContactBlock& block : blocks.blocks) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            block.points[0].largest[lane] = block.points[1].largest[lane] = Real(1e6);
            block.total[0][lane] = Real(-1e6);
        }
    }
    const ContactPasses& passes = ContactPasses::best();
    ContactPassArguments pass = blocks.pass();
    pass.settings.kept = 0;
    passes.relax(pass);
    const std::vector<ContactBlock> first = blocks.blocks;
    pass.settings.kept = 1;
    passes.solve(pass);
    passes.relax(pass);
    for (std::size_t i = 0; i < kBlocks; ++i) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const auto sumOf = [&](const ContactBlock& block) {
                return block.points[0].impulse[lane] + block.points[1].impulse[lane];
            };
            const Real total = sumOf(first[i]) + sumOf(blocks.blocks[i]);
            EXPECT_EQ(blocks.blocks[i].total[0][lane], total) << "block " << i << ", " << lane;
            for (std::size_t k = 0; k < (blocks.use[i].twoPoints ? 2u : 1u); ++k) {
                EXPECT_EQ(blocks.blocks[i].points[k].largest[lane],
                          std::max(first[i].points[k].impulse[lane],
                                   blocks.blocks[i].points[k].impulse[lane]))
                    << "block " << i << ", " << lane;
            }
        }
    }
}

} // namespace
} // namespace kodo
