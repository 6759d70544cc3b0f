// SPDX-License-Identifier: MIT
#include <kodo/solve/contact_block.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace kodo {
namespace {

constexpr int kContacts = ContactBlock::kContacts;
constexpr std::size_t kBlocks = 40;
constexpr Real kSettleBelow = Real(-0.01); // m; two of five contacts

/// Blocks of contacts between bodies of their own, some without rolling, some with one point only,
/// some apart, some deep, some between a body and one that cannot be pushed.
struct Blocks {
    std::vector<Motion> motion;
    std::vector<Extent> extent;
    std::vector<Carried> carried = std::vector<Carried>(kBlocks * kContacts);
    std::vector<ContactBlock> blocks = std::vector<ContactBlock>(kBlocks);
    std::vector<RollingBlock> rolling;
    std::vector<BlockUse> use = std::vector<BlockUse>(kBlocks);
    std::vector<std::uint32_t> order;

    explicit Blocks(std::uint64_t seed) {
        support::RandomNumbers random(seed);
        for (std::size_t i = 0; i < kBlocks; ++i) {
            order.push_back(static_cast<std::uint32_t>(i));
            use[i].twoPoints = random.below(2) == 0;
            use[i].onLocked = random.below(4) == 0;
            use[i].movesA = use[i].onLocked ? 0 : 0xff;
            use[i].movesB = 0xff;
            if (random.below(3) == 0) {
                use[i].rolling = static_cast<std::int32_t>(rolling.size());
                rolling.emplace_back();
            }
            for (std::size_t lane = 0; lane < kContacts; ++lane) {
                fill(random, i, lane);
            }
        }
    }

    std::uint32_t addBody(support::RandomNumbers& random, bool locked) {
        Motion body;
        body.velocity = random.point(5);
        body.angularVelocity = random.between(-3, 3);
        body.invMass = locked ? 0 : random.between(0.1, 4);
        body.move = random.point(0.01);
        body.turn = random.between(-0.01, 0.01);
        body.invInertia = locked ? 0 : random.between(0.1, 9);
        motion.push_back(body);
        extent.push_back({random.between(0.1, 2), 0});
        return static_cast<std::uint32_t>(motion.size() - 1);
    }

    void fill(support::RandomNumbers& random, std::size_t i, std::size_t lane) {
        ContactBlock& block = blocks[i];
        block.a[lane] = placeOfMotion(addBody(random, use[i].onLocked));
        block.b[lane] = placeOfMotion(addBody(random, false));
        const Rot normal = random.rotation();
        block.normalX[lane] = normal.c;
        block.normalY[lane] = normal.s;
        for (std::size_t k = 0; k < (use[i].twoPoints ? 2u : 1u); ++k) {
            ContactBlock::Point& point = block.points[k];
            point.leverA[lane] = random.between(-0.5, 0.5);
            point.leverB[lane] = random.between(-0.5, 0.5);
            point.mass[lane] = random.between(0.1, 2);
            point.separation[lane] = random.between(-0.03, 0.02);
            point.impulse[lane] = random.below(3) == 0 ? 0 : random.between(0, 2);
        }
        block.tangentLeverA[lane] = random.between(-0.5, 0.5);
        block.tangentLeverB[lane] = random.between(-0.5, 0.5);
        block.tangentMass[lane] = random.between(0.1, 2);
        block.friction[lane] = random.between(-1, 1);
        block.staticFriction[lane] = random.between(0, 1);
        block.kineticFriction[lane] = Real(0.8) * block.staticFriction[lane];
        block.pushSpeed[lane] = 3;
        if (use[i].rolling >= 0) {
            RollingBlock& own = rolling[static_cast<std::size_t>(use[i].rolling)];
            own.lever[lane] = random.between(0, 0.1);
            own.mass[lane] = random.between(0.1, 2);
            own.impulse[lane] = random.between(-0.1, 0.1);
        }
    }

    ContactPassArguments pass() {
        const Real h = Real(1) / 240;
        return {
            blocks.data(),
            rolling.data(),
            use.data(),
            order.data(),
            kBlocks,
            motion.data(),
            {Softness::from(60, 10, h), Softness::from(120, 10, h), 1 / h, true, 1, kSettleBelow}};
    }

    /// A whole substep, and another, and to the next step.
    void run(const ContactPasses& passes) {
        ContactPassArguments pass = this->pass();
        for (int substep = 0; substep < 2; ++substep) {
            pass.settings.kept = substep == 0 ? Real(0) : Real(1);
            passes.warmStart(pass);
            passes.solve(pass);
            passes.settle(pass);
            passes.relax(pass);
        }
        passes.carry({blocks.data(), carried.data(), use.data(), order.data(), kBlocks,
                      motion.data(), extent.data()});
    }
};

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(ContactPasses, ForAllMachinesAndForAvx2GiveTheSameBits) {
    const ContactPasses* const avx2 = ContactPasses::avx2();
    if (avx2 == nullptr) {
        GTEST_SKIP() << "this machine, or this build, has no AVX2";
    }
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Blocks wide(seed);
        Blocks narrow(seed);
        wide.run(*avx2);
        narrow.run(ContactPasses::baseline());
        EXPECT_TRUE(sameBits(wide.motion, narrow.motion));
        EXPECT_TRUE(sameBits(wide.blocks, narrow.blocks));
        EXPECT_TRUE(sameBits(wide.rolling, narrow.rolling));
        EXPECT_TRUE(sameBits(wide.carried, narrow.carried));
    }
}

// Impulses act between two bodies, so whatever the passes do, no momentum is made: to the rounding
// of some hundred operations on numbers of size 10.
TEST(ContactPasses, KeepMomentum) {
    Blocks blocks(7);
    const std::vector<Motion> before = blocks.motion;
    blocks.run(ContactPasses::best());
    constexpr double kRounding = sizeof(Real) == 4 ? 1e-4 : 1e-12;
    std::size_t pushed = 0;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        for (std::size_t lane = 0; lane < kContacts && !blocks.use[i].onLocked; ++lane) {
            const std::uint32_t a = bodyOfPlace(blocks.blocks[i].a[lane]);
            const std::uint32_t b = bodyOfPlace(blocks.blocks[i].b[lane]);
            const auto momentum = [&](const std::vector<Motion>& motion) {
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

// After the passes contacts only push, and friction stays within the static cone.
TEST(ContactPasses, PushAndNeverPull) {
    Blocks blocks(9);
    blocks.run(ContactPasses::best());
    for (const ContactBlock& block : blocks.blocks) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const Real first = block.points[0].impulse[lane];
            const Real second = block.points[1].impulse[lane];
            EXPECT_GE(first, 0);
            EXPECT_GE(second, 0);
            EXPECT_LE(std::abs(block.friction[lane]),
                      block.staticFriction[lane] * (first + second));
        }
    }
}

/// What the passes know of one contact, in the precision of a double.
struct Alone {
    const Motion& a;
    const Motion& b;
    Vec2 normal;

    Alone(const std::vector<Motion>& motion, const ContactBlock& block, std::size_t lane)
        : a(motion[bodyOfPlace(block.a[lane])]),
          b(motion[bodyOfPlace(block.b[lane])]),
          normal{block.normalX[lane], block.normalY[lane]} {}

    double speed(Vec2 direction, Real leverA, Real leverB) const {
        return double(dot(direction, b.velocity - a.velocity)) +
               double(leverB) * double(b.angularVelocity) -
               double(leverA) * double(a.angularVelocity);
    }
    double gap(const ContactBlock::Point& point, std::size_t lane) const {
        return double(point.separation[lane]) + double(dot(normal, b.move - a.move)) +
               double(point.leverB[lane]) * double(b.turn) -
               double(point.leverA[lane]) * double(a.turn);
    }
};

// The passes take the two scales of Softness for one. To the rounding of numbers of up to 50.
TEST(ContactPasses, PushAsSoftnessSays) {
    const Blocks before(13);
    Blocks after(13);
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

// Friction that holds leaves no speed along the tangent, although it is found from the speeds of
// before the push along the normal.
TEST(ContactPasses, FrictionThatHoldsStopsAllSliding) {
    Blocks blocks(15);
    for (ContactBlock& block : blocks.blocks) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const Alone alone(blocks.motion, block, lane);
            const Real leverA = block.tangentLeverA[lane];
            const Real leverB = block.tangentLeverB[lane];
            block.tangentMass[lane] =
                1 / (alone.a.invMass + alone.b.invMass + alone.a.invInertia * leverA * leverA +
                     alone.b.invInertia * leverB * leverB);
            block.staticFriction[lane] = 1000;
        }
    }
    ContactPasses::best().relax(blocks.pass());
    constexpr double kRounding = sizeof(Real) == 4 ? 1e-4 : 1e-12;
    int held = 0;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        const ContactBlock& block = blocks.blocks[i];
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            const Real pressed = block.points[0].impulse[lane] + block.points[1].impulse[lane];
            if (blocks.use[i].rolling >= 0 || pressed < Real(0.1)) {
                continue; // rolling resistance turns both anew; without a press nothing holds
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

// The first substep of a step begins the sums anew, whatever the last step left there.
TEST(ContactPasses, SumUpFromTheFirstSubstepOn) {
    Blocks blocks(19);
    for (ContactBlock& block : blocks.blocks) {
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            block.points[0].largest[lane] = block.points[1].largest[lane] = Real(1e6);
            block.total[lane] = Real(-1e6);
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
            EXPECT_EQ(blocks.blocks[i].total[lane], total) << "block " << i << ", " << lane;
            for (std::size_t k = 0; k < (blocks.use[i].twoPoints ? 2u : 1u); ++k) {
                EXPECT_EQ(blocks.blocks[i].points[k].largest[lane],
                          std::max(first[i].points[k].impulse[lane],
                                   blocks.blocks[i].points[k].impulse[lane]))
                    << "block " << i << ", " << lane;
            }
        }
    }
}

// A settling pass is for the contacts with less separation than it is told, in whatever lanes they
// are: of the others it changes no bit, and of those as much as if it had been for all.
TEST(ContactPasses, SettleThoseThatAreDeepAndNoOther) {
    for (const ContactPasses* passes : {&ContactPasses::baseline(), &ContactPasses::best()}) {
        SCOPED_TRACE(passes->name);
        const Blocks before(11);
        Blocks some(11);
        Blocks all(11);
        passes->settle(some.pass());
        ContactPassArguments forAll = all.pass();
        forAll.settings.settleBelow = std::numeric_limits<Real>::max();
        passes->settle(forAll);
        std::size_t deep = 0;
        for (std::size_t i = 0; i < kBlocks; ++i) {
            const ContactBlock& own = some.blocks[i];
            for (std::size_t lane = 0; lane < kContacts; ++lane) {
                const bool settles = own.points[0].separation[lane] < kSettleBelow;
                deep += settles ? 1 : 0;
                const Blocks& expected = settles ? all : before;
                for (const std::uint32_t body :
                     {bodyOfPlace(own.a[lane]), bodyOfPlace(own.b[lane])}) {
                    EXPECT_EQ(some.motion[body].velocity, expected.motion[body].velocity);
                    EXPECT_EQ(some.motion[body].angularVelocity,
                              expected.motion[body].angularVelocity);
                }
                EXPECT_EQ(own.points[0].impulse[lane], expected.blocks[i].points[0].impulse[lane]);
                EXPECT_EQ(own.points[1].impulse[lane], expected.blocks[i].points[1].impulse[lane]);
            }
        }
        EXPECT_GT(deep, 0u);
        EXPECT_LT(deep, kBlocks * kContacts);
    }
}

} // namespace
} // namespace kodo
