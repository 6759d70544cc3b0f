// SPDX-License-Identifier: MIT
#include <kodo/measure.hpp>
#include <kodo/ray.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

#include <cmath>
#include <numbers>

namespace kodo {
namespace {

using support::near;

using Wide = long double;
using WideVec = BasicVec2<Wide>;

// Closed forms with a dozen roundings of values near 1.
constexpr Wide kDozenRoundings = 1e-17L;

BasicPolygon<Wide> squareFromOrigin() {
    return {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
}

BasicBox<Wide> diamond() { // the square rotated by 45 degrees about its centre
    return {2, 2, {1, 1}, {std::sqrt(0.5L), std::sqrt(0.5L)}};
}

// P1: in long double, which tests the templates.
TEST(Primitives, HaveTextbookAreas) {
    EXPECT_TRUE(
        near(areaOf(BasicCircle<Wide>{2, {3, 4}}), 4 * std::numbers::pi_v<Wide>, kDozenRoundings));
    EXPECT_EQ(areaOf(BasicAabb<Wide>{{1, 2}, {4, 6}}), 12);
    EXPECT_EQ(areaOf(diamond()), 4);
    EXPECT_EQ(areaOf(squareFromOrigin()), 4);
    EXPECT_EQ(areaOf(BasicPolygon<Wide>{{{0, 0}, {3, 0}, {0, 4}}}), 6);
    EXPECT_EQ(areaOf(BasicPoint<Wide>{}), 0);
    EXPECT_EQ(areaOf(BasicSegment<Wide>{{0, 0}, {3, 4}}), 0);
}

TEST(Primitives, HaveTextbookCentroids) {
    EXPECT_EQ(centroidOf(BasicCircle<Wide>{2, {3, 4}}), (WideVec{3, 4}));
    EXPECT_EQ(centroidOf(BasicAabb<Wide>{{1, 2}, {4, 6}}), (WideVec{2.5L, 4}));
    EXPECT_EQ(centroidOf(diamond()), (WideVec{1, 1}));
    EXPECT_EQ(centroidOf(squareFromOrigin()), (WideVec{1, 1}));
    EXPECT_TRUE(near(centroidOf(BasicPolygon<Wide>{{{0, 0}, {3, 0}, {0, 3}}}), WideVec{1, 1},
                     kDozenRoundings));
    EXPECT_EQ(centroidOf(BasicPoint<Wide>{{3, 4}}), (WideVec{3, 4}));
    EXPECT_EQ(centroidOf(BasicSegment<Wide>{{0, 0}, {3, 4}}), (WideVec{1.5L, 2}));
}

// pi r^4 / 2, b h (b^2 + h^2) / 12, and for a triangle with legs a: a^4 / 18.
TEST(Primitives, HaveTextbookSecondMoments) {
    EXPECT_TRUE(near(secondMomentOf(BasicCircle<Wide>{2, {3, 4}}), 8 * std::numbers::pi_v<Wide>,
                     8 * kDozenRoundings));
    EXPECT_TRUE(near(secondMomentOf(BasicAabb<Wide>{{1, 2}, {4, 6}}), 25, 10 * kDozenRoundings));
    EXPECT_TRUE(near(secondMomentOf(diamond()), 8 / 3.0L, kDozenRoundings));
    EXPECT_TRUE(near(secondMomentOf(squareFromOrigin()), 8 / 3.0L, 4 * kDozenRoundings));
    EXPECT_TRUE(near(secondMomentOf(BasicPolygon<Wide>{{{0, 0}, {3, 0}, {0, 3}}}), 81 / 18.0L,
                     8 * kDozenRoundings));
}

TEST(Primitives, HaveTightBounds) {
    EXPECT_EQ(boundsOf(BasicPoint<Wide>{{3, 4}}), (BasicAabb<Wide>{{3, 4}, {3, 4}}));
    EXPECT_EQ(boundsOf(BasicCircle<Wide>{2, {3, 4}}), (BasicAabb<Wide>{{1, 2}, {5, 6}}));
    EXPECT_EQ(boundsOf(squareFromOrigin()), (BasicAabb<Wide>{{0, 0}, {2, 2}}));
    EXPECT_EQ(boundsOf(BasicSegment<Wide>{{3, 0}, {0, 4}}), (BasicAabb<Wide>{{0, 0}, {3, 4}}));
    const BasicAabb<Wide> turned = boundsOf(diamond());
    const Wide reach = std::numbers::sqrt2_v<Wide>;
    EXPECT_TRUE(near(turned.lower, WideVec{1 - reach, 1 - reach}, kDozenRoundings));
    EXPECT_TRUE(near(turned.upper, WideVec{1 + reach, 1 + reach}, kDozenRoundings));
}

TEST(Primitives, ContainTheirBoundaryAndNothingOutside) {
    const Wide tiny = 1e-15L;
    EXPECT_TRUE(contains(BasicCircle<Wide>{5, {0, 0}}, WideVec{3, 4}));
    EXPECT_FALSE(contains(BasicCircle<Wide>{5, {0, 0}}, WideVec{3, 4 + tiny}));
    EXPECT_TRUE(contains(squareFromOrigin(), WideVec{2, 1}));
    EXPECT_FALSE(contains(squareFromOrigin(), WideVec{2 + tiny, 1}));
    EXPECT_TRUE(contains(diamond(), WideVec{1, 2.414L}));
    EXPECT_FALSE(contains(diamond(), WideVec{2.01L, 2.01L}));
    EXPECT_TRUE(contains(BasicPlane<Wide>{{0, 1}, 2}, WideVec{1e6L, 2}));
    EXPECT_FALSE(contains(BasicPlane<Wide>{{0, 1}, 2}, WideVec{0, 2 + tiny}));
    const BasicSegment<Wide> segment{{0, 0}, {4, 2}};
    EXPECT_TRUE(contains(segment, WideVec{2, 1}));
    EXPECT_FALSE(contains(segment, WideVec{2, 1 + tiny}));
    EXPECT_FALSE(contains(segment, WideVec{6, 3})) << "in line, but beyond the end";
    EXPECT_TRUE(contains(BasicPoint<Wide>{{1, 2}}, WideVec{1, 2}));
}

TEST(Primitives, SupportIsTheFarthestPointAlongADirection) {
    EXPECT_EQ(supportOf(BasicPoint<Wide>{{1, 2}}, WideVec{5, 5}), (WideVec{1, 2}));
    EXPECT_TRUE(near(supportOf(BasicCircle<Wide>{5, {1, 1}}, WideVec{6, 8}), WideVec{4, 5},
                     kDozenRoundings));
    EXPECT_EQ(supportOf(squareFromOrigin(), WideVec{1, 2}), (WideVec{2, 2}));
    EXPECT_EQ(supportOf(squareFromOrigin(), WideVec{0, 1}), (WideVec{2, 2}))
        << "in a tie the first corner";
    EXPECT_EQ(supportOf(BasicAabb<Wide>{{1, 2}, {4, 6}}, WideVec{-1, 2}), (WideVec{1, 6}));
    EXPECT_TRUE(near(supportOf(diamond(), WideVec{0, 1}),
                     WideVec{1, 1 + std::numbers::sqrt2_v<Wide>}, kDozenRoundings));
    EXPECT_EQ(supportOf(BasicSegment<Wide>{{0, 0}, {3, 4}}, WideVec{-1, 0}), WideVec{});
}

// P1: no contained point lies beyond the support, and the bounds contain it.
TEST(Primitives, ContainmentAgreesWithSupportAndBounds) {
    support::RandomNumbers random(141);
    for (int i = 0; i < 10000; ++i) {
        const Polygon polygon = support::randomPolygon(random, 3 + random.below(14));
        const Box box{random.between(0.2, 3), random.between(0.2, 3), random.point(0.5),
                      random.rotation()};
        const Vec2 p = random.point(2);
        const Vec2 direction = random.point(1);
        const auto expectConsistent = [&](const auto& shape) {
            if (contains(shape, p)) {
                EXPECT_LE(dot(direction, p),
                          dot(direction, supportOf(shape, direction)) + 8 * support::kEpsilon);
                EXPECT_TRUE(boundsOf(shape).grown(8 * support::kEpsilon).contains(p));
            }
        };
        expectConsistent(polygon);
        expectConsistent(box);
        expectConsistent(Circle{box.width, box.center});
        EXPECT_TRUE(near(areaOf(polygonOf(box)), areaOf(box), 32 * support::kEpsilon));
        EXPECT_TRUE(
            near(secondMomentOf(polygonOf(box)), secondMomentOf(box), 256 * support::kEpsilon));
    }
}

} // namespace
} // namespace kodo
