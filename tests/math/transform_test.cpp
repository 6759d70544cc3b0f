// SPDX-License-Identifier: MIT
#include <kodo/math.hpp>
#include <support/near.hpp>
#include <support/random_numbers.hpp>

namespace kodo {
namespace {

using support::kEpsilon;
using support::near;

TEST(Transform, RotatesBeforeItTranslates) {
    const Transform t{{10, 20}, {0, 1}};
    EXPECT_EQ(t * (Vec2{3, 0}), (Vec2{10, 23}));
    EXPECT_EQ(toLocal(t, Vec2{10, 23}), (Vec2{3, 0}));
}

// Points up to 20 m from the origin: a handful of roundings of 20.
TEST(Transform, ToLocalUndoesToWorld) {
    support::RandomNumbers random(6);
    for (int i = 0; i < 10000; ++i) {
        const Transform t = random.pose(10);
        const Vec2 p = random.point(10);
        EXPECT_TRUE(near(toLocal(t, t * p), p, 100 * kEpsilon));
    }
}

TEST(Transform, ProductAppliesTheRightFactorFirst) {
    support::RandomNumbers random(7);
    for (int i = 0; i < 10000; ++i) {
        const Transform a = random.pose(10);
        const Transform b = random.pose(10);
        const Vec2 p = random.point(10);
        EXPECT_TRUE(near((a * b) * p, a * (b * p), 200 * kEpsilon));
    }
}

TEST(Transform, BetweenIsTheRelativeTransform) {
    support::RandomNumbers random(8);
    for (int i = 0; i < 10000; ++i) {
        const Transform a = random.pose(10);
        const Transform b = random.pose(10);
        const Transform again = a * between(a, b);
        EXPECT_TRUE(near(again.position, b.position, 200 * kEpsilon));
        EXPECT_TRUE(near(again.rotation.c, b.rotation.c, 6 * kEpsilon));
        EXPECT_TRUE(near(again.rotation.s, b.rotation.s, 6 * kEpsilon));
    }
}

} // namespace
} // namespace kodo
