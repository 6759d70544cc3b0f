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
    std::vector<ContactSummary> summaries;
    ContactBlocks blocks;

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
                add(contact, {});
                lane(contacts.size() - 1).impulse(0) = static_cast<Real>(contacts.size() - 1);
            }
        }
    }

    void add(const Contact& contact, const ContactNumbers& numbers) {
        contacts.push_back(contact);
        summaries.emplace_back().describe(contact, {});
        blocks.resize(contacts.size());
        blocks.waiting(static_cast<std::uint32_t>(contacts.size() - 1)) = numbers;
    }
    ContactList all() { return {contacts, summaries}; }
    ContactLane lane(std::size_t i) {
        return blocks.lane(static_cast<std::uint32_t>(i), summaries[i]);
    }
    ContactNumbers numbers(std::size_t i) { return lane(i).numbers(); }
    /// Leaves the contacts with which(index); their lanes are freed in the next step.
    template <typename Which>
    void keepIf(Which which) {
        std::vector<Contact> kept;
        std::vector<ContactSummary> keptSummaries;
        std::vector<ContactNumbers> keptNumbers;
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            if (which(i)) {
                kept.push_back(contacts[i]);
                keptSummaries.push_back(summaries[i]);
                keptNumbers.push_back(numbers(i));
            }
        }
        contacts = kept;
        summaries = keptSummaries;
        blocks.resize(contacts.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            if (!summaries[i].inPasses()) {
                blocks.waiting(static_cast<std::uint32_t>(i)) = keptNumbers[i];
            }
        }
    }

    ContactPassArguments arrange() {
        std::vector<std::uint32_t> newcomers;
        WorkerTeam serial;
        blocks.advance(bodies, serial); // as a step does first
        blocks.begin(all(), true, true);
        for (std::uint32_t i = 0; i < contacts.size(); ++i) {
            if (!blocks.take(bodies, all()[i])) {
                newcomers.push_back(i);
            }
        }
        blocks.arrange(bodies, all(), newcomers, {}, 3);
        return blocks.pass(bodies, 0, {});
    }
};

/// Checks that no body moves twice within a block or a colour, except one that all lanes of the
/// block share. Checks that the lane masks mark exactly the dynamic bodies.
void expectNoBodyTwice(const Crowd& crowd, const ContactPassArguments& pass) {
    std::size_t i = 0;
    for (const PassOrder::Colour& colour : crowd.blocks.passOrder().colours(0)) {
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
            const auto expectSide = [&](const auto& bodies, unsigned moves) {
                for (std::size_t lane = 0; lane < ContactBlock::kContacts; ++lane) {
                    expectNew(bodyOfPlace(bodies[lane]), (moves >> lane & 1) != 0);
                }
            };
            expectSide(block.a, use.movesA);
            expectSide(block.b, use.movesB);
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
        expectNoBodyTwice(crowd, crowd.arrange());
        EXPECT_EQ(crowd.blocks.size(), crowd.contacts.size());
    }
}

// If most lanes are empty, the lanes are assigned again, so that passes do not visit empty lanes.
TEST(ContactBlocks, AreRebuiltWhenMostLanesAreEmpty) {
    Crowd crowd(23, 5000, 9000);
    crowd.arrange();
    crowd.keepIf([](std::size_t i) { return i % 10 == 0; });
    const std::size_t sparse = crowd.arrange().count;
    const ContactPassArguments pass = crowd.arrange(); // rebuilds
    const std::vector<Contact>& few = crowd.contacts;
    expectNoBodyTwice(crowd, pass);
    EXPECT_EQ(crowd.blocks.size(), few.size());
    for (std::size_t i = 0; i < few.size(); ++i) {
        EXPECT_EQ(crowd.numbers(i).impulse[0].normal > 0, i > 0) << i; // they keep their numbers
    }
    // 900 contacts in blocks of eight, and one partly filled block per colour.
    EXPECT_LT(pass.count, few.size() / 3);
    EXPECT_LT(pass.count, sparse / 2);
}

// A contact keeps its numbers when it gets a lane in the passes, and when it leaves them.
TEST(ContactBlocks, LanesMoveTheNumbersOfAContact) {
    Crowd crowd(5, 200, 700);
    for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
        crowd.lane(i) = {.separation = {1, 2},
                         .approachSpeed = 3,
                         .relativeDisplacement = 4,
                         .impulse = {PointImpulse{static_cast<Real>(i), 5, 6}, {7, 8, 9}},
                         .friction = 10,
                         .total = {11, 12},
                         .sliding = i % 2 == 0};
        crowd.contacts[i].material = {.staticFriction = 1, .kineticFriction = 1};
    }
    crowd.arrange();
    const auto expectSame = [&](std::size_t i) {
        SCOPED_TRACE(i);
        const ContactNumbers numbers = crowd.numbers(i);
        EXPECT_EQ(numbers.separation[0], 1);
        EXPECT_EQ(numbers.approachSpeed, 3);
        EXPECT_EQ(numbers.relativeDisplacement, 4);
        EXPECT_EQ(numbers.impulse[0].normal, static_cast<Real>(i));
        EXPECT_EQ(numbers.impulse[0].impact, 5);
        EXPECT_EQ(numbers.impulse[1].normal, crowd.contacts[i].manifold.count == 2 ? 7 : 0);
        EXPECT_EQ(numbers.friction, 10);
        EXPECT_EQ(numbers.total, (std::array<Real, 2>{11, 12}));
        EXPECT_EQ(numbers.sliding, i % 2 == 0);
    };
    for (std::uint32_t i = 0; i < crowd.contacts.size(); ++i) {
        EXPECT_TRUE(crowd.summaries[i].inPasses());
        expectSame(i);
        crowd.blocks.leave(crowd.all()[i]);
        EXPECT_FALSE(crowd.summaries[i].inPasses());
        expectSame(i);
    }
}

// Contacts in the passes, updated eight at a time, have the same bits as contacts updated one by
// one.
TEST(ContactBlocks, AdvanceContactsWithTheBitsOfSingleUpdates) {
    const Tolerances tolerances = Tolerances::forUnit(1);
    std::size_t outdated = 0;
    for (const std::uint64_t seed : {3u, 14u, 15u}) {
        SCOPED_TRACE(seed);
        support::RandomNumbers random(seed);
        Crowd crowd(seed, 300, 900);
        for (std::size_t at = 0; at < crowd.contacts.size(); ++at) {
            Contact& contact = crowd.contacts[at];
            for (ManifoldPoint& p : contact.manifold.points) {
                p.separation = random.between(-0.01, 0.01);
                p.armA = random.below(4) == 0 ? random.between(0.1, 0.5) * contact.manifold.normal
                                              : random.point(0.5);
                p.armB = random.below(4) == 0 ? random.between(-0.5, -0.1) * contact.manifold.normal
                                              : random.point(0.5);
            }
            crowd.lane(at).setSeparations(contact.manifold);
            crowd.lane(at).relativeDisplacement() = random.between(0, 3) * tolerances.slop;
            contact.bounces = random.below(2) == 0;
        }
        crowd.arrange();
        std::vector<ContactNumbers> before;
        for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
            before.push_back(crowd.numbers(i));
        }
        for (std::size_t i = 1; i < crowd.bodies.size(); i += 1 + random.below(2)) { // some still
            BodyVelocity& motion = crowd.bodies.motion[i];
            motion.velocity = random.point(1);
            motion.angularVelocity = random.between(-2, 2);
            motion.deltaPosition = random.point(0.002);
            motion.deltaAngle = random.between(-0.002, 0.002);
        }
        WorkerTeam serial;
        crowd.blocks.advance(crowd.bodies, serial);
        for (std::size_t k = 0; k < crowd.contacts.size(); ++k) {
            Contact alone = crowd.contacts[k];
            ContactBlock block{};
            const ContactLane lane(block);
            lane = before[k];
            const bool stays =
                followContact(alone, lane, crowd.bodies, tolerances, Real(1) / 60, false);
            Contact together = crowd.contacts[k];
            ASSERT_EQ(followContact(together, crowd.lane(k), crowd.bodies, tolerances, Real(1) / 60,
                                    true),
                      stays);
            ASSERT_EQ(crowd.lane(k).relativeDisplacement(), lane.relativeDisplacement());
            outdated += stays ? 0 : 1;
            for (int i = 0; stays && i < alone.manifold.count; ++i) {
                const auto at = static_cast<std::size_t>(i);
                ASSERT_EQ(crowd.lane(k).separation(at), lane.separation(at));
                ASSERT_EQ(crowd.lane(k).approachSpeed(), lane.approachSpeed());
                ASSERT_FALSE(std::signbit(lane.approachSpeed())); // no negative zero
            }
        }
    }
    EXPECT_GT(outdated, 100u);
    EXPECT_LT(outdated, 2000u);
}

// A contact in the passes touches if one of its points is close enough or has an impulse.
TEST(ContactBlocks, ReportTouchingContacts) {
    constexpr Real kSlop = Real(0.004);
    Crowd crowd(7, 200, 600);
    for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
        Manifold& manifold = crowd.contacts[i].manifold;
        manifold.points[0].separation = i % 3 == 0 ? kSlop : 2 * kSlop;
        manifold.points[1].separation =
            i % 3 == 1 ? -kSlop : 2 * kSlop; // with two points; unused with one
        crowd.lane(i).setSeparations(manifold);
    }
    crowd.arrange();
    for (std::size_t i = 0; i < crowd.contacts.size(); i += 5) {
        crowd.lane(i).largest(0) = 1;
    }
    WorkerTeam alone;
    crowd.blocks.findTouching(kSlop, alone);
    for (std::size_t i = 0; i < crowd.contacts.size(); ++i) {
        const bool near = i % 3 == 0 || (i % 3 == 1 && crowd.contacts[i].manifold.count == 2);
        EXPECT_EQ(crowd.blocks.touched()[crowd.summaries[i].row.index] != 0, near || i % 5 == 0)
            << i;
    }
}

// Contacts with locked bodies come last, so that they dominate.
TEST(ContactBlocks, ContactsWithLockedBodiesComeLast) {
    Crowd crowd(11, 100, 400);
    const ContactPassArguments pass = crowd.arrange();
    bool locked = false;
    for (std::size_t i = 0; i < pass.count; ++i) {
        EXPECT_GE(pass.use[pass.order[i]].onLocked, locked);
        locked = pass.use[pass.order[i]].onLocked;
    }
    EXPECT_TRUE(locked);
}

// Contacts are added and removed, bodies are locked and unlocked, lanes are rebuilt. The blocks
// stay consistent, and contacts that stay keep their colour.
TEST(ContactBlocks, StayConsistentAsContactsComeAndGo) {
    Crowd all(17, 120, 900);
    support::RandomNumbers random(18);
    Crowd some = all;
    for (int step = 0; step < 200; ++step) {
        SCOPED_TRACE(step);
        const std::uint64_t chance = step % 50 < 40 ? 10 : 1; // of ten; sometimes few remain
        some.keepIf([&](std::size_t) { return random.below(10) < chance || chance != 1; });
        for (int i = 0; i < 20; ++i) {
            Contact contact = all.contacts[random.below(all.contacts.size())];
            contact.manifold.count = 1 + static_cast<int>(random.below(2));
            some.add(contact, {});
        }
        const auto body = static_cast<std::uint32_t>(random.below(some.bodies.size()));
        some.bodies.filter[body].flags ^= kTypeKinematic;
        refreshDerived(some.bodies, body);
        std::vector<std::uint8_t> colours;
        for (std::size_t i = 0; i < some.contacts.size(); ++i) {
            Contact& contact = some.contacts[i];
            const bool same = contact.key.bodyA != body && contact.key.bodyB != body;
            contact.filled = contact.filled && same;
            colours.push_back(contact.filled ? some.summaries[i].row.colour
                                             : ContactRow::kNoColour);
        }
        expectNoBodyTwice(some, some.arrange());
        EXPECT_EQ(some.blocks.size(), some.contacts.size());
        for (std::size_t i = 0; i < some.contacts.size(); ++i) {
            if (colours[i] != ContactRow::kNoColour) {
                EXPECT_EQ(some.summaries[i].row.colour, colours[i]);
            }
        }
    }
}

} // namespace
} // namespace kodo
