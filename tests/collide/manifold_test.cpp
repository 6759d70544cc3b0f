// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/near.hpp>
#include <support/random_shapes.hpp>

#include <set>

namespace kodo::manifold_test {
namespace {

using support::byPrecision;
using support::near;

constexpr Real kTolerance = byPrecision(2e-6, 1e-14);

Manifold meet(const Primitive& a, const Transform& poseA, const Primitive& b,
              const Transform& poseB, Real margin = 0) {
    return collide(convexShapeOf(a, {}), poseA, convexShapeOf(b, {}), poseB, margin, 0);
}

Transform at(Real x, Real y, Real angle = 0) {
    return {{x, y}, Rot::fromAngle(angle)};
}

TEST(Manifold, OfTwoBallsLiesBetweenTheirCentres) {
    const Manifold manifold = meet(Circle{1}, at(0, 0), Circle{2}, at(0, Real(2.5)));
    ASSERT_EQ(manifold.count, 1);
    EXPECT_EQ(manifold.normal, (Vec2{0, 1}));
    EXPECT_EQ(manifold.points[0].separation, Real(-0.5));
    EXPECT_EQ(manifold.points[0].armA, (Vec2{0, Real(0.75)}));
    EXPECT_EQ(manifold.points[0].armB, (Vec2{0, Real(-1.75)}));
}

// C1, nested: concentric circles define no direction, but the contact needs one.
TEST(Manifold, OfConcentricBallsHasANormal) {
    const Manifold manifold = meet(Circle{1}, at(3, 3), Circle{2}, at(3, 3));
    ASSERT_EQ(manifold.count, 1);
    EXPECT_EQ(length(manifold.normal), 1);
    EXPECT_EQ(manifold.points[0].separation, -3);
}

TEST(Manifold, OfABallOnABoxIsTheNearestPoint) {
    const Manifold manifold = meet(Box{4, 2}, at(0, 0), Circle{1}, at(Real(0.5), Real(1.75)));
    ASSERT_EQ(manifold.count, 1);
    EXPECT_EQ(manifold.normal, (Vec2{0, 1}));
    EXPECT_TRUE(near(manifold.points[0].separation, -0.25L, kTolerance));
    EXPECT_TRUE(near(manifold.points[0].armA, Vec2{Real(0.5), Real(0.875)}, kTolerance));
}

// C2: beyond the end of a side the corner decides, by Pythagoras (3, 4, 5).
TEST(Manifold, OfABallAtACornerPointsFromTheCornerToTheCentre) {
    const Manifold manifold = meet(Box{2, 2}, at(0, 0), Circle{6}, at(4, 5));
    ASSERT_EQ(manifold.count, 1);
    EXPECT_TRUE(near(manifold.normal, Vec2{Real(0.6), Real(0.8)}, kTolerance));
    EXPECT_TRUE(near(manifold.points[0].separation, -1, kTolerance));
}

TEST(Manifold, OfABallWithItsCentreInsidePointsThroughTheNearestSide) {
    const Manifold manifold =
        meet(Box{4, 4}, at(0, 0), Circle{Real(0.5)}, at(Real(1.75), Real(0.5)));
    ASSERT_EQ(manifold.count, 1);
    EXPECT_EQ(manifold.normal, (Vec2{1, 0}));
    EXPECT_TRUE(near(manifold.points[0].separation, -0.75L, kTolerance));
}

// C4: a box lying flat on another has two points, at the ends of the shorter side.
TEST(Manifold, OfABoxLyingFlatHasTwoPoints) {
    const Manifold manifold = meet(Box{10, 1}, at(0, 0), Box{2, 1}, at(1, Real(0.75)));
    ASSERT_EQ(manifold.count, 2);
    EXPECT_EQ(manifold.normal, (Vec2{0, 1}));
    std::set<Real> places;
    for (const ManifoldPoint& point : manifold.points) {
        EXPECT_TRUE(near(point.separation, -0.25L, kTolerance));
        EXPECT_TRUE(near(point.armA.y, 0.375L, kTolerance));
        places.insert(point.armA.x);
    }
    EXPECT_EQ(places, (std::set<Real>{0, 2}));
}

TEST(Manifold, OfAnOverhangingBoxIsClippedAtTheEdge) {
    const Manifold manifold = meet(Box{4, 1}, at(0, 0), Box{2, 1}, at(2, Real(0.75)));
    ASSERT_EQ(manifold.count, 2);
    const Real left = std::min(manifold.points[0].armA.x, manifold.points[1].armA.x);
    const Real right = std::max(manifold.points[0].armA.x, manifold.points[1].armA.x);
    EXPECT_TRUE(near(left, 1, kTolerance));
    EXPECT_TRUE(near(right, 2, kTolerance));
}

// C4: the deepest point comes first.
TEST(Manifold, OfATiltedBoxHasItsDeepestPointFirst) {
    const Manifold manifold =
        meet(Box{10, 1}, at(0, 0), Box{2, 2}, at(0, Real(1.4)) * at(0, 0, Real(0.05)));
    ASSERT_EQ(manifold.count, 2);
    EXPECT_LT(manifold.points[0].separation, manifold.points[1].separation);
    EXPECT_LT(manifold.points[0].armA.x, 0); // rotated counter-clockwise: the left corner is lower
}

// C4, thesis Fig 3.5: one corner is inside. The other end of its edge is above the face, so it is
// no second point.
TEST(Manifold, OfABoxStandingOnACornerHasOnePoint) {
    const Manifold manifold = meet(Box{10, 1}, at(0, 0), Box{2, 2}, at(0, Real(1.9), Real(0.7)));
    ASSERT_EQ(manifold.count, 1);
    EXPECT_EQ(manifold.normal, (Vec2{0, 1}));
    EXPECT_LT(manifold.points[0].separation, 0);
}

// C4: where only a corner lies over a face, or faces continue each other, there is one point, not
// the same point twice.
TEST(Manifold, OfBoxesThatMeetAtACornerHasOnePoint) {
    const Box box{1, 1};
    for (const Vec2 place : {Vec2{Real(1.002), Real(1.003)}, Vec2{Real(1.005), 1},
                             Vec2{Real(-1.005), 1}, Vec2{-1, Real(-1.005)}}) {
        for (const Real angle : {Real(0), Real(0.3), Real(2)}) {
            SCOPED_TRACE(testing::Message() << place.x << ", " << place.y << " at " << angle);
            const Transform turn = at(3, -2, angle);
            const Manifold manifold =
                meet(box, turn, box, turn * at(place.x, place.y), Real(1) / 64);
            ASSERT_EQ(manifold.count, 1);
            EXPECT_LE(manifold.points[0].separation, Real(0.005) + kTolerance);
        }
    }
}

// A gap of exactly the margin still has a contact.
TEST(Manifold, AppearsOnlyWithinTheMargin) {
    const Box box{2, 2};
    EXPECT_EQ(meet(box, at(0, 0), box, at(0, Real(2.25)), Real(0.25)).count, 2);
    EXPECT_EQ(meet(box, at(0, 0), box, at(0, Real(2.2500002)), Real(0.125)).count, 0);
    EXPECT_EQ(meet(Circle{1}, at(0, 0), Circle{1}, at(0, Real(2.25)), Real(0.25)).count, 1);
    EXPECT_EQ(meet(Circle{1}, at(0, 0), Circle{1}, at(0, Real(2.5)), Real(0.25)).count, 0);
}

// C4: without contact only a lower bound of the distance is set, if known. Between the nearest
// corner of the box and the shape it is less than 70 m.
TEST(Manifold, IsEmptyWithoutAHit) {
    for (const support::Kind kind : support::kAllKinds) {
        support::RandomNumbers random(91);
        const Primitive shape = support::randomPrimitive(random, kind);
        const Manifold manifold = meet(shape, at(0, 0), Box{1, 1}, at(50, 50));
        EXPECT_EQ(manifold.count, 0);
        EXPECT_EQ(manifold.normal, Vec2{});
        EXPECT_EQ(manifold.points[0].armA, Vec2{});
        EXPECT_GE(manifold.points[0].separation, 0);
        EXPECT_LT(manifold.points[0].separation, 70);
    }
}

// Features identify points from one step to the next. Two points never share a feature, and a small
// displacement changes none.
TEST(Manifold, FeaturesIdentifyPointsAcrossSteps) {
    const Box ground{10, 1};
    const Box box{2, 1};
    const Manifold before = meet(ground, at(0, 0), box, at(1, Real(0.9)));
    const Manifold after = meet(ground, at(0, 0), box, at(Real(1.1), Real(0.91)));
    ASSERT_EQ(before.count, 2);
    ASSERT_EQ(after.count, 2);
    EXPECT_NE(before.points[0].feature, before.points[1].feature);
    std::set<std::uint32_t> first{before.points[0].feature, before.points[1].feature};
    std::set<std::uint32_t> second{after.points[0].feature, after.points[1].feature};
    EXPECT_EQ(first, second);
}

// A face of A stays the reference while that of B is not clearly better. So a resting box does not
// change its reference face with each rounding.
TEST(Manifold, PrefersTheFaceOfTheFirstShape) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const Transform a{};
    const Transform b = at(0, Real(1.95), Real(0.01)); // B's lower face is deeper by 0.01 or so
    const Manifold without = collide(box, a, box, b, Real(0.1), 0);
    const Manifold with = collide(box, a, box, b, Real(0.1), Real(0.1));
    EXPECT_EQ(with.normal, (Vec2{0, 1}));
    EXPECT_EQ(with.points[0].feature >> 31, 0u);
    EXPECT_GE(without.points[0].separation + kTolerance, with.points[0].separation);
}

} // namespace
} // namespace kodo::manifold_test
