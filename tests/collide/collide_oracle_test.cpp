// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/convex_oracle.hpp>
#include <support/draws.hpp>
#include <support/near.hpp>
#include <support/random_shapes.hpp>

#include <string>
#include <tuple>

namespace kodo::collide_oracle_test {
namespace {

using support::byPrecision;
using support::Kind;
using support::near;
using support::Outline;

// Distances of up to 8 m, some twenty roundings.
constexpr Real kTolerance = byPrecision(5e-6, 1e-14);
constexpr Real kMargin = Real(0.25);
const int kPoses = support::poses();

struct Pair {
    ConvexShape shapeA;
    ConvexShape shapeB;
    Transform a;
    Transform b;
};

class CollidePair : public testing::TestWithParam<std::tuple<Kind, Kind>> {
protected:
    /// A pair near each other: about half of the pairs overlap.
    Pair next() {
        Pair pair;
        pair.shapeA = convexShapeOf(support::randomPrimitive(random_, std::get<0>(GetParam())), {});
        pair.shapeB = convexShapeOf(support::randomPrimitive(random_, std::get<1>(GetParam())), {});
        pair.a = random_.pose(4);
        pair.b = {pair.a.position + random_.point(2.5), random_.rotation()};
        return pair;
    }
    support::RandomNumbers random_{71};
};

// C1: sign and value of the separation against the oracle.
TEST_P(CollidePair, SeparationAgreesWithTheOracle) {
    int overlapping = 0;
    for (int i = 0; i < kPoses; ++i) {
        const Pair p = next();
        const long double expected = support::separationOf(support::outlineOf(p.shapeA, p.a),
                                                           support::outlineOf(p.shapeB, p.b));
        const Separation found = separation(p.shapeA, p.a, p.shapeB, p.b);
        ASSERT_TRUE(near(found.distance, expected, kTolerance)) << "pose " << i;
        ASSERT_TRUE(near(length(found.axis), 1, 8 * support::kEpsilon)) << "pose " << i;
        overlapping += expected < 0 ? 1 : 0;
    }
    EXPECT_GT(overlapping, kPoses / 10);
    EXPECT_LT(overlapping, kPoses * 9 / 10);
}

/// Distance of the pair along the best axis, and between the nearest points. They differ only where
/// a corner of one polygon lies beyond the end of the other's face.
struct Gap {
    long double alongAxis;
    long double straight;
};

Gap gapOf(const Outline& a, const Outline& b) {
    const long double alongAxis = support::separationOf(a, b);
    const bool flat = a.corners.size() > 1 && b.corners.size() > 1;
    return {alongAxis, flat && alongAxis > 0 ? support::distanceOf(a, b) : alongAxis};
}

// C1: a pair closer than the margin has a contact. A pair that an axis separates by more has none.
TEST_P(CollidePair, ReportsContactsOnlyWithinTheMargin) {
    for (int i = 0; i < kPoses; ++i) {
        const Pair p = next();
        const Gap gap = gapOf(support::outlineOf(p.shapeA, p.a), support::outlineOf(p.shapeB, p.b));
        const Manifold manifold = collide(p.shapeA, p.a, p.shapeB, p.b, kMargin, 0);
        if (gap.straight < static_cast<long double>(kMargin - kTolerance)) {
            ASSERT_GT(manifold.count, 0) << "pose " << i << ", " << gap.straight << " apart";
        }
        if (gap.alongAxis > static_cast<long double>(kMargin + kTolerance)) {
            ASSERT_EQ(manifold.count, 0) << "pose " << i << ", " << gap.alongAxis << " apart";
        }
    }
}

// C1: two polygons touch if their edges cross or one contains the other, independently of axes.
TEST_P(CollidePair, TouchesExactlyWhenEdgesCross) {
    for (int i = 0; i < kPoses; ++i) {
        const Pair p = next();
        const Outline a = support::outlineOf(p.shapeA, p.a);
        const Outline b = support::outlineOf(p.shapeB, p.b);
        const bool flat = a.corners.size() > 1 && b.corners.size() > 1;
        if (flat &&
            std::abs(support::separationOf(a, b)) > static_cast<long double>(10 * kTolerance)) {
            const Manifold touching = collide(p.shapeA, p.a, p.shapeB, p.b, 0, 0);
            ASSERT_EQ(touching.count > 0, support::polygonsMeet(a, b)) << "pose " << i;
        }
    }
}

// C4: after B moves by the separation along the normal, the pair just touches.
TEST_P(CollidePair, NormalIsTheShortestSeparatingTranslation) {
    for (int i = 0; i < kPoses; ++i) {
        Pair p = next();
        const Manifold manifold = collide(p.shapeA, p.a, p.shapeB, p.b, 0, 0);
        if (manifold.count == 0) {
            continue;
        }
        p.b.position -= manifold.points[0].separation * manifold.normal;
        const long double gap = support::separationOf(support::outlineOf(p.shapeA, p.a),
                                                      support::outlineOf(p.shapeB, p.b));
        ASSERT_TRUE(near(gap, 0, 2 * kTolerance)) << "pose " << i;
    }
}

// C4: both arms lead to the same point, halfway between the surfaces. The deepest point is first.
TEST_P(CollidePair, PointsLieHalfwayBetweenTheSurfaces) {
    for (int i = 0; i < kPoses; ++i) {
        const Pair p = next();
        const Outline a = support::outlineOf(p.shapeA, p.a);
        const Outline b = support::outlineOf(p.shapeB, p.b);
        const Manifold manifold = collide(p.shapeA, p.a, p.shapeB, p.b, kMargin, 0);
        for (int k = 0; k < manifold.count; ++k) {
            const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(k)];
            ASSERT_TRUE(near(p.a.position + point.armA, p.b.position + point.armB, kTolerance));
            ASSERT_LE(point.separation, kMargin);
            ASSERT_GE(point.separation, manifold.points[0].separation);
        }
        if (manifold.count > 0) {
            const Gap gap = gapOf(a, b);
            const auto deepest = static_cast<long double>(manifold.points[0].separation);
            ASSERT_GT(deepest, gap.alongAxis - static_cast<long double>(kTolerance));
            if (gap.alongAxis < 0) {
                ASSERT_LT(deepest, gap.alongAxis + static_cast<long double>(kTolerance));
            }
        }
        ASSERT_LE(manifold.count, 2);
    }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, CollidePair,
                         testing::Combine(testing::ValuesIn(support::kAllKinds),
                                          testing::ValuesIn(support::kAllKinds)),
                         [](const testing::TestParamInfo<std::tuple<Kind, Kind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_on_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

} // namespace
} // namespace kodo::collide_oracle_test
