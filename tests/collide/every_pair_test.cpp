// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include <tuple>

namespace kodo::every_pair_test {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::near;

// Distances of up to 8 m, some twenty roundings.
constexpr Real kTolerance = byPrecision(5e-6, 1e-14);
constexpr Real kMargin = Real(0.25);
const int kPoses = support::poses();

struct Pair {
    ConvexShape shapeA;
    ConvexShape shapeB;
    Transform a;
    Transform b;

    long double expected() const { return support::signedDistance(shapeA, a, shapeB, b); }
    Manifold manifold(Real margin) const { return collide(shapeA, a, shapeB, b, margin, 0); }
    bool hasRound() const { return shapeA.isRound() || shapeB.isRound(); }
    bool hasPlane() const { return shapeA.isPlane() || shapeB.isPlane(); }
};

// C1: every pair of {point, circle, box, polygon, segment, plane}, in both orders. A compound is
// several of them.
class EveryPair : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {
protected:
    Pair next() {
        Pair pair;
        pair.shapeA = convexShapeOf(support::randomPrimitive(random_, std::get<0>(GetParam())), {});
        pair.shapeB = convexShapeOf(support::randomPrimitive(random_, std::get<1>(GetParam())), {});
        pair.a = random_.pose(4);
        pair.b = {pair.a.position + random_.point(2.5), random_.rotation()};
        return pair;
    }
    bool bothPlanes() const {
        return std::get<0>(GetParam()) == AnyKind::Plane &&
               std::get<1>(GetParam()) == AnyKind::Plane;
    }
    support::RandomNumbers random_{91};
};

TEST_P(EveryPair, TouchesExactlyWhenTheMinkowskiDifferenceContainsTheOrigin) {
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        const Pair p = next();
        const long double expected = p.expected();
        if (std::abs(expected) > static_cast<long double>(kTolerance)) {
            ASSERT_EQ(p.manifold(0).count > 0, expected < 0) << "pose " << i << ": " << expected;
        }
    }
}

// In overlap the separation is the depth. Otherwise it is at most the distance, and equal to it
// with a circle, a point or a plane.
TEST_P(EveryPair, SeparationIsTheDistanceOrTheDepth) {
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        const Pair p = next();
        const long double expected = p.expected();
        const Separation found = separation(p.shapeA, p.a, p.shapeB, p.b);
        ASSERT_TRUE(near(length(found.axis), 1, 8 * support::kEpsilon)) << "pose " << i;
        if (expected < 0 || p.hasRound() || p.hasPlane()) {
            ASSERT_TRUE(near(found.distance, expected, kTolerance)) << "pose " << i;
        } else {
            ASSERT_LE(found.distance, expected + static_cast<long double>(kTolerance));
            ASSERT_GT(found.distance, -kTolerance) << "pose " << i;
        }
    }
}

// Without a contact, the reported separation never exceeds the true gap. A pair that is skipped
// until its bodies have moved that far misses no contact. Of one-sided shapes it may be unknown.
TEST_P(EveryPair, SeparationWithoutContactIsAtMostTheGap) {
    int known = 0;
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        const Pair p = next();
        const Manifold manifold = p.manifold(kMargin);
        if (manifold.count == 0) {
            const Real gap = manifold.points[0].separation;
            ASSERT_GE(gap, 0) << "pose " << i;
            ASSERT_LE(gap, p.expected() + static_cast<long double>(kTolerance)) << "pose " << i;
            known += gap > kMargin ? 1 : 0;
        }
    }
    const auto [kindA, kindB] = GetParam();
    if (kindA != AnyKind::Plane && kindB != AnyKind::Plane) {
        EXPECT_GT(known, kPoses / 50);
    }
}

TEST_P(EveryPair, HasAContactWithinTheMargin) {
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        const Pair p = next();
        const long double expected = p.expected();
        const Manifold manifold = p.manifold(kMargin);
        if (expected < static_cast<long double>(kMargin - kTolerance)) {
            ASSERT_GT(manifold.count, 0) << "pose " << i << ": " << expected;
        }
        for (std::size_t k = 0; k < static_cast<std::size_t>(manifold.count); ++k) {
            ASSERT_LE(manifold.points[k].separation, kMargin);
            ASSERT_GE(manifold.points[k].separation, manifold.points[0].separation);
        }
        if (manifold.count == 2) { // two different points
            ASSERT_NE(manifold.points[0].armA, manifold.points[1].armA) << "pose " << i;
            ASSERT_NE(manifold.points[0].feature, manifold.points[1].feature) << "pose " << i;
        }
    }
}

// Neither face need lie over the other: a point beyond an end has at least the separation along the
// best axis, which for polygons is a lower bound of the distance.
TEST_P(EveryPair, NearerThanAnyMarginHasAPointNoDeeperThanItsBestAxis) {
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        const Pair p = next();
        const Real gap = distance(p.shapeA, p.a, p.shapeB, p.b).distance;
        const Real along = separation(p.shapeA, p.a, p.shapeB, p.b).distance;
        for (const Real margin : {Real(0.01), Real(0.1), Real(0.5), Real(2)}) {
            if (gap > 0 && gap < margin - kTolerance) {
                const Manifold manifold = p.manifold(margin);
                ASSERT_GT(manifold.count, 0) << "pose " << i << ": " << gap << ", " << margin;
                ASSERT_GE(manifold.points[0].separation, along - kTolerance) << "pose " << i;
            }
        }
    }
}

// X2: shape against shape without a World.
TEST_P(EveryPair, TranslationByNormalAndDepthEndsTheOverlap) {
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        Pair p = next();
        const Manifold manifold = p.manifold(0);
        if (manifold.count > 0) {
            p.b.position -= manifold.points[0].separation * manifold.normal;
            ASSERT_TRUE(near(p.expected(), 0, 2 * kTolerance)) << "pose " << i;
        }
    }
}

// Each point lies halfway between two surfaces whose distance is its separation. Corners beyond the
// end of a face have no opposite surface until they touch.
TEST_P(EveryPair, PointsLieHalfwayBetweenTheSurfaces) {
    const ConvexShape dot = convexShapeOf(Point{}, {});
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        const Pair p = next();
        const Manifold manifold = p.manifold(p.hasRound() || p.hasPlane() ? kMargin : 0);
        for (std::size_t k = 0; k < static_cast<std::size_t>(manifold.count); ++k) {
            const ManifoldPoint& point = manifold.points[k];
            const Transform at{p.a.position + point.armA, {}};
            ASSERT_TRUE(near(at.position, p.b.position + point.armB, kTolerance));
            const Real most = std::abs(point.separation) / 2 + kTolerance;
            ASSERT_LT(support::signedDistance(p.shapeA, p.a, dot, at), most) << "pose " << i;
            ASSERT_LT(support::signedDistance(p.shapeB, p.b, dot, at), most) << "pose " << i;
        }
    }
}

// The true distance, also corner to corner, and the two closest points.
TEST_P(EveryPair, DistanceIsThatOfTheClosestPoints) {
    const ConvexShape dot = convexShapeOf(Point{}, {});
    for (int i = 0; i < kPoses && !bothPlanes(); ++i) {
        const Pair p = next();
        const long double expected = std::max(p.expected(), 0.0L);
        const ClosestPoints found = distance(p.shapeA, p.a, p.shapeB, p.b);
        ASSERT_TRUE(near(found.distance, expected, kTolerance)) << "pose " << i;
        ASSERT_TRUE(near(length(found.onB - found.onA), expected, kTolerance)) << "pose " << i;
        ASSERT_TRUE(near(found.onA + found.distance * found.normal, found.onB, kTolerance));
        const long double fromA = support::signedDistance(p.shapeA, p.a, dot, {found.onA, {}});
        const long double fromB = support::signedDistance(p.shapeB, p.b, dot, {found.onB, {}});
        ASSERT_LT(fromA, kTolerance) << "pose " << i;
        ASSERT_LT(fromB, kTolerance) << "pose " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, EveryPair,
                         testing::Combine(testing::ValuesIn(support::kTwoSidedKinds),
                                          testing::ValuesIn(support::kTwoSidedKinds)),
                         [](const testing::TestParamInfo<std::tuple<AnyKind, AnyKind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_on_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

// Two half-planes always belong to locked bodies, so they never touch.
TEST(TwoPlanes, NeverTouch) {
    const ConvexShape plane = convexShapeOf(Plane{}, {});
    EXPECT_EQ(collide(plane, {}, plane, {}, 1, 0).count, 0);
    EXPECT_GT(separation(plane, {}, plane, {}).distance, 0);
}

// Only end points separate two collinear lines.
TEST(TwoSegments, InARowTouchEndToEnd) {
    const ConvexShape line = convexShapeOf(Segment{{-1, 0}, {1, 0}}, {});
    const Transform far{{Real(2.125), 0}, {}};
    EXPECT_EQ(collide(line, {}, line, far, Real(0.0625), 0).count, 0);
    EXPECT_EQ(separation(line, {}, line, far).distance, Real(0.125));
    const Manifold manifold = collide(line, {}, line, far, Real(0.25), 0);
    ASSERT_EQ(manifold.count, 1);
    EXPECT_EQ(manifold.normal, (Vec2{1, 0}));
    EXPECT_EQ(manifold.points[0].separation, Real(0.125));
    EXPECT_EQ(manifold.points[0].armA, (Vec2{Real(1.0625), 0}));
}

// A segment has two sides: a ball is separated towards the side of its centre.
TEST(Segment, NormalPointsToTheSideOfTheCentre) {
    const ConvexShape line = convexShapeOf(Segment{{-1, 0}, {1, 0}}, {});
    const ConvexShape ball = convexShapeOf(Circle{1}, {});
    for (const Real side : {Real(1), Real(-1)}) {
        const Manifold manifold = collide(line, {}, ball, {{0, side / 4}, {}}, 0, 0);
        ASSERT_EQ(manifold.count, 1);
        EXPECT_EQ(manifold.normal, (Vec2{0, side}));
        EXPECT_EQ(manifold.points[0].separation, Real(-0.75));
    }
}

} // namespace
} // namespace kodo::every_pair_test
