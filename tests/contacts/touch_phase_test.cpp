// SPDX-License-Identifier: MIT
#include "contacts/contact_report.hpp"

#include <gtest/gtest.h>

namespace kodo {
namespace {

constexpr Tolerances kTolerances = Tolerances::forUnit(1);

/// Two points with this separation and without impulses.
StoredContact contactOf(Real separation) {
    StoredContact contact;
    contact.a = {3, 1};
    contact.b = {5, 1};
    contact.centerA = {10, 20};
    contact.near = true;
    contact.manifold.normal = {0, 1};
    contact.manifold.count = 2;
    contact.manifold.points[0].armA = {-1, 0};
    contact.manifold.points[1].armA = {1, 0};
    contact.manifold.points[0].separation = separation;
    contact.manifold.points[1].separation = separation;
    contact.numbers.separation = {separation, separation};
    return contact;
}

std::vector<CollisionRecord> recordsOf(StoredContact contact) {
    std::vector<CollisionRecord> records;
    ContactBlock block{};
    const ContactLane lane(block);
    lane = contact.numbers;
    finishContact(contact, touches(contact, lane, kTolerances));
    recordContact(contact, records);
    return records;
}

TEST(TouchPhase, AGapOfTheMarginIsNoTouch) {
    EXPECT_TRUE(recordsOf(contactOf(kTolerances.margin)).empty());
}

TEST(TouchPhase, AGapBelowTheSlopIsATouch) {
    const auto records = recordsOf(contactOf(kTolerances.slop / 2));
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].phase, TouchPhase::Begin);
    EXPECT_EQ(records[0].pointCount, 2);
    EXPECT_EQ(records[0].maxImpulse, 0);
    EXPECT_EQ(records[0].point, (Vec2{9, 20})); // the deepest
}

// An impulse across a gap, by the speculative margin of the solver, is also a touch.
TEST(TouchPhase, AnImpulseIsATouchAtAnyGap) {
    StoredContact contact = contactOf(kTolerances.margin);
    contact.numbers.impulse[1].largest = 2;
    contact.numbers.total[0] = 2;
    const auto records = recordsOf(contact);
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].maxImpulse, 2);
    EXPECT_EQ(records[0].point, (Vec2{11, 20})); // where the impulse acted
}

TEST(TouchPhase, ATouchAfterATouchPersists) {
    StoredContact contact = contactOf(0);
    contact.wasTouching = true;
    EXPECT_EQ(recordsOf(contact).at(0).phase, TouchPhase::Persist);
}

TEST(TouchPhase, AGapAfterATouchEnds) {
    StoredContact contact = contactOf(kTolerances.margin);
    contact.wasTouching = true;
    const auto records = recordsOf(contact);
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].phase, TouchPhase::End);
    EXPECT_EQ(records[0].pointCount, 0);
    EXPECT_EQ(records[0].totalImpulse, 0);
}

// F2: refined substeps store an upper bound of their largest impulse; the total is exact.
TEST(TouchPhase, TheLargestImpulseIsAtMostTheTotal) {
    StoredContact contact = contactOf(0);
    contact.numbers.impulse[0].largest = 8;
    contact.numbers.total[0] = 4;
    const auto records = recordsOf(contact);
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].maxImpulse, 4);
    EXPECT_EQ(records[0].maxPointImpulse(), 4);
}

// F2: the gap of a pair is that of its deepest point.
TEST(TouchPhase, TheSeparationIsThatOfTheDeepestPoint) {
    StoredContact contact = contactOf(0);
    contact.manifold.points[1].separation = Real(-0.125);
    const auto records = recordsOf(contact);
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].separation, Real(-0.125));
    EXPECT_EQ(records[0].point, (Vec2{11, 20}));
}

// S2: the impact impulse counts as one of the groups, and in the total.
TEST(TouchPhase, TheImpactCountsAmongTheImpulseGroups) {
    StoredContact contact = contactOf(0);
    contact.numbers.impulse[0] = {1, 5, 2}; // a substep, the impact, the largest substep
    contact.numbers.impulse[1] = {1, 0, 3};
    contact.numbers.total[0] = 4;
    const auto records = recordsOf(contact);
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].maxImpulse, 5);
    EXPECT_EQ(records[0].totalImpulse, 9);
}

} // namespace
} // namespace kodo
