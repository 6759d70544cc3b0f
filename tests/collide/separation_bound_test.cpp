// SPDX-License-Identifier: MIT
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include "collide/separation_bound.hpp"
#include "collide/time_of_impact.hpp"

#include <cmath>
#include <numbers>
#include <tuple>

namespace kodo::separation_bound_test {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::near;
using support::Passage;

constexpr Real kTolerance = byPrecision(2e-5, 1e-13); // paths of up to 10 m

/// Relative path of two shapes that are not planes.
RelativePath courseOf(const ConvexShape& shapeA, const MotionPath& a, const ConvexShape& shapeB,
                      const MotionPath& b, Real length, Real target) {
    return {.towards = a.deltaPosition - b.deltaPosition,
            .deltaAngleA = a.deltaAngle,
            .deltaAngleB = b.deltaAngle,
            .turning = shapeA.rotationReach() * std::abs(a.deltaAngle) +
                       shapeB.rotationReach() * std::abs(b.deltaAngle),
            .length = length,
            .target = target};
}

// For two polygons without rotation, a single bound gives the result of conservative advancement in
// long double: the time of impact, or that there is none.
TEST(SeparationBound, IsExactForPolygonsThatDoNotRotate) {
    support::RandomNumbers random(211);
    int hits = 0;
    int misses = 0;
    const int courses = support::draws(20000);
    for (int i = 0; i < courses; ++i) {
        SCOPED_TRACE(testing::Message() << "path " << i);
        const ConvexShape shapeA = support::randomFewCorners(random);
        const ConvexShape shapeB = support::randomFewCorners(random);
        const MotionPath a{random.pose(4), random.point(3), 0};
        const MotionPath b{
            {a.start.position + random.point(4), random.rotation()}, random.point(3), 0};
        const Passage expected =
            support::passageOf(shapeB, b.start, b.deltaPosition - a.deltaPosition, shapeA, a.start);
        if (support::signedDistance(shapeA, a.start, shapeB, b.start) <
            static_cast<long double>(kTolerance)) {
            continue;
        }
        const RelativePath path = courseOf(shapeA, a, shapeB, b, 1, 0);
        const SeparationBound separationBound =
            separationBoundOf(shapeA, a.start, shapeB, b.start, path);
        if (expected.end == Passage::End::Hits) {
            ASSERT_FALSE(separationBound.passes(path));
            // At a flat angle the same rounding is a larger error along the path.
            const long double closing =
                dot(expected.normal, support::widened(a.deltaPosition - b.deltaPosition));
            ASSERT_TRUE(near(static_cast<long double>(separationBound.last) * closing,
                             expected.fraction * closing, kTolerance));
            ++hits;
        } else if (expected.end == Passage::End::Misses) {
            ASSERT_TRUE(separationBound.passes(path));
            ++misses;
        }
    }
    EXPECT_GT(hits, courses / 20);
    EXPECT_GT(misses, courses / 10);
}

class EverySeparationBound : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {};

// Until the bound, and to the end if the shapes pass, samples of the true distance exceed the
// target, for any rotation.
TEST_P(EverySeparationBound, IsConservative) {
    support::RandomNumbers random(212);
    int looks = 0;
    int passing = 0;
    const int courses = support::poses() / 8;
    for (int i = 0; i < courses; ++i) {
        SCOPED_TRACE(testing::Message() << "path " << i);
        const ConvexShape shapeA =
            convexShapeOf(support::randomPrimitive(random, std::get<0>(GetParam())), {});
        const ConvexShape shapeB =
            convexShapeOf(support::randomPrimitive(random, std::get<1>(GetParam())), {});
        const double fast = random.below(3) == 0 ? 30 : 2; // rad per step
        const double far = random.below(3) == 0 ? 10 : 2;
        const MotionPath a{random.pose(4), random.point(far), random.between(-fast, fast)};
        const MotionPath b{{a.start.position + random.point(4), random.rotation()},
                           random.point(far),
                           random.between(-fast, fast)};
        const Real target = random.below(4) == 0 ? Real(-0.05) : Real(0.001);
        const Real length = random.between(0.05, 1);
        const RelativePath path = courseOf(shapeA, a, shapeB, b, length, target);
        const SeparationBound separationBound =
            separationBoundOf(shapeA, a.start, shapeB, b.start, path);
        const bool passes = separationBound.passes(path);
        const Real end = passes ? length : separationBound.last;
        for (int k = 0; k <= 32 && end > 0; ++k) {
            const Real t = end * static_cast<Real>(k) / 32;
            ASSERT_GT(support::signedDistance(shapeA, a.at(t), shapeB, b.at(t)),
                      target - kTolerance)
                << "sample " << k << " of " << end;
        }
        looks += end > 0 ? 1 : 0;
        passing += passes ? 1 : 0;
    }
    EXPECT_GT(looks, courses / 4);
    EXPECT_GT(passing, courses / 10);
    EXPECT_LT(passing, looks);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, EverySeparationBound,
                         testing::Combine(testing::Values(AnyKind::Point, AnyKind::Circle,
                                                          AnyKind::Box, AnyKind::Polygon,
                                                          AnyKind::Segment),
                                          testing::Values(AnyKind::Circle, AnyKind::Box,
                                                          AnyKind::Polygon, AnyKind::Segment)),
                         [](const testing::TestParamInfo<std::tuple<AnyKind, AnyKind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_and_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

// A rod (2 m by 0.1 m) rotates by 1 rad per step and falls onto a floor, which it touches in the
// middle of the path. The gap that remains at the bound shrinks with the square of the path length.
// The arc of a corner deviates from its chord by the square of the angle times the arm.
TEST(SeparationBound, ErrorByRotationShrinksWithTheSquareOfThePath) {
    const ConvexShape floor = convexShapeOf(Box{20, 2}, {});
    const ConvexShape rod = convexShapeOf(Box{2, Real(0.1)}, {});
    for (const Real turn : {Real(1), Real(-1)}) {
        for (const Real length : {Real(0.4), Real(0.1), Real(0.025)}) {
            SCOPED_TRACE(testing::Message() << "turn " << turn << ", path " << length);
            const Real angle = Real(0.5) + turn * length / 2; // when it touches
            const Real below = std::sin(angle) + Real(0.05) * std::cos(angle);
            const MotionPath fall{
                {{0, 1 + below + length / 2}, Rot::fromAngle(Real(0.5))}, {0, -1}, turn};
            const MotionPath still{{}, {}, 0};
            const RelativePath path = courseOf(floor, still, rod, fall, length, 0);
            const SeparationBound separationBound =
                separationBoundOf(floor, still.start, rod, fall.start, path);
            ASSERT_FALSE(separationBound.passes(path));
            const long double gap =
                support::signedDistance(floor, still.start, rod, fall.at(separationBound.last));
            EXPECT_GE(gap, -kTolerance);
            EXPECT_LE(gap, rod.rotationReach() * turn * turn * length * length);
        }
    }
}

// Before the last axis that separates two boxes ceases to, another one does. So a single bound
// shows that corners pass each other by 1 cm.
TEST(SeparationBound, ShowsThatCornersPassEachOther) {
    const ConvexShape box = convexShapeOf(Box{1, 1}, {});
    const Real aside = 1 + Real(0.01) / std::numbers::sqrt2_v<Real>;
    const Transform start{{Real(1.5) + aside, Real(-1.5) + aside}, {}};
    const RelativePath path{.towards = {3, -3}, .length = 1, .target = Real(1e-4)};
    const SeparationBound separationBound = separationBoundOf(box, {}, box, start, path);
    EXPECT_TRUE(separationBound.passes(path))
        << separationBound.last << ", " << separationBound.first;
}

} // namespace
} // namespace kodo::separation_bound_test
