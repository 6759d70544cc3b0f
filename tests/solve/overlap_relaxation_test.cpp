// SPDX-License-Identifier: MIT
#include <support/same_bits.hpp>

#include <gtest/gtest.h>
#include <solve/random_blocks.hpp>

#include <limits>
#include <vector>

#include "soft/overlap_relaxation.hpp"

namespace kodo {
namespace {

using support::sameBits;

// Separations, m.
constexpr Real kDeepBelow = Real(-0.03);
constexpr Real kDeep = Real(-0.1);
constexpr Real kTouching = Real(-0.01);

/// Bodies on a line, 1 kg each unless locked, and their contacts. Each contact has a colour of its
/// own, unless it shares the last block.
struct Line {
    std::vector<BodyVelocity> motion;
    std::vector<std::uint16_t> crowd;
    std::vector<ContactBlock> blocks;
    std::vector<BlockUse> use;
    std::vector<std::uint32_t> order;
    std::vector<PassOrder::Colour> colours;
    OverlapRelaxation relaxation;

    std::uint32_t addBody(Real speed, bool locked = false) {
        BodyVelocity body;
        body.velocity = {speed, 0};
        body.invMass = locked ? 0 : 1;
        motion.push_back(body);
        crowd.push_back(0);
        return static_cast<std::uint32_t>(motion.size() - 1);
    }

    void addBlock() {
        order.push_back(static_cast<std::uint32_t>(blocks.size()));
        blocks.push_back({});
        use.push_back({});
        colours.push_back({1, false});
    }

    /// The normal from a to b is +x.
    void fill(std::size_t lane, std::uint32_t a, std::uint32_t b, Real separation, Real impulse) {
        ContactBlock& block = blocks.back();
        block.a[lane] = velocityOffset(a);
        block.b[lane] = velocityOffset(b);
        block.normalX[lane] = 1;
        block.points[0].mass[lane] = 1 / (motion[a].invMass + motion[b].invMass);
        block.points[0].separation[lane] = separation;
        block.points[0].impulse[lane] = impulse;
        const auto bit = [&](std::uint32_t body) {
            return static_cast<std::uint8_t>((motion[body].invMass > 0 ? 1u : 0u) << lane);
        };
        use.back().movesA |= bit(a);
        use.back().movesB |= bit(b);
    }

    void add(std::uint32_t a, std::uint32_t b, Real separation, Real impulse) {
        addBlock();
        fill(0, a, b, separation, impulse);
    }

    void settle() {
        const auto spare = velocityOffset(static_cast<std::uint32_t>(motion.size()));
        motion.emplace_back();
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            for (std::size_t lane = 0; lane < kContacts; ++lane) {
                if (((use[i].movesA | use[i].movesB) >> lane & 1) == 0) {
                    blocks[i].a[lane] = blocks[i].b[lane] = spare;
                }
            }
        }
        const Real h = Real(1) / 240;
        const ContactPassArguments all{
            blocks.data(),
            nullptr,
            use.data(),
            order.data(),
            order.size(),
            motion.data(),
            {Softness::from(60, 10, h), Softness::from(120, 10, h), 1 / h, true, 1}};
        relaxation.find({all, colours, kDeepBelow, crowd});
        relaxation.run(all);
    }

    Real speed(std::uint32_t body) const { return motion[body].velocity.x; }
    Real impulse(std::size_t block, std::size_t lane = 0) const {
        return blocks[block].points[0].impulse[lane];
    }
};

// Every contact within a cluster takes part, also those with locked bodies. Contacts that lead to
// another cluster, or to a body without deep overlaps, do not. One deep contact gives two passes.
TEST(OverlapRelaxation, AffectsOnlyContactsWithinACluster) {
    Line line;
    const std::uint32_t a = line.addBody(-1);
    const std::uint32_t b = line.addBody(1);
    const std::uint32_t c = line.addBody(-3);
    const std::uint32_t d = line.addBody(2);
    const std::uint32_t wall = line.addBody(0, true);
    const std::uint32_t other = line.addBody(7);
    line.add(a, b, kDeep, 5);
    line.add(b, c, kTouching, 5);
    line.add(c, d, kDeep, 5);
    line.add(d, wall, kTouching, 5);
    line.add(a, other, kTouching, 5);
    line.settle();
    // a and b: equal changes, until they no longer separate
    EXPECT_EQ(line.speed(a), 0);
    EXPECT_EQ(line.speed(b), 0);
    EXPECT_EQ(line.impulse(0), 4);
    EXPECT_EQ(line.impulse(1), 5);
    // c and d start with -3, 2. After their contact: -1/2, -1/2; after the wall: -1/2, 0; then the
    // same again
    EXPECT_EQ(line.speed(c), Real(-0.25));
    EXPECT_EQ(line.speed(d), 0);
    EXPECT_EQ(line.impulse(2), Real(2.25));
    EXPECT_EQ(line.impulse(3), Real(4.25));
    EXPECT_EQ(line.speed(other), 7);
    EXPECT_EQ(line.impulse(4), 5);
    EXPECT_EQ(line.relaxation.visits(), 2u * 1 + 2u * 2);
}

// Independent pairs side by side in two blocks, some of them deep. The deep pairs stop separating;
// the others do not change.
TEST(OverlapRelaxation, CopiesContactsFromAnyLanes) {
    support::RandomNumbers random(5);
    Line line;
    std::vector<Real> speeds;
    std::vector<bool> deep;
    for (std::size_t i = 0; i < 2; ++i) {
        line.addBlock();
        for (std::size_t lane = 0; lane < kContacts; ++lane) {
            speeds.push_back(random.between(0, 3));
            deep.push_back(random.below(3) != 0);
            const std::uint32_t a = line.addBody(-speeds.back());
            const std::uint32_t b = line.addBody(speeds.back());
            line.fill(lane, a, b, deep.back() ? kDeep : kTouching, 4);
        }
    }
    line.colours = {{2, false}};
    line.settle();
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        SCOPED_TRACE(i);
        const auto a = static_cast<std::uint32_t>(2 * i);
        const Real taken = deep[i] ? speeds[i] : 0; // of the impulse, kg m/s
        pairs += deep[i] ? 1 : 0;
        // Impulses from 1 to 4 are rounded by at most one epsilon, in each of two passes and here.
        const Real rounding = deep[i] ? 3 * std::numeric_limits<Real>::epsilon() : 0;
        EXPECT_NEAR(line.speed(a), taken - speeds[i], rounding);
        EXPECT_NEAR(line.speed(a + 1), speeds[i] - taken, rounding);
        EXPECT_NEAR(line.impulse(i / kContacts, i % kContacts), 4 - taken, rounding);
    }
    EXPECT_GT(pairs, std::size_t{kContacts}); // more than one block of copies
    EXPECT_LT(pairs, speeds.size());
    EXPECT_EQ(line.relaxation.visits(), 2 * pairs);
}

// Contacts without a colour are solved one by one, in order, and are not copied.
TEST(OverlapRelaxation, KeepsTheOrderOfContactsWithoutAColour) {
    Line line;
    const std::uint32_t a = line.addBody(-1);
    const std::uint32_t b = line.addBody(1);
    const std::uint32_t c = line.addBody(2);
    line.add(a, b, kDeep, 5);
    line.add(b, c, kDeep, 5);
    line.colours = {{2, true}};
    line.settle();
    // three passes for two deep contacts: 0 0 2, 0 1 1; 1/2 1/2 1, 1/2 3/4 3/4; then the same again
    EXPECT_EQ(line.speed(a), Real(0.625));
    EXPECT_EQ(line.speed(b), Real(0.6875));
    EXPECT_EQ(line.speed(c), Real(0.6875));
    EXPECT_EQ(line.relaxation.visits(), 3u * 2);
}

// A chain of bodies. The contact between two coloured contacts has no colour.
TEST(OverlapRelaxation, VisitsContactsWithAndWithoutAColourInOrder) {
    const auto speedsOf = [](bool oneByOne) {
        Line line;
        for (const Real speed : {Real(-1), Real(1), Real(2), Real(5)}) {
            line.addBody(speed);
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            line.add(i, i + 1, kDeep, 5);
        }
        line.colours[1].oneByOne = oneByOne;
        line.settle();
        return std::vector<Real>{line.speed(0), line.speed(1), line.speed(2), line.speed(3)};
    };
    EXPECT_EQ(speedsOf(true), speedsOf(false));
}

// Each cluster has its own number of passes, at most ten, even if clusters share a colour. Crowded
// clusters have fewer.
TEST(OverlapRelaxation, RunsAsManyPassesAsEachClusterNeeds) {
    Line line;
    const std::uint32_t a = line.addBody(-1);
    const std::uint32_t b = line.addBody(1);
    const std::uint32_t c = line.addBody(2);
    const std::uint32_t d = line.addBody(-3);
    const std::uint32_t e = line.addBody(3);
    line.add(a, b, kDeep, 5);
    line.fill(1, d, e, kDeep, 5);
    line.add(b, c, kDeep, 5);
    line.settle();
    EXPECT_EQ(line.speed(a), Real(0.625)); // as above
    EXPECT_EQ(line.speed(b), Real(0.6875));
    EXPECT_EQ(line.speed(d), 0);
    EXPECT_EQ(line.relaxation.visits(), 3u * 2 + 2u * 1);

    for (const auto& [crowd, passes] : {std::pair{1, 10u}, {100, 7u}, {600, 2u}}) {
        Line many;
        const std::uint32_t one = many.addBody(-1);
        const std::uint32_t other = many.addBody(1);
        for (int i = 0; i < 12; ++i) {
            many.add(one, other, kDeep, 5);
        }
        many.crowd[other] = static_cast<std::uint16_t>(crowd);
        many.settle();
        EXPECT_EQ(many.relaxation.visits(), 12u * passes);
    }
}

// Contacts of all kinds between independent pairs with deep overlaps have the same bits as after
// two passes over the original blocks.
TEST(OverlapRelaxation, HasTheBitsOfPassesOverTheOriginalBlocks) {
    RandomBlocks some(21);
    RandomBlocks all(21);
    for (RandomBlocks* blocks : {&some, &all}) {
        for (ContactBlock& block : blocks->blocks) {
            std::fill_n(block.points[0].separation, kContacts, kDeep);
        }
        blocks->motion.emplace_back(); // the spare one
    }
    const std::vector<std::uint16_t> crowd(some.motion.size() - 1, 1);
    const std::vector<PassOrder::Colour> colours{{kBlocks, false}};
    OverlapRelaxation relaxation;
    relaxation.find({some.pass(), colours, kDeepBelow, crowd});
    relaxation.run(some.pass());
    const std::vector<BodyVelocity> before = all.motion;
    ContactPasses::best().relaxNormal(all.pass());
    ContactPasses::best().relaxNormal(all.pass());
    EXPECT_TRUE(sameBits(some.motion, all.motion));
    EXPECT_TRUE(sameBits(some.blocks, all.blocks));
    EXPECT_TRUE(sameBits(some.rolling, all.rolling));
    EXPECT_FALSE(sameBits(some.motion, before));
    EXPECT_EQ(relaxation.visits(), 2u * kBlocks * kContacts);
}

} // namespace
} // namespace kodo
