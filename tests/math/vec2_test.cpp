// SPDX-License-Identifier: MIT
#include <kodo/math.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

#include <type_traits>

namespace kodo {
namespace {

// B1: one template for all number types.
template <typename T>
class Vec2Of : public testing::Test {};
using Numbers = testing::Types<float, double, long double, int>;
TYPED_TEST_SUITE(Vec2Of, Numbers);

TYPED_TEST(Vec2Of, DefaultIsZero) {
    EXPECT_EQ(BasicVec2<TypeParam>{}, (BasicVec2<TypeParam>{0, 0}));
}

TYPED_TEST(Vec2Of, AddsSubtractsAndScales) {
    using V = BasicVec2<TypeParam>;
    V v = V{1, 2} + V{3, -5};
    EXPECT_EQ(v, (V{4, -3}));
    EXPECT_EQ(v - (V{1, 1}), (V{3, -4}));
    EXPECT_EQ(-v, (V{-4, 3}));
    EXPECT_EQ(TypeParam{2} * v, (V{8, -6}));
    EXPECT_EQ(v * TypeParam{2}, (V{8, -6}));
    v += V{1, 1};
    v -= V{0, 2};
    v *= TypeParam{3};
    EXPECT_EQ(v, (V{15, -12}));
}

TYPED_TEST(Vec2Of, HasDotAndCrossProducts) {
    using V = BasicVec2<TypeParam>;
    EXPECT_EQ(dot(V{2, 3}, V{5, -7}), TypeParam{-11});
    EXPECT_EQ(cross(V{2, 3}, V{5, -7}), TypeParam{-29});
    EXPECT_EQ(cross(TypeParam{2}, V{3, 4}), (V{-8, 6}));
    EXPECT_EQ(lengthSquared(V{3, -4}), TypeParam{25});
}

TYPED_TEST(Vec2Of, PerpIsAQuarterTurnCounterClockwise) {
    using V = BasicVec2<TypeParam>;
    EXPECT_EQ(perp(V{1, 0}), (V{0, 1}));
    EXPECT_EQ(perp(perp(V{3, 4})), (V{-3, -4}));
    EXPECT_GT(cross(V{3, 4}, perp(V{3, 4})), TypeParam{0});
}

TEST(Vec2, DividesIntegersTowardsZero) {
    EXPECT_EQ((BasicVec2<int>{7, -9} / 2), (BasicVec2<int>{3, -4}));
}

// B1: 1/49 is not exact, so a product with the reciprocal would round. A quotient must not.
TEST(Vec2, DividesExactlyWhereTheReciprocalWouldRound) {
    for (int i = 1; i < 2000; ++i) {
        const Real divisor = static_cast<Real>(i);
        EXPECT_EQ((3 * divisor) / divisor, 3);
        EXPECT_EQ((Vec2{3 * divisor, -5 * divisor} / divisor), (Vec2{3, -5}));
    }
}

TEST(Vec2, HasEuclideanLength) {
    EXPECT_EQ(length(Vec2{3, -4}), 5);
    EXPECT_EQ(length(Vec2{}), 0);
    EXPECT_EQ(length(BasicVec2<long double>{0.75L, 1}), 1.25L);
}

TEST(Vec2, NormalizesToUnitLength) {
    support::RandomNumbers random(1);
    for (int i = 0; i < 10000; ++i) {
        const Vec2 v = random.point(100);
        if (v == Vec2{}) {
            continue;
        }
        const Vec2 unit = normalize(v);
        // A root, two divisions and a sum of squares: each rounds by half an epsilon.
        EXPECT_TRUE(support::near(length(unit), 1, 4 * support::kEpsilon));
        EXPECT_TRUE(support::near(cross(unit, v), 0, 300 * support::kEpsilon)); // |v| < 142
    }
}

TEST(Vec2, NormalizesTheZeroVectorToItself) {
    EXPECT_EQ(normalize(Vec2{}), Vec2{});
}

TEST(Vec2, IsFiniteOnlyIfBothCoordinatesAre) {
    const Real inf = std::numeric_limits<Real>::infinity();
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_TRUE(isFinite(Vec2{1, -2}));
    EXPECT_FALSE(isFinite(Vec2{inf, 0}));
    EXPECT_FALSE(isFinite(Vec2{0, -inf}));
    EXPECT_FALSE(isFinite(Vec2{0, nan}));
}

TEST(Vec2, WorksInConstantExpressions) {
    static_assert(Vec2{1, 2} + Vec2{3, 4} == Vec2{4, 6});
    static_assert(cross(Vec2{1, 0}, Vec2{0, 1}) == 1);
    static_assert(std::is_trivially_copyable_v<Vec2>);
    static_assert(sizeof(Vec2) == 2 * sizeof(Real));
}

} // namespace
} // namespace kodo
