// SPDX-License-Identifier: MIT
#include <kodo/bodies/integrate.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/solve/contact_blocks.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace kodo {
namespace {

/// Discs that touch in a lattice, more than Disorder::kMany contacts, numbered without regard to
/// where they are.
class Lattice {
public:
    explicit Lattice(std::uint64_t seed) {
        support::RandomNumbers random(seed);
        const BodyDef def{.shape = Circle{Real(0.5)}};
        const std::shared_ptr<const Form> form = makeForm(partsOf(def));
        std::vector<Vec2> places;
        for (int i = 0; i < kSide * kSide; ++i) {
            places.push_back({static_cast<Real>(i % kSide), static_cast<Real>(i / kSide)});
        }
        for (std::size_t i = places.size(); i > 1; --i) {
            std::swap(places[i - 1], places[random.below(i)]);
        }
        for (const Vec2 place : places) {
            bodies.pose[addBody(bodies, def, form).index].position = place;
        }
        refreshAwake(bodies);
        noteStart(bodies);
        step();
    }

    /// With lanes for all that respond, which are lent from step to step.
    void step() {
        set.updatePairs(bodies, Tolerances::forUnit(1), Real(1) / 60, crew);
        blocks.carry(bodies, crew);
        set.updateManifolds(
            bodies, Tolerances::forUnit(1),
            {blocks.carried(), [&](Contact& contact) { blocks.reclaim(contact, bodies); }}, crew);
        take();
    }
    void take() {
        std::vector<std::uint32_t> newcomers;
        blocks.begin(bodies, set.contacts(), true, false);
        for (const std::uint32_t place : set.live()) {
            Contact& contact = set.contacts()[place];
            if (contact.responds() && !blocks.take(bodies, contact)) {
                newcomers.push_back(place);
            }
        }
        blocks.arrange(bodies, set.contacts(), newcomers, {}, 3);
        for (std::uint32_t place = 0; place < set.contacts().size(); ++place) {
            set.noteRow(place);
        }
    }
    /// Takes bodies away and puts them back, so that their contacts come anew.
    void stir(support::RandomNumbers& random, int count) {
        for (int i = 0; i < count; ++i) {
            const auto body = static_cast<std::uint32_t>(random.below(kSide * kSide));
            const Vec2 place = bodies.pose[body].position;
            bodies.pose[body].position = {-100 - 2 * static_cast<Real>(i), 0};
            bodies.noteJump(body);
            set.bodyChanged(body);
            step();
            bodies.pose[body].position = place;
            bodies.noteJump(body);
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
    ContactBlocks blocks;
    Crew crew;
};

// Contacts that come later lie anywhere, until it pays to put all in order.
TEST(ContactOrder, ComesBackByItself) {
    Lattice lattice(21);
    support::RandomNumbers random(22);
    const std::size_t count = lattice.set.contacts().size();
    ASSERT_GT(count, Disorder::kMany);
    lattice.stir(random, 40);
    EXPECT_FALSE(lattice.isInOrder());
    EXPECT_EQ(lattice.set.contacts().size(), count);
    const std::uint64_t soon = Disorder::kSteps * count; // one stray alone would do by then
    for (std::uint64_t step = 0; step < soon && !lattice.isInOrder(); ++step) {
        lattice.step();
    }
    EXPECT_TRUE(lattice.isInOrder());
    // all is as it was, in another place, also what is lent
    std::size_t i = 0;
    const ContactSet& set = lattice.set;
    const ContactPassArguments pass = lattice.blocks.pass(lattice.bodies, {});
    lattice.set.forEachInOrder([&](const Contact& contact) {
        EXPECT_EQ(&contact, &set.contacts()[i]);
        const ContactHead& head = set.heads()[i++];
        EXPECT_EQ(head.bodyA, contact.key.bodyA);
        EXPECT_EQ(head.bodyB, contact.key.bodyB);
        EXPECT_EQ(head.meets, contact.manifold.count > 0);
        EXPECT_EQ(head.row, contact.row.index);
        EXPECT_EQ(contact.row.lent, contact.manifold.count > 0);
        if (contact.row.lent) {
            const ContactBlock& block = pass.blocks[contact.row.index / 8];
            EXPECT_EQ(block.a[contact.row.index % 8], placeOfMotion(contact.key.bodyA));
            EXPECT_EQ(block.b[contact.row.index % 8], placeOfMotion(contact.key.bodyB));
        }
    });
    EXPECT_EQ(i, count);
}

// A pass then reads them as they lie, and comes to bodies in their order, colour by colour.
TEST(ContactOrder, OfLanesDealtAnewIsThatOfThePass) {
    for (const std::uint32_t shares : {1u, 3u, 16u}) {
        SCOPED_TRACE(shares);
        Lattice lattice(23);
        ContactBlocks& blocks = lattice.blocks;
        const std::size_t rows = blocks.size();
        ASSERT_GT(rows, Disorder::kMany);
        std::vector<std::uint8_t> colours;
        for (const Contact& contact : lattice.set.contacts()) {
            colours.push_back(contact.row.colour);
        }
        blocks.dealAnew(lattice.bodies, lattice.set, shares);
        lattice.take();
        EXPECT_EQ(blocks.size(), rows);
        EXPECT_EQ(blocks.shares(), shares);
        for (std::size_t i = 0; i < colours.size(); ++i) {
            EXPECT_EQ(lattice.set.contacts()[i].row.colour, colours[i]);
        }
        // of each share and colour all blocks but the last are full; none is empty
        const ContactPassArguments pass = blocks.pass(lattice.bodies, {});
        EXPECT_EQ(pass.count, blocks.blockCount());
        std::size_t partial = 0;
        for (std::size_t k = 0; k < pass.count; ++k) {
            EXPECT_TRUE(shares > 1 || pass.order[k] == k) << k;
            const ContactBlock& block = pass.blocks[k];
            const auto lanes = static_cast<std::size_t>(
                std::find(block.a, block.a + 8, placeOfMotion(lattice.bodies.spare())) - block.a);
            EXPECT_GT(lanes, 0u);
            EXPECT_TRUE(std::is_sorted(block.a, block.a + lanes)) << k;
            partial += lanes < 8 ? 1 : 0;
            EXPECT_TRUE(k == 0 || blocks.shareOf(k - 1) <= blocks.shareOf(k)) << k;
        }
        EXPECT_LE(partial, shares * blocks.colours().size());
    }
}

// Contacts that keep their lanes do not stray, also where lanes have to be filled again.
TEST(ContactOrder, OfLanesIsNotMadeAgainWhileNothingComes) {
    Lattice lattice(24);
    lattice.blocks.dealAnew(lattice.bodies, lattice.set, 1);
    for (std::uint64_t step = 0; step < 10 * Disorder::kSteps; ++step) {
        lattice.blocks.startAnew();
        lattice.step();
        ASSERT_FALSE(lattice.blocks.countDisorder()) << step;
    }
}

} // namespace
} // namespace kodo
