// SPDX-License-Identifier: MIT
#include <kodo/solve/contact_blocks.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

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
        blocks.clear(bodies);
        for (std::uint32_t i = 0; i < contacts.size(); ++i) {
            blocks.add(bodies, contacts[i], i);
        }
        blocks.arrange(bodies, contacts, std::vector<std::uint16_t>(bodies.size()), 3, true);
        return blocks.pass(bodies, {});
    }
};

void expectNoBodyTwice(const Crowd& crowd, const ContactPassArguments& pass) {
    for (std::size_t i = 0; i < pass.count; ++i) {
        std::set<std::uint32_t> pushed;
        for (std::size_t lane = 0; lane < ContactBlock::kContacts; ++lane) {
            for (const std::uint32_t body : {pass.blocks[i].a[lane], pass.blocks[i].b[lane]}) {
                if (body != crowd.bodies.spare() && !crowd.bodies.locked(body)) {
                    EXPECT_TRUE(pushed.insert(body).second) << "block " << i;
                }
            }
        }
    }
}

// Lanes of a block are solved at once, so no two of them may push the same body: with few contacts,
// with many, and with so many on one body that the colours run out.
TEST(ContactBlocks, NoTwoContactsOfABlockPushTheSameBody) {
    for (const auto& [count, pairs] : {std::pair{30u, 40u}, {300u, 900u}, {20u, 2000u}}) {
        SCOPED_TRACE(pairs);
        Crowd crowd(count + pairs, count, pairs);
        ContactBlocks blocks;
        expectNoBodyTwice(crowd, crowd.arrange(blocks));
        EXPECT_EQ(blocks.size(), crowd.contacts.size());
    }
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
    blocks.store(after);
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(after[i].impulse[0].normal, static_cast<Real>(i));
    }
}

// Contacts with what cannot be pushed come last, so that they have the last word.
TEST(ContactBlocks, WhatIsLockedComesLast) {
    Crowd crowd(11, 100, 400);
    ContactBlocks blocks;
    const ContactPassArguments pass = crowd.arrange(blocks);
    bool locked = false;
    for (std::size_t i = 0; i < pass.count; ++i) {
        EXPECT_GE(pass.use[i].onLocked, locked);
        locked = pass.use[i].onLocked;
    }
    EXPECT_TRUE(locked);
}

} // namespace
} // namespace kodo
