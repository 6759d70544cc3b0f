// SPDX-License-Identifier: MIT
#include <support/random_numbers.hpp>

#include "math/octagon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kodo {
namespace {

/// Corners in no particular order, at a random pose.
struct Placed {
    std::vector<Vec2> corners;
    Transform at;

    Placed(support::RandomNumbers& random, double far) {
        const std::size_t count = 1 + random.below(8);
        for (std::size_t i = 0; i < count; ++i) {
            corners.push_back(random.point(1));
        }
        at = {random.point(far), Rot::fromAngle(random.between(-3, 3))};
    }
    Octagon octagon() const { return Octagon::of(corners, at); }
    /// A mean of the corners with random weights.
    Vec2 pointInside(support::RandomNumbers& random) const {
        Vec2 sum{};
        Real all = 0;
        for (const Vec2 corner : corners) {
            const Real weight = random.between(0.01, 1);
            sum += weight * corner;
            all += weight;
        }
        return at * ((1 / all) * sum);
    }
};

/// True if a world point is inside, up to the rounding of its coordinates.
bool holds(const Octagon& octagon, Vec2 p) {
    const Real rounding =
        2 * std::numeric_limits<Real>::epsilon() * (std::abs(p.x) + std::abs(p.y) + 1);
    return octagon.grown(rounding).contains(Octagon::of(p, 0));
}

TEST(Octagon, ContainsItsPolygonAtAnyPose) {
    support::RandomNumbers random(71);
    for (const double far : {0.0, 10.0, 1e3, 1e5}) {
        SCOPED_TRACE(far);
        for (int i = 0; i < 5000; ++i) {
            const Placed placed(random, far);
            EXPECT_TRUE(holds(placed.octagon(), placed.pointInside(random)));
        }
    }
}

// Each side of the octagon touches a corner, so no smaller octagon contains them.
TEST(Octagon, OfPointsIsTight) {
    support::RandomNumbers random(72);
    for (int i = 0; i < 2000; ++i) {
        const Placed placed(random, 0);
        const Octagon octagon = placed.octagon();
        for (int k = 0; k < 4; ++k) {
            Real least = 10;
            Real largest = -10;
            for (const Vec2 corner : placed.corners) {
                const Vec2 p = placed.at.rotation * corner;
                const Real along[] = {p.x, p.y, p.x + p.y, p.y - p.x};
                least = std::min(least, along[k]);
                largest = std::max(largest, along[k]);
            }
            // sums of four products of numbers up to 1.5, each rounded in another order
            const Real rounding = 16 * std::numeric_limits<Real>::epsilon();
            EXPECT_NEAR(octagon.lower[k], least, rounding);
            EXPECT_NEAR(octagon.upper[k], largest, rounding);
        }
    }
}

TEST(Octagon, OfADiscTouchesItOnAllEightSides) {
    const Octagon octagon = Octagon::of(Vec2{3, -2}, 2);
    for (int eighth = 0; eighth < 8; ++eighth) {
        const Vec2 out = Rot::fromAngle(Real(eighth) * Real(0.785398163)) * Vec2{1, 0};
        EXPECT_TRUE(holds(octagon, Vec2{3, -2} + 2 * out));
        EXPECT_FALSE(holds(octagon, Vec2{3, -2} + Real(2.00001) * out)); // 10 roundings farther
    }
}

// Along the diagonals, which are not unit vectors, the margin counts sqrt(2) times.
TEST(Octagon, GrowsAlongDiagonalsByAtLeastTheMargin) {
    const Octagon octagon = Octagon::of(Vec2{}, 0).grown(1);
    for (const int diagonal : {2, 3}) {
        EXPECT_GE(octagon.upper[diagonal] * octagon.upper[diagonal], 2);
        EXPECT_LT(octagon.upper[diagonal] * octagon.upper[diagonal], Real(2.000001));
        EXPECT_EQ(octagon.lower[diagonal], -octagon.upper[diagonal]);
    }
}

// Polygons with a common point overlap, even far from the origin, where sums are rounded coarsely.
TEST(Octagon, OverlapsIfThePolygonsShareAPoint) {
    support::RandomNumbers random(73);
    for (const double far : {1.0, 1e3, 1e5}) {
        SCOPED_TRACE(far);
        for (int i = 0; i < 5000; ++i) {
            const Placed a(random, far);
            Placed b(random, 0);
            const Vec2 shared = a.pointInside(random);
            b.at.position = shared - b.at.rotation * b.corners[0];
            const Real coordinate = std::numeric_limits<Real>::epsilon() * Real(far + 2);
            EXPECT_TRUE(overlap(a.octagon().grown(4 * coordinate), b.octagon()));
            EXPECT_TRUE(overlap(b.octagon(), a.octagon().grown(4 * coordinate)));
        }
    }
}

// Two squares that stand on a corner beside each other: their boxes overlap, the squares do not.
TEST(Octagon, SeparatesDiagonalNeighboursWhoseBoxesOverlap) {
    const std::vector<Vec2> corners{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const Octagon a = Octagon::of(corners, {{0, 0}, {}});
    EXPECT_FALSE(overlap(a, Octagon::of(corners, {{Real(1.1), 1}, {}})));
    EXPECT_TRUE(overlap(a, Octagon::of(corners, {{1, 1}, {}}))); // touching counts
    EXPECT_TRUE(overlap(a.box(), Octagon::of(corners, {{Real(1.1), 1}, {}}).box()));
}

// O1, O2: octagons made of boxes overlap exactly if the boxes do.
TEST(Octagon, OfABoxOverlapsExactlyWhenTheBoxDoes) {
    support::RandomNumbers random(74);
    const auto box = [&] {
        const Vec2 lower = random.point(3);
        return Aabb{lower, lower + Vec2{random.between(0, 2), random.between(0, 2)}};
    };
    for (int i = 0; i < 10000; ++i) {
        const Aabb a = box();
        const Aabb b = box();
        EXPECT_EQ(overlap(Octagon::of(a), Octagon::of(b)), overlap(a, b));
    }
}

TEST(Octagon, UnitedOverADisplacementContainsThePath) {
    support::RandomNumbers random(75);
    for (int i = 0; i < 5000; ++i) {
        const Placed placed(random, 5);
        const Vec2 move = random.point(3);
        const Octagon from = placed.octagon();
        const Octagon way = unite(from, from.moved(move));
        const Vec2 on = placed.pointInside(random) + random.between(0, 1) * move;
        EXPECT_TRUE(holds(way, on));
        EXPECT_TRUE(way.contains(from));
        EXPECT_TRUE(way.grown(1).contains(way));
        EXPECT_FALSE(way.contains(way.grown(Real(0.01))));
        EXPECT_TRUE(holds(way.grown(1), on + Rot::fromAngle(random.between(-3, 3)) * Vec2{1, 0}));
    }
}

} // namespace
} // namespace kodo
