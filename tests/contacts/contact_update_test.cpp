// SPDX-License-Identifier: MIT
#include <support/near.hpp>

#include "contacts/contact_update.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace kodo {
namespace {

constexpr Tolerances kScale = Tolerances::forUnit(1);
constexpr Real kRounding = support::byPrecision(1e-6, 1e-14);
// rad; the golden angle is given to nine digits, and angles of up to 77 rad are rounded.
constexpr Real kAngle = support::byPrecision(2e-5, 2e-8);

/// A box on another one, and their contact.
class Boxes {
public:
    explicit Boxes(Real width = 1, Real height = 1) {
        const BodyDef def{.shape = Box{width, height}};
        const auto geometry = makeGeometry(partsOf(def));
        addBody(bodies_, def, geometry);
        addBody(bodies_, def, geometry);
        place({0, height}, 0);
        contact.key = {0, 0, 1, 0};
        findContact(contact, lane, bodies_, kScale, Real(1) / 60);
        contact.filled = true;
    }

    /// Moves the upper box and finds the contact there.
    void findAt(Vec2 position, Real turn) {
        place(position, turn);
        findContact(contact, lane, bodies_, kScale, Real(1) / 60);
    }
    /// A step with this displacement of the upper box. True if the manifold is kept.
    bool keepsAfter(Vec2 move, Real turn = 0) {
        BodyVelocity& motion = bodies_.motion[1];
        motion.deltaPosition = move;
        motion.deltaAngle = turn;
        angle_ += turn;
        place(bodies_.pose[1].position + move, angle_);
        return followContact(contact, lane, bodies_, kScale, Real(1) / 60, false);
    }

    Contact contact;

private:
    ContactBlock block_{};

public:
    const ContactLane lane{block_};

private:
    void place(Vec2 position, Real turn) {
        angle_ = turn;
        bodies_.pose[1] = {position, Rot::fromAngle(turn)};
    }

    Bodies bodies_;
    Real angle_ = 0;
};

// For translation and for rotation.
TEST(ContactUpdate, FindsTheManifoldAgainAfterADisplacementOfEightSlops) {
    Boxes slides;
    int steps = 0;
    while (slides.keepsAfter({kScale.slop, 0})) {
        ASSERT_LT(++steps, 10);
    }
    EXPECT_GE(steps, 7);

    Boxes turns;
    const Real rotationReach = std::sqrt(Real(0.5)); // m, to a corner
    steps = 0;
    while (turns.keepsAfter({}, kScale.slop / rotationReach)) {
        ASSERT_LT(++steps, 10);
    }
    EXPECT_GE(steps, 7);
}

// When two faces lie on each other, either may be the reference face, and either point may be the
// deeper one.
TEST(ContactUpdate, ImpulsesKeepTheirPlacesWhenTheReferenceFaceChanges) {
    for (const Real width : {Real(1), Real(0.2), Real(0.05), Real(0.03)}) {
        SCOPED_TRACE(width);
        constexpr Real kTurn = Real(0.004); // rad
        Boxes boxes(width);
        boxes.findAt({0, Real(0.998)}, kTurn);
        ASSERT_EQ(boxes.contact.manifold.count, 2);
        for (std::size_t i = 0; i < 2; ++i) {
            ManifoldPoint& point = boxes.contact.manifold.points[i];
            boxes.lane.impulse(i) = point.armA.x < 0 ? 3 : 4;
            point.feature ^= 0xffff; // as if of the other reference face
        }
        boxes.findAt({0, Real(0.998)}, -kTurn);
        ASSERT_EQ(boxes.contact.manifold.count, 2);
        for (std::size_t i = 0; i < 2; ++i) {
            const bool left = boxes.contact.manifold.points[i].armA.x < 0;
            EXPECT_EQ(boxes.lane.impulse(i), left ? 3 : 4);
        }
    }
}

// A box that rocks from one corner to the other starts there without impulse, at any size.
TEST(ContactUpdate, ImpulsesDoNotMoveToTheOtherCorner) {
    for (const Real size : {Real(1), Real(0.1), Real(0.05)}) {
        SCOPED_TRACE(size);
        constexpr Real kTurn = Real(0.1);        // rad
        const Real height = Real(1.0475) * size; // m, of a box that nearly stands on a corner
        Boxes boxes(size, size);
        boxes.findAt({0, height}, kTurn);
        ASSERT_GE(boxes.contact.manifold.count, 1);
        const bool right = boxes.contact.manifold.points[0].armA.x > 0;
        boxes.lane.impulse(0) = 3;
        boxes.lane.impulse(1) = 0;
        boxes.findAt({0, height}, -kTurn);
        ASSERT_GE(boxes.contact.manifold.count, 1);
        EXPECT_NE(boxes.contact.manifold.points[0].armA.x > 0, right);
        EXPECT_EQ(boxes.lane.impulse(0), 0);
    }
}

// One point is matched by its feature, the other by its place. If one point becomes two, the nearer
// one takes over the impulse.
TEST(ContactUpdate, ImpulsesAreMatchedByFeatureAndThenByPlace) {
    Boxes boxes;
    boxes.findAt({0, Real(0.998)}, 0);
    ASSERT_EQ(boxes.contact.manifold.count, 2);
    const Manifold before = boxes.contact.manifold;
    boxes.lane.impulse(0) = 3;
    boxes.lane.impulse(1) = 4;
    boxes.contact.manifold.points[0].feature ^= 0xffff;
    boxes.findAt({0, Real(0.998)}, 0);
    EXPECT_EQ(boxes.lane.impulse(0), 3);
    EXPECT_EQ(boxes.lane.impulse(1), 4);

    boxes.contact.manifold = before;
    boxes.contact.manifold.points[0] = before.points[1];
    boxes.contact.manifold.points[0].feature ^= 0xffff;
    boxes.contact.manifold.count = 1;
    boxes.lane.impulse(0) = 5;
    boxes.findAt({0, Real(0.998)}, 0);
    EXPECT_EQ(boxes.lane.impulse(0), 0);
    EXPECT_EQ(boxes.lane.impulse(1), 5);
}

// Both old points are in range: the nearer one is matched.
TEST(ContactUpdate, ImpulsesAreMatchedToTheNearestPlace) {
    Boxes boxes;
    boxes.findAt({0, Real(0.998)}, 0);
    ASSERT_EQ(boxes.contact.manifold.count, 2);
    for (std::size_t i = 0; i < 2; ++i) {
        ManifoldPoint& point = boxes.contact.manifold.points[i];
        point = boxes.contact.manifold.points[0];
        point.feature = static_cast<std::uint32_t>(0xffff0 + i);
        boxes.lane.impulse(i) = static_cast<Real>(3 + i);
    }
    boxes.contact.manifold.points[0].armA.x += 4 * kScale.slop;
    boxes.contact.manifold.points[0].armB.x += 4 * kScale.slop;
    boxes.findAt({0, Real(0.998)}, 0);
    EXPECT_EQ(boxes.lane.impulse(0), 4);
    EXPECT_EQ(boxes.lane.impulse(1), 0);
}

// When a box passes a corner, the normal turns by 90 degrees. Old impulses are then invalid.
TEST(ContactUpdate, ImpulsesAreDroppedWhenTheNormalTurns) {
    Boxes boxes;
    boxes.findAt({Real(0.98), Real(0.99)}, 0);
    ASSERT_EQ(boxes.contact.manifold.count, 2);
    ASSERT_NEAR(boxes.contact.manifold.normal.y, 1, 1e-3);
    boxes.lane.impulse(0) = 3;
    boxes.lane.impulse(1) = 4;
    for (ManifoldPoint& point : boxes.contact.manifold.points) {
        point.feature ^= 0xffff;
    }
    boxes.findAt({Real(0.99), Real(0.98)}, 0);
    ASSERT_NEAR(boxes.contact.manifold.normal.x, 1, 1e-3);
    EXPECT_EQ(boxes.lane.impulse(0), 0);
    EXPECT_EQ(boxes.lane.impulse(1), 0);
}

// In a deep overlap, other features may mean that the shortest separation now has another
// direction. Impulses are then matched by feature only.
TEST(ContactUpdate, ImpulsesOfADeepOverlapAreMatchedByFeatureOnly) {
    Boxes boxes;
    boxes.findAt({0, Real(0.9)}, 0);
    ASSERT_EQ(boxes.contact.manifold.count, 2);
    for (std::size_t i = 0; i < 2; ++i) {
        boxes.lane.impulse(i) = 3;
    }
    boxes.contact.manifold.points[0].feature ^= 0xffff;
    const std::uint32_t known = boxes.contact.manifold.points[1].feature;
    boxes.findAt({0, Real(0.9)}, 0);
    ASSERT_EQ(boxes.contact.manifold.count, 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const bool isKnown = boxes.contact.manifold.points[i].feature == known;
        EXPECT_EQ(boxes.lane.impulse(i), isKnown ? 3 : 0);
    }
}

/// Normals of the contacts between a static disc and `count` smaller ones with the same centre.
std::vector<Vec2> concentricNormals(int count) {
    Bodies bodies;
    const auto add = [&](Real radius, BodyType type) {
        const BodyDef def{.shape = Circle{radius}, .type = type};
        addBody(bodies, def, makeGeometry(partsOf(def)));
    };
    add(Real(0.5), BodyType::Static);
    std::vector<Vec2> normals;
    for (int i = 1; i <= count; ++i) {
        add(Real(0.25), BodyType::Dynamic);
        bodies.record.back().crowdRank = static_cast<std::uint32_t>(i);
        Contact contact;
        ContactBlock block{};
        contact.key = {0, 0, static_cast<std::uint32_t>(i), 0};
        findContact(contact, ContactLane(block), bodies, kScale, Real(1) / 60);
        EXPECT_EQ(contact.manifold.count, 1);
        const ManifoldPoint& point = contact.manifold.points[0];
        normals.push_back(contact.manifold.normal);
        // Midway between the two outlines: 0.5 - 0.75 / 2.
        EXPECT_TRUE(support::near(point.armA, Real(0.125) * normals.back(), kRounding));
        EXPECT_TRUE(support::near(point.armB, Real(0.125) * normals.back(), kRounding));
    }
    return normals;
}

// Each disc has its own direction. Multiples of the golden angle fill a circle evenly: by the
// three-gap theorem, neighbours among 32 are at least phi^-8 and at most phi^-6 turns apart.
TEST(ContactUpdate, ConcentricDiscsSeparateInAllDirections) {
    std::vector<double> angles;
    for (const Vec2 normal : concentricNormals(32)) {
        EXPECT_TRUE(support::near(length(normal), 1, kRounding));
        angles.push_back(std::atan2(static_cast<double>(normal.y), static_cast<double>(normal.x)));
    }
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + 2 * std::numbers::pi);
    double least = 2 * std::numbers::pi;
    double most = 0;
    for (std::size_t i = 1; i < angles.size(); ++i) {
        least = std::min(least, angles[i] - angles[i - 1]);
        most = std::max(most, angles[i] - angles[i - 1]);
    }
    EXPECT_TRUE(
        support::near(least, 2 * std::numbers::pi * std::pow(std::numbers::phi, -8), kAngle));
    EXPECT_TRUE(
        support::near(most, 2 * std::numbers::pi * std::pow(std::numbers::phi, -6), kAngle));
}

} // namespace
} // namespace kodo
