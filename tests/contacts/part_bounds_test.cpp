// SPDX-License-Identifier: MIT
#include "contacts/part_bounds.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace kodo {
namespace {

constexpr Real kDt = Real(1) / 64;
constexpr Tolerances kDistances = Tolerances::forUnit(1);
constexpr std::size_t kManyContacts = 10000; // to be compared in a step

/// Two discs; the second is motionless. All numbers are multiples of 2^-8, so nothing is rounded.
struct Discs {
    Bodies bodies;
    PartBounds bounds;
    WorkerTeam team{nullptr};

    Discs() {
        for (const Real x : {Real(0), Real(100)}) {
            const BodyDef def{.shape = Circle{Real(0.5)}, .position = {x, 0}};
            addBody(bodies, def, makeGeometry(partsOf(def)));
        }
        refreshAwake(bodies);
        bounds.renew(bodies, kDistances);
        bounds.clearChanged();
    }
    /// True if the bounds of the first disc have changed. Those of the second never do.
    bool renewed() {
        const std::vector<std::uint32_t> changed(bounds.changed().begin(), bounds.changed().end());
        bounds.clearChanged();
        EXPECT_TRUE(changed.empty() || changed == std::vector<std::uint32_t>{0});
        return !changed.empty();
    }
    /// True if the bounds contain the first disc and its margin after this displacement.
    bool hold(Vec2 move) const {
        return bounds.grown()[0].contains(bounds.tight(0).moved(move).grown(kDistances.margin));
    }
};

// R10: a body that moves 1/64 m per step gets bounds for two such steps and a slack of 1/16 m
// ahead, and needs one step. So they last for six steps, without a search for pairs.
TEST(PartBounds, AreRenewedOnlyWhenOutgrown) {
    Discs discs;
    discs.bodies.motion[0].velocity = {1, 0};
    for (int step = 0; step < 60; ++step) {
        discs.bounds.coverPrediction(discs.bodies, kDistances, kDt, discs.team);
        EXPECT_EQ(discs.renewed(), step % 6 == 0) << step;
        EXPECT_TRUE(discs.hold({kDt, 0})) << step;
        discs.bodies.pose[0].position.x += kDt;
    }
}

// F2: bounds that one fast step has stretched over 600 m shrink in the next slow one. The body was
// a candidate for contacts on all of that way before.
TEST(PartBounds, ShrinkAfterAFastStep) {
    Discs discs;
    for (const Vec2 fast : {Vec2{20000, 0}, Vec2{-20000, 20000}}) {
        discs.bodies.motion[0].velocity = fast;
        discs.bounds.coverPrediction(discs.bodies, kDistances, kDt, discs.team);
        EXPECT_TRUE(discs.renewed());
        discs.bodies.motion[0].velocity = {};
        discs.bounds.coverPrediction(discs.bodies, kDistances, kDt, discs.team);
        EXPECT_TRUE(discs.renewed());
        EXPECT_LT(discs.bounds.grown()[0].box().extent().x, 2);
        discs.bounds.coverPrediction(discs.bodies, kDistances, kDt, discs.team);
        EXPECT_FALSE(discs.renewed());
    }
}

// F2: a displacement out of a far longer prediction drops it.
TEST(PartBounds, DropAFarLongerPredictionOutsideIt) {
    Discs discs;
    discs.bodies.motion[0].velocity = {20000, 0};
    discs.bounds.coverPrediction(discs.bodies, kDistances, kDt, discs.team);
    EXPECT_TRUE(discs.renewed());
    discs.bodies.motion[0].deltaPosition = {0, 5};
    discs.bounds.coverDisplacements(discs.bodies, kDistances, discs.team);
    EXPECT_TRUE(discs.renewed());
    EXPECT_TRUE(discs.hold({0, 5}));
    EXPECT_LT(discs.bounds.grown()[0].box().extent().x, 2);
}

// F2: whatever its speed, a rod of 2 m that spins reaches no farther than 1 m from its middle, so a
// point of it moves by 2 m at most. Its bounds were as long as the arcs of its ends before, so it
// was a candidate for contacts with everything within kilometres.
TEST(PartBounds, OfASpinDoNotExceedTheDisc) {
    for (const Real spin : {Real(100), Real(1e4), Real(9e6)}) {
        Bodies bodies;
        PartBounds bounds;
        WorkerTeam team{nullptr};
        const BodyDef def{.shape = Box{2, Real(0.25)}, .angularVelocity = spin};
        addBody(bodies, def, makeGeometry(partsOf(def)));
        refreshAwake(bodies);
        bounds.renew(bodies, kDistances);
        bounds.coverPrediction(bodies, kDistances, kDt, team);
        const Real longest = 2 + 4 + 2 * (kDistances.margin + kDistances.grown);
        EXPECT_LE(bounds.grown()[0].box().extent().x, longest + Real(0.1)) << spin << " rad/s";
        bodies.motion[0].deltaAngle = spin * kDt;
        bounds.coverDisplacements(bodies, kDistances, team);
        EXPECT_LE(bounds.grown()[0].box().extent().x, longest + Real(0.1)) << spin << " rad/s";
    }
}

// A disc that spins about its middle stays within its bounds. A body with a rotation reach needs
// new ones.
TEST(PartBounds, AreNotOutgrownByTheSpinOfADisc) {
    Discs discs;
    discs.bodies.motion[0].angularVelocity = 100;
    discs.bodies.motion[0].deltaAngle = 1;
    for (const Real rotationReach : {Real(0), Real(0.5)}) {
        EXPECT_TRUE(rotationReach > 0 || discs.bodies.extent[0].rotationReach == 0);
        discs.bodies.extent[0].rotationReach = rotationReach;
        discs.bounds.coverPrediction(discs.bodies, kDistances, kDt, discs.team);
        EXPECT_EQ(discs.renewed(), rotationReach > 0);
        discs.bounds.coverDisplacements(discs.bodies, kDistances, discs.team);
        EXPECT_FALSE(discs.renewed()); // the disc itself has not moved
    }
}

// R10: a displacement beyond the bounds renews them; one within the bounds does not.
TEST(PartBounds, CoverDisplacementsOfTheSolver) {
    Discs discs;
    discs.bounds.coverPrediction(discs.bodies, kDistances, kDt, discs.team);
    for (const Real way : {kDistances.margin, Real(2)}) {
        discs.bodies.motion[0].deltaPosition = {0, way};
        discs.bounds.coverDisplacements(discs.bodies, kDistances, discs.team);
        EXPECT_EQ(discs.renewed(), way == 2);
        EXPECT_EQ(discs.hold({0, way}), way == 2); // the margin itself may be used up
    }
}

// The indices of parts stay when other bodies are removed, and return to the next body of the slot.
// A body that needs more parts gets a range at the end, and unused indices are dropped once they
// are many.
TEST(PartBounds, KeepIndicesOfPartsWhileOtherBodiesComeAndGo) {
    constexpr std::uint32_t kBodies = 200;
    Bodies bodies;
    PartBounds bounds;
    const auto add = [&](Shape shape) {
        const BodyDef def{.shape = std::move(shape)};
        return addBody(bodies, def, makeGeometry(partsOf(def))).index;
    };
    for (std::uint32_t i = 0; i < kBodies; ++i) {
        add(Circle{1});
    }
    bounds.renew(bodies, kDistances);
    removeBody(bodies, 3);
    bounds.renew(bodies, kDistances, 3);
    EXPECT_FALSE(bounds.renumberIfDue(0));
    EXPECT_TRUE(bounds.hasUnused());
    EXPECT_EQ(bounds.indexOf(4, 0), 4u);
    EXPECT_EQ(bounds.usedCount(), kBodies - 1);
    ASSERT_EQ(add(Circle{1}), 3u);
    bounds.renew(bodies, kDistances, 3);
    EXPECT_FALSE(bounds.renumberIfDue(0));
    EXPECT_FALSE(bounds.hasUnused());

    removeBody(bodies, 3);
    ASSERT_EQ(add(Compound{{Circle{1}, Circle{1}}}), 3u);
    bounds.renew(bodies, kDistances, 3);
    EXPECT_FALSE(bounds.renumberIfDue(0));
    EXPECT_EQ(bounds.moves(), 2u);
    EXPECT_EQ(bounds.indexOf(3, 0), kBodies);
    EXPECT_EQ(bounds.indexOf(4, 0), 4u);
    EXPECT_FALSE(bounds.isUsed(3));
    EXPECT_FALSE(bounds.isInOrder());
    EXPECT_TRUE(bounds.isBefore({kBodies, 5}, {4, 5})); // body 3 before body 4
    EXPECT_FALSE(bounds.isBefore({2, kBodies + 1}, {2, kBodies}));
    EXPECT_TRUE(bounds.renumberIfDue(kManyContacts));
    EXPECT_TRUE(bounds.isInOrder());
    EXPECT_EQ(bounds.indexOf(4, 0), 5u);
    EXPECT_EQ(bounds.indexNow(4, 4), 5u);
    EXPECT_EQ(bounds.part(4).part, 1u);

    for (std::uint32_t body = 10; body < kBodies; ++body) {
        removeBody(bodies, body);
        bounds.renew(bodies, kDistances, body);
    }
    EXPECT_TRUE(bounds.renumberIfDue(0));
    EXPECT_EQ(bounds.size(), 11u); // ten bodies, one of them with two parts
    EXPECT_EQ(bounds.indexOf(9, 0), 10u);
}

// Regression: new indices for the parts of a small World visited the slots of all bodies that it
// once had.
TEST(PartBounds, NewIndicesVisitWhatLives) {
    constexpr std::uint32_t kGone = 10000;
    Bodies bodies;
    PartBounds bounds;
    const BodyDef def{.shape = Circle{1}};
    const auto add = [&] { return addBody(bodies, def, makeGeometry(partsOf(def))).index; };
    for (std::uint32_t i = 0; i < kGone + 4; ++i) {
        add();
    }
    bounds.renew(bodies, kDistances);
    for (std::uint32_t i = 2; i < kGone + 2; ++i) {
        removeBody(bodies, i);
        bounds.renew(bodies, kDistances, i);
    }
    EXPECT_TRUE(bounds.renumberIfDue(0));
    std::vector<std::uint32_t> listed;
    bounds.listBodies(listed);
    EXPECT_EQ(listed, (std::vector<std::uint32_t>{0, 1, kGone + 2, kGone + 3}));
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint64_t before = bounds.moves();
        const std::uint32_t added = add();
        bounds.renew(bodies, kDistances, added);
        EXPECT_FALSE(bounds.isInOrder());
        EXPECT_TRUE(bounds.renumberIfDue(kManyContacts));
        EXPECT_LT(bounds.moves() - before, 20u);
        EXPECT_EQ(bounds.indexOf(kGone + 3, 0), 4u + i);
        EXPECT_EQ(bounds.indexNow(3 + i, kGone + 3), 4u + i);
    }
}

} // namespace
} // namespace kodo
