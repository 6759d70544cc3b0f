// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include "bodies/integrate.hpp"
#include "contacts/contact_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "lanes/contact_blocks.hpp"

namespace kodo {
namespace {

/// Discs that touch in a lattice, with more contacts than ReorderPolicy::kMany. Their numbers are
/// independent of their positions.
class Lattice {
public:
    explicit Lattice(std::uint64_t seed) {
        support::RandomNumbers random(seed);
        const BodyDef def{.shape = Circle{Real(0.5)}};
        const std::shared_ptr<const BodyGeometry> geometry = makeGeometry(partsOf(def));
        std::vector<Vec2> places;
        for (int i = 0; i < kSide * kSide; ++i) {
            places.push_back({static_cast<Real>(i % kSide), static_cast<Real>(i / kSide)});
        }
        for (std::size_t i = places.size(); i > 1; --i) {
            std::swap(places[i - 1], places[random.below(i)]);
        }
        for (const Vec2 place : places) {
            bodies.pose[addBody(bodies, def, geometry).index].position = place;
        }
        set.bodiesChanged();
        refreshAwake(bodies);
        noteStart(bodies);
        step();
    }

    /// Contacts that respond stay in the passes from step to step.
    void step() {
        set.updatePairs(bodies, {}, Tolerances::forUnit(1), Real(1) / 60, team);
        set.updateManifolds(bodies, Tolerances::forUnit(1), Real(1) / 60, team);
        take();
    }
    void take() {
        std::vector<std::uint32_t> newcomers;
        blocks().begin(set.store().all(), true, false);
        for (const std::uint32_t place : set.live()) {
            if (set.contacts()[place].responds() &&
                !blocks().take(bodies, set.store().entry(place))) {
                newcomers.push_back(place);
            }
        }
        blocks().arrange(bodies, set.store().all(), newcomers, {}, 3);
    }
    void rebuildLanes(std::uint32_t partitions) {
        blocks().rebuildGraph(bodies, set.store().all(), set.store().slotsInOrder(), partitions);
    }
    ContactBlocks& blocks() { return set.lanes(); }
    /// Removes bodies and puts them back, so that their contacts are new.
    void stir(support::RandomNumbers& random, int count) {
        for (int i = 0; i < count; ++i) {
            const auto body = static_cast<std::uint32_t>(random.below(kSide * kSide));
            const Vec2 place = bodies.pose[body].position;
            bodies.pose[body].position = {-100 - 2 * static_cast<Real>(i), 0};
            bodies.noteTeleport(body);
            set.bodyChanged(body);
            step();
            bodies.pose[body].position = place;
            bodies.noteTeleport(body);
            set.bodyChanged(body);
            step();
        }
    }
    bool isInOrder() const {
        return std::is_sorted(set.contacts().begin(), set.contacts().end(),
                              [](const Contact& a, const Contact& b) { return a.key < b.key; });
    }

    static constexpr int kSide = 40;
    Bodies bodies;
    ContactSet set;
    WorkerTeam team;
};

// New contacts are out of order until a reorder pays.
TEST(ContactOrder, IsRestoredAfterManyChanges) {
    Lattice lattice(21);
    support::RandomNumbers random(22);
    const std::size_t count = lattice.set.contacts().size();
    ASSERT_GT(count, ReorderPolicy::kMany);
    lattice.stir(random, 40);
    EXPECT_FALSE(lattice.isInOrder());
    EXPECT_EQ(lattice.set.contacts().size(), count);
    const std::uint64_t soon = ReorderPolicy::kSteps * count; // enough for a single stray contact
    for (std::uint64_t step = 0; step < soon && !lattice.isInOrder(); ++step) {
        lattice.step();
    }
    EXPECT_TRUE(lattice.isInOrder());
    // all contacts are unchanged at their new places, and have their lanes
    std::size_t i = 0;
    const ContactSet& set = lattice.set;
    const ContactPassArguments pass = lattice.blocks().pass(lattice.bodies, 0, {});
    lattice.set.store().forEachInOrder([&](std::uint32_t slot) {
        const Contact& contact = set.contacts()[slot];
        EXPECT_EQ(slot, i);
        const ContactSummary& summary = set.summaries()[i++];
        EXPECT_EQ(summary.bodyA, contact.key.bodyA);
        EXPECT_EQ(summary.bodyB, contact.key.bodyB);
        EXPECT_EQ(summary.mayTouch, contact.manifold.count > 0);
        EXPECT_EQ(summary.inPasses(), contact.manifold.count > 0);
        if (summary.inPasses()) {
            const ContactBlock& block = pass.blocks[summary.row.index / 8];
            EXPECT_EQ(block.a[summary.row.index % 8], velocityOffset(contact.key.bodyA));
            EXPECT_EQ(block.b[summary.row.index % 8], velocityOffset(contact.key.bodyB));
        }
    });
    EXPECT_EQ(i, count);
}

// After a rebuild, a pass reads blocks in the order of memory, and bodies in their order, colour by
// colour.
TEST(ContactOrder, OfRebuiltLanesIsThatOfThePass) {
    for (const std::uint32_t partitions : {1u, 3u, 16u}) {
        SCOPED_TRACE(partitions);
        Lattice lattice(23);
        ContactBlocks& blocks = lattice.blocks();
        const std::size_t rows = blocks.size();
        ASSERT_GT(rows, ReorderPolicy::kMany);
        std::vector<std::uint8_t> colours;
        for (const ContactSummary& summary : lattice.set.summaries()) {
            colours.push_back(summary.row.colour);
        }
        lattice.rebuildLanes(partitions);
        lattice.take();
        EXPECT_EQ(blocks.size(), rows);
        EXPECT_EQ(blocks.partitions().count(), partitions);
        for (std::size_t i = 0; i < colours.size(); ++i) {
            EXPECT_EQ(lattice.set.summaries()[i].row.colour, colours[i]);
        }
        // in each partition and colour all blocks but the last are full; none is empty
        const ContactPassArguments pass = blocks.pass(lattice.bodies, 0, {});
        EXPECT_EQ(pass.count, blocks.blockCount());
        std::size_t partial = 0;
        for (std::size_t k = 0; k < pass.count; ++k) {
            EXPECT_TRUE(partitions > 1 || pass.order[k] == k) << k;
            const ContactBlock& block = pass.blocks[k];
            const auto lanes = static_cast<std::size_t>(
                std::find(block.a, block.a + 8, velocityOffset(lattice.bodies.spare())) - block.a);
            EXPECT_GT(lanes, 0u);
            EXPECT_TRUE(std::is_sorted(block.a, block.a + lanes)) << k;
            partial += lanes < 8 ? 1 : 0;
            EXPECT_TRUE(k == 0 || blocks.stateOf(k - 1).partition <= blocks.stateOf(k).partition)
                << k;
        }
        EXPECT_LE(partial, partitions * blocks.passOrder().colours(0).size());
    }
}

// Contacts that keep their lanes do not stray, even if the lanes are filled again.
TEST(ContactOrder, OfLanesNeedsNoRebuildWithoutNewContacts) {
    Lattice lattice(24);
    lattice.rebuildLanes(1);
    for (std::uint64_t step = 0; step < 10 * ReorderPolicy::kSteps; ++step) {
        lattice.blocks().discardLanes();
        lattice.step();
        ASSERT_FALSE(lattice.blocks().countReorder()) << step;
    }
}

} // namespace
} // namespace kodo
