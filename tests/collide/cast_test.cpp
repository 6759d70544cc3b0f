// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include <tuple>

namespace kodo::cast_test {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::near;
using support::Passage;

// Paths of up to 8 m, some forty roundings.
constexpr Real kTolerance = byPrecision(1e-5, 2e-14);
const int kPoses = support::poses();

class EveryCast : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {
protected:
    /// True for two planes, which overlap in any pose, so that there is nothing to cast.
    bool bothPlanes() const {
        return std::get<0>(GetParam()) == AnyKind::Plane &&
               std::get<1>(GetParam()) == AnyKind::Plane;
    }
    support::RandomNumbers random_{111};
};

/// At the end of the cast the shapes touch. It comes from outside, and is not later than the first
/// touch.
void expectSame(const Passage& expected, const std::optional<CastHit>& hit, Vec2 move) {
    if (expected.end == Passage::End::Misses) {
        ASSERT_FALSE(hit) << "at " << hit->fraction;
    }
    if (expected.end != Passage::End::Hits) {
        return;
    }
    ASSERT_TRUE(hit) << "should be at " << expected.fraction;
    if (hit->normal == Vec2{}) {
        ASSERT_EQ(hit->fraction, 0);
        ASSERT_TRUE(
            near(expected.fraction * static_cast<long double>(length(move)), 0, kTolerance));
        return;
    }
    // At a flat angle the same rounding is a larger error along the path.
    const Real closing = -dot(hit->normal, move);
    ASSERT_TRUE(near(length(hit->normal), 1, 8 * support::kEpsilon));
    ASSERT_GT(closing, 0);
    ASSERT_TRUE(near(hit->fraction * closing, expected.fraction * static_cast<long double>(closing),
                     kTolerance));
}

// C1: every kind cast at every other, against conservative advancement in long double.
TEST_P(EveryCast, AgreesWithTheLongDoubleOracle) {
    int hits = 0;
    for (int i = 0; i < kPoses && !bothPlanes() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "pose " << i);
        const ConvexShape moving =
            convexShapeOf(support::randomPrimitive(random_, std::get<0>(GetParam())), {});
        const ConvexShape target =
            convexShapeOf(support::randomPrimitive(random_, std::get<1>(GetParam())), {});
        const Transform t = random_.pose(4);
        const Transform from{t.position + random_.point(4), random_.rotation()};
        const Vec2 move = random_.point(6);
        const Passage expected = support::frontPassageOf(moving, from, move, target, t);
        const std::optional<CastHit> hit = shapeCast(moving, from, move, target, t);
        expectSame(expected, hit, move);
        if (hit) {
            const Transform at{from.position + hit->fraction * move, from.rotation};
            const ConvexShape dot = convexShapeOf(Point{hit->point}, {});
            ASSERT_LT(support::signedDistance(target, t, dot, {}), 4 * kTolerance);
            ASSERT_LT(support::signedDistance(moving, at, dot, {}), 4 * kTolerance);
            ++hits;
        }
    }
    // Two points hardly ever hit, and two planes overlap at the start.
    const bool points =
        std::get<0>(GetParam()) == AnyKind::Point && std::get<1>(GetParam()) == AnyKind::Point;
    const bool thin = points || bothPlanes();
    EXPECT_GT(hits, thin ? -1 : kPoses / 100);
}

// A ray is the path of a point.
TEST_P(EveryCast, RayAgreesWithTheLongDoubleOracle) {
    const ConvexShape point = convexShapeOf(Point{}, {});
    for (int i = 0; i < kPoses && !bothPlanes() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "pose " << i);
        const ConvexShape target =
            convexShapeOf(support::randomPrimitive(random_, std::get<1>(GetParam())), {});
        const Transform t = random_.pose(4);
        const Vec2 from = t.position + random_.point(4);
        const Vec2 to = from + random_.point(6);
        const Passage expected = support::frontPassageOf(point, {from, {}}, to - from, target, t);
        const std::optional<RayHit> hit = rayCast(target, t, {from, to});
        expectSame(expected,
                   hit ? std::optional(CastHit{hit->fraction, hit->normal, {}}) : std::nullopt,
                   to - from);
    }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, EveryCast,
                         testing::Combine(testing::ValuesIn(support::kEveryKind),
                                          testing::ValuesIn(support::kEveryKind)),
                         [](const testing::TestParamInfo<std::tuple<AnyKind, AnyKind>>& row) {
                             return std::string(support::nameOf(std::get<0>(row.param))) + "_at_" +
                                    support::nameOf(std::get<1>(row.param));
                         });

// A ball moves at a corner: the height of its centre over the corner decides, by Pythagoras.
TEST(ShapeCast, OfABallAtACornerIsTheClosedForm) {
    const ConvexShape ball = convexShapeOf(Circle{1}, {});
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const auto hit = shapeCast(ball, {{-5, Real(1.6)}, {}}, {4, 0}, box, {});
    ASSERT_TRUE(hit);
    EXPECT_TRUE(near(hit->fraction, (4 - 0.8L) / 4, kTolerance)); // 0.6, 0.8, 1
    EXPECT_TRUE(near(hit->normal, Vec2{Real(-0.8), Real(0.6)}, kTolerance));
    EXPECT_TRUE(near(hit->point, Vec2{-1, 1}, kTolerance));
}

TEST(ShapeCast, OfABoxOntoABoxHitsItsFace) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const auto hit = shapeCast(box, {{Real(0.5), 6}, {}}, {0, -8}, box, {});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->fraction, Real(0.5));
    EXPECT_EQ(hit->normal, (Vec2{0, 1}));
    EXPECT_EQ(hit->point.y, 1);
}

TEST(ShapeCast, HitsAtZeroIfItStartsInOverlap) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const ConvexShape ball = convexShapeOf(Circle{1}, {});
    for (const ConvexShape* moving : {&box, &ball}) {
        const auto hit = shapeCast(*moving, {{1, 0}, {}}, {9, 0}, box, {});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->fraction, 0);
        EXPECT_EQ(hit->normal, Vec2{});
    }
}

// A one-sided line stops only shapes that come from its front.
TEST(ShapeCast, PassesAOneSidedLineFromBehind) {
    const ConvexShape platform = convexShapeOf(Segment{{-2, 0}, {2, 0}, true}, {});
    const ConvexShape shapes[] = {convexShapeOf(Circle{1}, {}), convexShapeOf(Box{2, 2}, {}),
                                  convexShapeOf(Point{{0, 0}}, {}),
                                  convexShapeOf(Segment{{-1, 0}, {1, 0}}, {})};
    for (const ConvexShape& shape : shapes) {
        EXPECT_TRUE(shapeCast(shape, {{0, 3}, {}}, {0, -6}, platform, {}));
        EXPECT_FALSE(shapeCast(shape, {{0, -3}, {}}, {0, 6}, platform, {}));
    }
    EXPECT_FALSE(shapeCast(shapes[1], {{0, Real(0.5)}, {}}, {0, -6}, platform, {}))
        << "a shape that overlaps at the start passes";
}

// A moving platform follows the same rule: it hits shapes with its front. It passes shapes that it
// meets with its back or overlaps.
TEST(ShapeCast, OfAOneSidedLineHitsOnlyWithItsFront) {
    const ConvexShape platform = convexShapeOf(Segment{{-2, 0}, {2, 0}, true}, {});
    const ConvexShape targets[] = {convexShapeOf(Circle{1}, {}), convexShapeOf(Box{2, 2}, {}),
                                   convexShapeOf(Point{{0, 0}}, {}),
                                   convexShapeOf(Segment{{-1, 0}, {1, 0}}, {})};
    for (const ConvexShape& target : targets) {
        EXPECT_TRUE(shapeCast(platform, {{0, -3}, {}}, {0, 6}, target, {}));
        EXPECT_FALSE(shapeCast(platform, {{0, 3}, {}}, {0, -6}, target, {}));
    }
    EXPECT_FALSE(shapeCast(platform, {{0, Real(-0.5)}, {}}, {0, 6}, targets[1], {}));
    const ConvexShape ground = convexShapeOf(Plane{}, {});
    const Transform upsideDown{{0, 3}, {-1, 0}};
    EXPECT_TRUE(shapeCast(platform, upsideDown, {0, -6}, ground, {}));
    EXPECT_FALSE(shapeCast(platform, {{0, 3}, {}}, {0, -6}, ground, {}));
    EXPECT_TRUE(shapeCast(ground, {{0, -3}, {}}, {0, 6}, platform, upsideDown));
    EXPECT_FALSE(shapeCast(ground, {{0, -3}, {}}, {0, 6}, platform, {{0, 1}, {}}));
    EXPECT_FALSE(shapeCast(platform, {{0, 3}, {}}, {0, -6}, platform, {})) << "back to front";
    EXPECT_TRUE(shapeCast(platform, upsideDown, {0, -6}, platform, {})) << "face to face";
}

} // namespace
} // namespace kodo::cast_test
