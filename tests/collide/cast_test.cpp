// SPDX-License-Identifier: MIT
#include <kodo/collide/cast.hpp>
#include <support/draws.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include <tuple>

namespace kodo {
namespace {

using support::AnyKind;
using support::byPrecision;
using support::near;
using support::Passage;

// Ways of up to 8 m, some forty roundings.
constexpr Real kTolerance = byPrecision(1e-5, 2e-14);
constexpr int kPoses = support::draws(10000);

class EveryCast : public testing::TestWithParam<std::tuple<AnyKind, AnyKind>> {
protected:
    /// They overlap wherever they are: there is nothing to cast.
    bool bothPlanes() const {
        return std::get<0>(GetParam()) == AnyKind::Plane &&
               std::get<1>(GetParam()) == AnyKind::Plane;
    }
    support::RandomNumbers random_{111};
};

/// Where the cast ends the two touch, it comes from outside, and it is not behind the first touch.
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
    // A flat angle makes more of the way out of the same rounding.
    const Real closing = -dot(hit->normal, move);
    ASSERT_TRUE(near(length(hit->normal), 1, 8 * support::kEpsilon));
    ASSERT_GT(closing, 0);
    ASSERT_TRUE(near(hit->fraction * closing, expected.fraction * static_cast<long double>(closing),
                     kTolerance));
}

// C1: every kind moving at every other, against the slow advance in long double.
TEST_P(EveryCast, MeetsTheOtherWhereTheSlowAdvanceDoes) {
    int hits = 0;
    for (int i = 0; i < kPoses && !bothPlanes() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "pose " << i);
        const Convex moving =
            convexOf(support::randomPrimitive(random_, std::get<0>(GetParam())), {});
        const Convex target =
            convexOf(support::randomPrimitive(random_, std::get<1>(GetParam())), {});
        const Transform t = random_.pose(4);
        const Transform from{t.position + random_.point(4), random_.rotation()};
        const Vec2 move = random_.point(6);
        const Passage expected = support::frontPassageOf(moving, from, move, target, t);
        const std::optional<CastHit> hit = shapeCast(moving, from, move, target, t);
        expectSame(expected, hit, move);
        if (hit) {
            const Transform at{from.position + hit->fraction * move, from.rotation};
            const Convex dot = convexOf(Point{hit->point}, {});
            ASSERT_LT(support::signedDistance(target, t, dot, {}), 4 * kTolerance);
            ASSERT_LT(support::signedDistance(moving, at, dot, {}), 4 * kTolerance);
            ++hits;
        }
    }
    // Two points meet by luck alone, and two planes overlap from the start.
    const bool points =
        std::get<0>(GetParam()) == AnyKind::Point && std::get<1>(GetParam()) == AnyKind::Point;
    const bool thin = points || bothPlanes();
    EXPECT_GT(hits, thin ? -1 : kPoses / 100);
}

// A ray is the way of a point.
TEST_P(EveryCast, OfAPointIsARay) {
    const Convex point = convexOf(Point{}, {});
    for (int i = 0; i < kPoses && !bothPlanes() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "pose " << i);
        const Convex target =
            convexOf(support::randomPrimitive(random_, std::get<1>(GetParam())), {});
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

// A ball rolled at a corner: the height of the centre over the corner decides, by Pythagoras.
TEST(ShapeCast, OfABallAtACornerIsTheClosedForm) {
    const Convex ball = convexOf(Circle{1}, {});
    const Convex box = convexOf(Box{2, 2}, {});
    const auto hit = shapeCast(ball, {{-5, Real(1.6)}, {}}, {4, 0}, box, {});
    ASSERT_TRUE(hit);
    EXPECT_TRUE(near(hit->fraction, (4 - 0.8L) / 4, kTolerance)); // 0.6, 0.8, 1
    EXPECT_TRUE(near(hit->normal, Vec2{Real(-0.8), Real(0.6)}, kTolerance));
    EXPECT_TRUE(near(hit->point, Vec2{-1, 1}, kTolerance));
}

TEST(ShapeCast, OfABoxOntoABoxLandsOnItsFace) {
    const Convex box = convexOf(Box{2, 2}, {});
    const auto hit = shapeCast(box, {{Real(0.5), 6}, {}}, {0, -8}, box, {});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->fraction, Real(0.5));
    EXPECT_EQ(hit->normal, (Vec2{0, 1}));
    EXPECT_EQ(hit->point.y, 1);
}

TEST(ShapeCast, ThatStartsInOverlapIsThereAlready) {
    const Convex box = convexOf(Box{2, 2}, {});
    const Convex ball = convexOf(Circle{1}, {});
    for (const Convex* moving : {&box, &ball}) {
        const auto hit = shapeCast(*moving, {{1, 0}, {}}, {9, 0}, box, {});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->fraction, 0);
        EXPECT_EQ(hit->normal, Vec2{});
    }
}

// A one-sided line stops what comes from its front, and nothing else.
TEST(ShapeCast, PassesAOneSidedLineFromBehind) {
    const Convex platform = convexOf(Segment{{-2, 0}, {2, 0}, true, {}, {}}, {});
    const Convex shapes[] = {convexOf(Circle{1}, {}), convexOf(Box{2, 2}, {}),
                             convexOf(Point{{0, 0}}, {}),
                             convexOf(Segment{{-1, 0}, {1, 0}, false, {}, {}}, {})};
    for (const Convex& shape : shapes) {
        EXPECT_TRUE(shapeCast(shape, {{0, 3}, {}}, {0, -6}, platform, {}));
        EXPECT_FALSE(shapeCast(shape, {{0, -3}, {}}, {0, 6}, platform, {}));
    }
    EXPECT_FALSE(shapeCast(shapes[1], {{0, Real(0.5)}, {}}, {0, -6}, platform, {}))
        << "what overlaps it from the start is passing";
}

// A platform that moves itself is no other: it takes along what it meets with its front, and passes
// what it meets with its back or overlaps.
TEST(ShapeCast, OfAOneSidedLineMeetsWithItsFrontAlone) {
    const Convex platform = convexOf(Segment{{-2, 0}, {2, 0}, true, {}, {}}, {});
    const Convex targets[] = {convexOf(Circle{1}, {}), convexOf(Box{2, 2}, {}),
                              convexOf(Point{{0, 0}}, {}),
                              convexOf(Segment{{-1, 0}, {1, 0}, false, {}, {}}, {})};
    for (const Convex& target : targets) {
        EXPECT_TRUE(shapeCast(platform, {{0, -3}, {}}, {0, 6}, target, {}));
        EXPECT_FALSE(shapeCast(platform, {{0, 3}, {}}, {0, -6}, target, {}));
    }
    EXPECT_FALSE(shapeCast(platform, {{0, Real(-0.5)}, {}}, {0, 6}, targets[1], {}));
    const Convex ground = convexOf(Plane{}, {});
    const Transform upsideDown{{0, 3}, {-1, 0}};
    EXPECT_TRUE(shapeCast(platform, upsideDown, {0, -6}, ground, {}));
    EXPECT_FALSE(shapeCast(platform, {{0, 3}, {}}, {0, -6}, ground, {}));
    EXPECT_TRUE(shapeCast(ground, {{0, -3}, {}}, {0, 6}, platform, upsideDown));
    EXPECT_FALSE(shapeCast(ground, {{0, -3}, {}}, {0, 6}, platform, {{0, 1}, {}}));
    EXPECT_FALSE(shapeCast(platform, {{0, 3}, {}}, {0, -6}, platform, {})) << "back to front";
    EXPECT_TRUE(shapeCast(platform, upsideDown, {0, -6}, platform, {})) << "face to face";
}

} // namespace
} // namespace kodo
