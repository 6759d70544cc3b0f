// SPDX-License-Identifier: MIT
#include <kodo/math.hpp>
#include <support/random_numbers.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace kodo {
namespace {

constexpr Aabb kUnit{{0, 0}, {1, 1}};

TEST(Aabb, ContainsItsEdge) {
    EXPECT_TRUE(kUnit.contains(Vec2{0, 0}));
    EXPECT_TRUE(kUnit.contains(Vec2{1, Real(0.5)}));
    EXPECT_FALSE(kUnit.contains(Vec2{Real(1.001), Real(0.5)}));
    EXPECT_TRUE(kUnit.contains(kUnit));
    EXPECT_FALSE(kUnit.contains(kUnit.grown(Real(0.1))));
}

TEST(Aabb, ReturnsItsCenterAndExtent) {
    const Aabb box{{-1, 2}, {3, 4}};
    EXPECT_EQ(box.center(), (Vec2{1, 3}));
    EXPECT_EQ(box.extent(), (Vec2{4, 2}));
}

TEST(Aabb, TouchingBoxesOverlap) {
    EXPECT_TRUE(overlap(kUnit, {{1, 1}, {2, 2}}));
    EXPECT_TRUE(overlap(kUnit, {{-1, -1}, {2, 2}}));
    EXPECT_FALSE(overlap(kUnit, {{Real(1.001), 0}, {2, 1}}));
    EXPECT_FALSE(overlap(kUnit, {{0, -2}, {1, Real(-0.001)}}));
}

TEST(Aabb, OverlapIsSymmetric) {
    support::RandomNumbers random(11);
    const auto box = [&] {
        const Vec2 lower = random.point(3);
        return Aabb{lower, lower + Vec2{random.between(0, 2), random.between(0, 2)}};
    };
    for (int i = 0; i < 10000; ++i) {
        const Aabb a = box();
        const Aabb b = box();
        EXPECT_EQ(overlap(a, b), overlap(b, a));
        EXPECT_TRUE(unite(a, b).contains(a));
        EXPECT_TRUE(unite(a, b).contains(b));
    }
}

TEST(Aabb, OfPointsIsTight) {
    const std::vector<Vec2> points{{1, 5}, {-2, 3}, {0, 7}};
    EXPECT_EQ(aabbOf(std::span<const Vec2>(points)), (Aabb{{-2, 3}, {1, 7}}));
}

} // namespace
} // namespace kodo
