// SPDX-License-Identifier: MIT
#include <kodo/collide/outlook.hpp>
#include <kodo/collide/time_of_impact.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include <cmath>
#include <numbers>
#include <tuple>

namespace kodo {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::near;
using support::Passage;

constexpr Real kTolerance = byPrecision(2e-5, 1e-13); // ways of up to 10 m

/// How two go on that are not planes.
Course courseOf(const Convex& shapeA, const Sweep& a, const Convex& shapeB, const Sweep& b,
                Real length, Real target) {
    return {.towards = a.move - b.move,
            .turnA = a.turn,
            .turnB = b.turn,
            .turning = shapeA.swing() * std::abs(a.turn) + shapeB.swing() * std::abs(b.turn),
            .length = length,
            .target = target};
}

// One look at two polygons that do not turn tells what a slow advance in long double finds: when
// one touches the other, or that it does not.
TEST(Outlook, IsExactForPolygonsThatDoNotTurn) {
    support::RandomNumbers random(211);
    int hits = 0;
    int misses = 0;
    const int courses = support::draws(20000);
    for (int i = 0; i < courses; ++i) {
        SCOPED_TRACE(testing::Message() << "course " << i);
        const Convex shapeA = support::randomFewCorners(random);
        const Convex shapeB = support::randomFewCorners(random);
        const Sweep a{random.pose(4), random.point(3), 0};
        const Sweep b{{a.start.position + random.point(4), random.rotation()}, random.point(3), 0};
        const Passage expected =
            support::passageOf(shapeB, b.start, b.move - a.move, shapeA, a.start);
        if (support::signedDistance(shapeA, a.start, shapeB, b.start) <
            static_cast<long double>(kTolerance)) {
            continue;
        }
        const Course course = courseOf(shapeA, a, shapeB, b, 1, 0);
        const Outlook outlook = outlookOf(shapeA, a.start, shapeB, b.start, course);
        if (expected.end == Passage::End::Hits) {
            ASSERT_FALSE(outlook.passes(course));
            // A flat angle makes more of the way out of the same rounding.
            const long double closing = dot(expected.normal, support::widened(a.move - b.move));
            ASSERT_TRUE(near(static_cast<long double>(outlook.last) * closing,
                             expected.fraction * closing, kTolerance));
            ++hits;
        } else if (expected.end == Passage::End::Misses) {
            ASSERT_TRUE(outlook.passes(course));
            ++misses;
        }
    }
    EXPECT_GT(hits, courses / 20);
    EXPECT_GT(misses, courses / 10);
}

class EveryOutlook : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {};

// Until the time that it tells, and to the end if it says that they pass, a fine sampling of the
// true distance finds them farther apart than the target, however they turn.
TEST_P(EveryOutlook, NeverPromisesTooMuch) {
    support::RandomNumbers random(212);
    int looks = 0;
    int passing = 0;
    const int courses = support::draws(500);
    for (int i = 0; i < courses; ++i) {
        SCOPED_TRACE(testing::Message() << "course " << i);
        const Convex shapeA =
            convexOf(support::randomPrimitive(random, std::get<0>(GetParam())), {});
        const Convex shapeB =
            convexOf(support::randomPrimitive(random, std::get<1>(GetParam())), {});
        const double fast = random.below(3) == 0 ? 30 : 2; // rad a step, and m
        const double far = random.below(3) == 0 ? 10 : 2;
        const Sweep a{random.pose(4), random.point(far), random.between(-fast, fast)};
        const Sweep b{{a.start.position + random.point(4), random.rotation()},
                      random.point(far),
                      random.between(-fast, fast)};
        const Real target = random.below(4) == 0 ? Real(-0.05) : Real(0.001);
        const Real length = random.between(0.05, 1);
        const Course course = courseOf(shapeA, a, shapeB, b, length, target);
        const Outlook outlook = outlookOf(shapeA, a.start, shapeB, b.start, course);
        const bool passes = outlook.passes(course);
        const Real end = passes ? length : outlook.last;
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

INSTANTIATE_TEST_SUITE_P(AllKinds, EveryOutlook,
                         testing::Combine(testing::Values(AnyKind::Point, AnyKind::Circle,
                                                          AnyKind::Box, AnyKind::Polygon,
                                                          AnyKind::Segment),
                                          testing::Values(AnyKind::Circle, AnyKind::Box,
                                                          AnyKind::Polygon, AnyKind::Segment)),
                         [](const testing::TestParamInfo<std::tuple<AnyKind, AnyKind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_and_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

// A rod (2 m by 0.1 m) turns by 1 rad a step and falls onto a floor, which it touches in the middle
// of the course. What is left of the gap at the time that is told shrinks with the square of the
// course: the way of a corner bends by the square of the turn at its arm, and its chord is as far
// off.
TEST(Outlook, ForeseesTurnsToTheSquareOfACourse) {
    const Convex floor = convexOf(Box{20, 2}, {});
    const Convex rod = convexOf(Box{2, Real(0.1)}, {});
    for (const Real turn : {Real(1), Real(-1)}) {
        for (const Real length : {Real(0.4), Real(0.1), Real(0.025)}) {
            SCOPED_TRACE(testing::Message() << "turn " << turn << ", course " << length);
            const Real angle = Real(0.5) + turn * length / 2; // when it touches
            const Real below = std::sin(angle) + Real(0.05) * std::cos(angle);
            const Sweep fall{
                {{0, 1 + below + length / 2}, Rot::fromAngle(Real(0.5))}, {0, -1}, turn};
            const Sweep still{{}, {}, 0};
            const Course course = courseOf(floor, still, rod, fall, length, 0);
            const Outlook outlook = outlookOf(floor, still.start, rod, fall.start, course);
            ASSERT_FALSE(outlook.passes(course));
            const long double gap =
                support::signedDistance(floor, still.start, rod, fall.at(outlook.last));
            EXPECT_GE(gap, -kTolerance);
            EXPECT_LE(gap, rod.swing() * turn * turn * length * length);
        }
    }
}

// Before the last axis that keeps two boxes apart gives way, another one does: corners that pass
// each other by 1 cm are known to do so at the first look.
TEST(Outlook, KnowsThatCornersPassEachOther) {
    const Convex box = convexOf(Box{1, 1}, {});
    const Real aside = 1 + Real(0.01) / std::numbers::sqrt2_v<Real>;
    const Transform start{{Real(1.5) + aside, Real(-1.5) + aside}, {}};
    const Course course{.towards = {3, -3}, .length = 1, .target = Real(1e-4)};
    const Outlook outlook = outlookOf(box, {}, box, start, course);
    EXPECT_TRUE(outlook.passes(course)) << outlook.last << ", " << outlook.first;
}

} // namespace
} // namespace kodo
