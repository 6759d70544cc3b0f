// SPDX-License-Identifier: MIT
#include <kodo/contacts/contact_update.hpp>
#include <kodo/solve/contact_blocks.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace kodo {
namespace {

/// Bodies and contacts between pairs of them at random; body 0 is locked and touches many.
struct Crowd {
    Bodies bodies;
    std::vector<Contact> contacts;

    Crowd(std::uint64_t seed, std::uint32_t count, std::size_t pairs) {
        support::RandomNumbers random(seed);
        BodyDef def;
        const std::shared_ptr<const Form> form = makeForm(partsOf(def));
        for (std::uint32_t i = 0; i < count; ++i) {
            def.flags = i == 0 ? kLocked : Flags{0};
            addBody(bodies, def, form);
        }
        refreshAwake(bodies);
        noteStart(bodies);
        for (std::size_t i = 0; i < pairs; ++i) {
            const auto a = static_cast<std::uint32_t>(random.below(count));
            const auto b = static_cast<std::uint32_t>(random.below(count));
            if (a != b) {
                Contact contact;
                contact.key = {std::min(a, b), 0, std::max(a, b), 0};
                contact.manifold.normal = random.rotation().xAxis();
                contact.manifold.count = 1 + static_cast<int>(random.below(2));
                contact.impulse[0].normal = static_cast<Real>(contacts.size());
                contacts.push_back(contact);
            }
        }
    }

    ContactPassArguments arrange(ContactBlocks& blocks) {
        std::vector<std::uint32_t> newcomers;
        blocks.begin(bodies, contacts, true, true);
        for (std::uint32_t i = 0; i < contacts.size(); ++i) {
            if (!blocks.take(bodies, contacts[i])) {
                newcomers.push_back(i);
            }
        }
        blocks.arrange(bodies, contacts, newcomers, {}, 3);
        return blocks.pass(bodies, {});
    }
};

/// Neither within a block nor within a colour; and what a block writes back to is what it pushes.
void expectNoBodyTwice(const Crowd& crowd, const ContactBlocks& blocks,
                       const ContactPassArguments& pass) {
    std::size_t i = 0;
    for (const ContactBlocks::Colour& colour : blocks.colours()) {
        std::set<std::uint32_t> pushed;
        for (std::size_t k = 0; k < colour.count; ++k, ++i) {
            const ContactBlock& block = pass.blocks[pass.order[i]];
            const BlockUse& use = pass.use[pass.order[i]];
            if (colour.oneByOne) {
                pushed.clear();
            }
            const auto expectNew = [&](std::uint32_t body, bool moves) {
                const bool free = body != crowd.bodies.spare() && !crowd.bodies.locked(body);
                EXPECT_EQ(moves, free) << "block " << i;
                EXPECT_TRUE(!free || pushed.insert(body).second) << "block " << i;
            };
            for (std::size_t lane = 0; lane < ContactBlock::kContacts; ++lane) {
                expectNew(bodyOfPlace(block.a[lane]), (use.movesA >> lane & 1) != 0);
                expectNew(bodyOfPlace(block.b[lane]), (use.movesB >> lane & 1) != 0);
            }
        }
    }
    EXPECT_EQ(i, pass.count);
}

// Lanes of a block are solved at once, and so are, by several threads, the blocks of a colour: no
// two of them may push the same body, with few contacts, with many, and with so many on one body
// that the colours run out.
TEST(ContactBlocks, NoTwoContactsOfAColourPushTheSameBody) {
    for (const auto& [count, pairs] : {std::pair{30u, 40u}, {300u, 900u}, {20u, 2000u}}) {
        SCOPED_TRACE(pairs);
        Crowd crowd(count + pairs, count, pairs);
        ContactBlocks blocks;
        expectNoBodyTwice(crowd, blocks, crowd.arrange(blocks));
        EXPECT_EQ(blocks.size(), crowd.contacts.size());
    }
}

// Lanes that most contacts have left are dealt out anew, so that passes do not go on over nothing.
TEST(ContactBlocks, AreFilledAgainWhenMostLanesAreEmpty) {
    Crowd crowd(23, 5000, 9000);
    ContactBlocks blocks;
    crowd.arrange(blocks);
    std::vector<Contact> few;
    for (std::size_t i = 0; i < crowd.contacts.size(); i += 10) {
        blocks.fetch(crowd.contacts[i], crowd.bodies);
        few.push_back(crowd.contacts[i]);
    }
    crowd.contacts = few;
    const std::size_t sparse = crowd.arrange(blocks).count;
    const ContactPassArguments pass = crowd.arrange(blocks); // now they know
    expectNoBodyTwice(crowd, blocks, pass);
    EXPECT_EQ(blocks.size(), few.size());
    // 900 contacts in lanes of eight, and in each colour a block that is not full.
    EXPECT_LT(pass.count, few.size() / 3);
    EXPECT_LT(pass.count, sparse / 2);
}

// What is handed out comes back to the contact it came from.
TEST(ContactBlocks, GiveEachContactItsOwnImpulseBack) {
    Crowd crowd(5, 200, 700);
    ContactBlocks blocks;
    crowd.arrange(blocks);
    std::vector<Contact> after = crowd.contacts;
    for (Contact& contact : after) {
        contact.impulse = {};
    }
    for (Contact& contact : after) {
        blocks.fetch(contact, crowd.bodies);
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(after[i].impulse[0].normal, static_cast<Real>(i));
    }
}

// Eight at a time in their lanes, or one by one, contacts go on alike, to the bit.
TEST(ContactBlocks, CarryContactsOnAsTheyGoOnByThemselves) {
    const Tolerances tolerances = Tolerances::forUnit(1);
    std::size_t outdated = 0;
    for (const std::uint64_t seed : {3u, 14u, 15u}) {
        SCOPED_TRACE(seed);
        support::RandomNumbers random(seed);
        Crowd crowd(seed, 300, 900);
        for (Contact& contact : crowd.contacts) {
            for (ManifoldPoint& p : contact.manifold.points) {
                p.separation = random.between(-0.01, 0.01);
                p.armA = random.below(4) == 0 ? random.between(0.1, 0.5) * contact.manifold.normal
                                              : random.point(0.5);
                p.armB = random.below(4) == 0 ? random.between(-0.5, -0.1) * contact.manifold.normal
                                              : random.point(0.5);
            }
            contact.drift = random.between(0, 3) * tolerances.slop;
            contact.bounces = random.below(2) == 0;
        }
        ContactBlocks blocks;
        crowd.arrange(blocks);
        for (std::size_t i = 1; i < crowd.bodies.size(); i += 1 + random.below(2)) { // some stand
            Motion& motion = crowd.bodies.motion[i];
            motion.velocity = random.point(1);
            motion.angularVelocity = random.between(-2, 2);
            motion.move = random.point(0.002);
            motion.turn = random.between(-0.002, 0.002);
        }
        Crew nobody;
        blocks.carry(crowd.bodies, nobody);
        for (const Contact& contact : crowd.contacts) {
            Contact alone = contact;
            alone.row.lent = false;
            const bool stays = followContact(alone, crowd.bodies, tolerances, false);
            Contact lent = contact;
            blocks.reclaim(lent, crowd.bodies);
            ASSERT_EQ(followContact(lent, crowd.bodies, tolerances, true), stays);
            ASSERT_EQ(lent.drift, alone.drift);
            outdated += stays ? 0 : 1;
            for (int i = 0; stays && i < contact.manifold.count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                ASSERT_EQ(lent.manifold.points[at].separation,
                          alone.manifold.points[at].separation);
                ASSERT_EQ(lent.approachSpeed, alone.approachSpeed);
                ASSERT_FALSE(std::signbit(lent.approachSpeed)); // 0 has a sign, too
            }
        }
    }
    EXPECT_GT(outdated, 100u);
    EXPECT_LT(outdated, 2000u);
}

// A contact in a lane has touched if one of its points is near enough, or was pushed.
TEST(ContactBlocks, TellWhoTouched) {
    constexpr Real kSlop = Real(0.004);
    Crowd crowd(7, 200, 600);
    for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
        Manifold& manifold = crowd.contacts[i].manifold;
        manifold.points[0].separation = i % 3 == 0 ? kSlop : 2 * kSlop;
        manifold.points[1].separation =
            i % 3 == 1 ? -kSlop : 2 * kSlop; // of two points, or of none
    }
    ContactBlocks blocks;
    const ContactPassArguments pass = crowd.arrange(blocks);
    for (std::size_t i = 0; i < crowd.contacts.size(); i += 5) {
        const std::uint32_t row = crowd.contacts[i].row.index;
        pass.blocks[row / ContactBlock::kContacts]
            .points[0]
            .largest[row % ContactBlock::kContacts] = 1;
    }
    Crew alone;
    blocks.noteTouching(kSlop, alone);
    for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
        const bool near = i % 3 == 0 || (i % 3 == 1 && crowd.contacts[i].manifold.count == 2);
        EXPECT_EQ(blocks.touched()[crowd.contacts[i].row.index] != 0, near || i % 5 == 0) << i;
    }
    EXPECT_EQ(blocks.touched().back(), 0);
    EXPECT_EQ(ContactBlocks().touched().back(), 0);
}

// Contacts with what cannot be pushed come last, so that they have the last word.
TEST(ContactBlocks, WhatIsLockedComesLast) {
    Crowd crowd(11, 100, 400);
    ContactBlocks blocks;
    const ContactPassArguments pass = crowd.arrange(blocks);
    bool locked = false;
    for (std::size_t i = 0; i < pass.count; ++i) {
        EXPECT_GE(pass.use[pass.order[i]].onLocked, locked);
        locked = pass.use[pass.order[i]].onLocked;
    }
    EXPECT_TRUE(locked);
}

// Contacts come and go, bodies get locked and loose, lanes are dealt out anew: the blocks stay
// sound, and what is carried on keeps its colour.
TEST(ContactBlocks, StaySoundAsContactsComeAndGo) {
    Crowd all(17, 120, 900);
    support::RandomNumbers random(18);
    Crowd some = all;
    ContactBlocks blocks;
    for (int step = 0; step < 200; ++step) {
        SCOPED_TRACE(step);
        const std::uint64_t chance = step % 50 < 40 ? 10 : 1; // of ten; few are left at times
        std::erase_if(some.contacts,
                      [&](const Contact&) { return random.below(10) >= chance && chance == 1; });
        for (int i = 0; i < 20; ++i) {
            Contact contact = all.contacts[random.below(all.contacts.size())];
            contact.manifold.count = 1 + static_cast<int>(random.below(2));
            some.contacts.push_back(contact);
        }
        const auto body = static_cast<std::uint32_t>(random.below(some.bodies.size()));
        some.bodies.filter[body].flags ^= kLocked;
        refreshBuild(some.bodies, body);
        std::vector<std::uint8_t> colours;
        for (Contact& contact : some.contacts) {
            const bool same = contact.key.bodyA != body && contact.key.bodyB != body;
            contact.carried = contact.carried && same;
            colours.push_back(contact.carried ? contact.row.colour : ContactRow::kNoColour);
        }
        expectNoBodyTwice(some, blocks, some.arrange(blocks));
        EXPECT_EQ(blocks.size(), some.contacts.size());
        for (std::size_t i = 0; i < some.contacts.size(); ++i) {
            if (colours[i] != ContactRow::kNoColour) {
                EXPECT_EQ(some.contacts[i].row.colour, colours[i]);
            }
        }
        for (Contact& contact : some.contacts) {
            blocks.fetch(contact, some.bodies);
        }
    }
}

} // namespace
} // namespace kodo
