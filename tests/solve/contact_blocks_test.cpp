// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include "contacts/contact_update.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "lanes/contact_blocks.hpp"

namespace kodo {
namespace {

/// Bodies, and contacts between random pairs of them. Body 0 is locked and has many contacts.
struct Crowd {
    Bodies bodies;
    std::vector<Contact> contacts;

    Crowd(std::uint64_t seed, std::uint32_t count, std::size_t pairs) {
        support::RandomNumbers random(seed);
        BodyDef def;
        const std::shared_ptr<const BodyGeometry> geometry = makeGeometry(partsOf(def));
        for (std::uint32_t i = 0; i < count; ++i) {
            def.type = i == 0 ? BodyType::Kinematic : BodyType::Dynamic;
            addBody(bodies, def, geometry);
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
        WorkerTeam serial;
        blocks.carry(bodies, serial); // as a step does first
        blocks.begin(bodies, contacts, true, true);
        for (std::uint32_t i = 0; i < contacts.size(); ++i) {
            if (!blocks.take(bodies, contacts[i])) {
                newcomers.push_back(i);
            }
        }
        blocks.arrange(bodies, contacts, newcomers, {}, 3);
        return blocks.pass(bodies, 0, {});
    }
};

/// Checks that no body moves twice within a block or a colour, except one that all lanes of the
/// block share. Checks that the lane masks mark exactly the dynamic bodies.
void expectNoBodyTwice(const Crowd& crowd, const ContactBlocks& blocks,
                       const ContactPassArguments& pass) {
    std::size_t i = 0;
    for (const PassOrder::Colour& colour : blocks.passOrder().colours(0)) {
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
            const auto expectSide = [&](const auto& bodies, unsigned moves, bool shared) {
                if (shared) {
                    expectNew(bodyOfPlace(bodies[0]), moves != 0);
                    EXPECT_EQ(std::count(std::begin(bodies), std::end(bodies), bodies[0]), 8);
                    EXPECT_TRUE(colour.oneByOne);
                    return;
                }
                for (std::size_t lane = 0; lane < ContactBlock::kContacts; ++lane) {
                    expectNew(bodyOfPlace(bodies[lane]), (moves >> lane & 1) != 0);
                }
            };
            expectSide(block.a, use.movesA, use.shared == Shared::BodyA);
            expectSide(block.b, use.movesB, use.shared == Shared::BodyB);
        }
    }
    EXPECT_EQ(i, pass.count);
}

// The lanes of a block are solved at once, and several threads solve the blocks of a colour at
// once. So no two of them may move the same body. Cases: few contacts, many, and so many per body
// that the colours run out.
TEST(ContactBlocks, NoTwoContactsOfAColourMoveTheSameBody) {
    for (const auto& [count, pairs] : {std::pair{30u, 40u}, {300u, 900u}, {20u, 2000u}}) {
        SCOPED_TRACE(pairs);
        Crowd crowd(count + pairs, count, pairs);
        ContactBlocks blocks;
        expectNoBodyTwice(crowd, blocks, crowd.arrange(blocks));
        EXPECT_EQ(blocks.size(), crowd.contacts.size());
    }
}

// If most lanes are empty, the lanes are assigned again, so that passes do not visit empty lanes.
TEST(ContactBlocks, AreRebuiltWhenMostLanesAreEmpty) {
    Crowd crowd(23, 5000, 9000);
    ContactBlocks blocks;
    crowd.arrange(blocks);
    std::vector<Contact> few;
    for (std::size_t i = 0; i < crowd.contacts.size(); i += 10) {
        blocks.writeBack(crowd.contacts[i], crowd.bodies);
        few.push_back(crowd.contacts[i]);
    }
    crowd.contacts = few;
    const std::size_t sparse = crowd.arrange(blocks).count;
    const ContactPassArguments pass = crowd.arrange(blocks); // rebuilds
    expectNoBodyTwice(crowd, blocks, pass);
    EXPECT_EQ(blocks.size(), few.size());
    // 900 contacts in blocks of eight, and one partly filled block per colour.
    EXPECT_LT(pass.count, few.size() / 3);
    EXPECT_LT(pass.count, sparse / 2);
}

// Impulses return to the contact they came from.
TEST(ContactBlocks, WriteEachImpulseBackToItsContact) {
    Crowd crowd(5, 200, 700);
    ContactBlocks blocks;
    crowd.arrange(blocks);
    std::vector<Contact> after = crowd.contacts;
    for (Contact& contact : after) {
        contact.impulse = {};
    }
    for (Contact& contact : after) {
        blocks.writeBack(contact, crowd.bodies);
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_EQ(after[i].impulse[0].normal, static_cast<Real>(i));
    }
}

// Resident contacts, updated eight at a time, have the same bits as contacts updated one by one.
TEST(ContactBlocks, CarryContactsWithTheBitsOfSingleUpdates) {
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
            contact.relativeDisplacement = random.between(0, 3) * tolerances.slop;
            contact.bounces = random.below(2) == 0;
        }
        ContactBlocks blocks;
        crowd.arrange(blocks);
        for (std::size_t i = 1; i < crowd.bodies.size(); i += 1 + random.below(2)) { // some still
            BodyVelocity& motion = crowd.bodies.motion[i];
            motion.velocity = random.point(1);
            motion.angularVelocity = random.between(-2, 2);
            motion.deltaPosition = random.point(0.002);
            motion.deltaAngle = random.between(-0.002, 0.002);
        }
        WorkerTeam serial;
        blocks.carry(crowd.bodies, serial);
        for (const Contact& contact : crowd.contacts) {
            Contact alone = contact;
            alone.row.resident = false;
            const bool stays = followContact(alone, crowd.bodies, tolerances, false);
            Contact resident = contact;
            blocks.evict(resident, crowd.bodies);
            ASSERT_EQ(followContact(resident, crowd.bodies, tolerances, true), stays);
            ASSERT_EQ(resident.relativeDisplacement, alone.relativeDisplacement);
            outdated += stays ? 0 : 1;
            for (int i = 0; stays && i < contact.manifold.count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                ASSERT_EQ(resident.manifold.points[at].separation,
                          alone.manifold.points[at].separation);
                ASSERT_EQ(resident.approachSpeed, alone.approachSpeed);
                ASSERT_FALSE(std::signbit(resident.approachSpeed)); // no negative zero
            }
        }
    }
    EXPECT_GT(outdated, 100u);
    EXPECT_LT(outdated, 2000u);
}

// A resident contact touches if one of its points is close enough or has an impulse.
TEST(ContactBlocks, ReportTouchingContacts) {
    constexpr Real kSlop = Real(0.004);
    Crowd crowd(7, 200, 600);
    for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
        Manifold& manifold = crowd.contacts[i].manifold;
        manifold.points[0].separation = i % 3 == 0 ? kSlop : 2 * kSlop;
        manifold.points[1].separation =
            i % 3 == 1 ? -kSlop : 2 * kSlop; // with two points; unused with one
    }
    ContactBlocks blocks;
    const ContactPassArguments pass = crowd.arrange(blocks);
    for (std::size_t i = 0; i < crowd.contacts.size(); i += 5) {
        const std::uint32_t row = crowd.contacts[i].row.index;
        pass.blocks[row / ContactBlock::kContacts]
            .points[0]
            .largest[row % ContactBlock::kContacts] = 1;
    }
    WorkerTeam alone;
    blocks.noteTouching(kSlop, alone);
    for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
        const bool near = i % 3 == 0 || (i % 3 == 1 && crowd.contacts[i].manifold.count == 2);
        EXPECT_EQ(blocks.touched()[crowd.contacts[i].row.index] != 0, near || i % 5 == 0) << i;
    }
    EXPECT_EQ(blocks.touched().back(), 0);
    EXPECT_EQ(ContactBlocks().touched().back(), 0);
}

// Contacts with locked bodies come last, so that they dominate.
TEST(ContactBlocks, ContactsWithLockedBodiesComeLast) {
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

// Contacts are added and removed, bodies are locked and unlocked, lanes are rebuilt. The blocks
// stay consistent, and carried contacts keep their colour.
TEST(ContactBlocks, StayConsistentAsContactsComeAndGo) {
    Crowd all(17, 120, 900);
    support::RandomNumbers random(18);
    Crowd some = all;
    ContactBlocks blocks;
    for (int step = 0; step < 200; ++step) {
        SCOPED_TRACE(step);
        const std::uint64_t chance = step % 50 < 40 ? 10 : 1; // of ten; sometimes few remain
        std::erase_if(some.contacts,
                      [&](const Contact&) { return random.below(10) >= chance && chance == 1; });
        for (int i = 0; i < 20; ++i) {
            Contact contact = all.contacts[random.below(all.contacts.size())];
            contact.manifold.count = 1 + static_cast<int>(random.below(2));
            some.contacts.push_back(contact);
        }
        const auto body = static_cast<std::uint32_t>(random.below(some.bodies.size()));
        some.bodies.filter[body].flags ^= kTypeKinematic;
        refreshDerived(some.bodies, body);
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
            blocks.writeBack(contact, some.bodies);
        }
    }
}

} // namespace
} // namespace kodo
