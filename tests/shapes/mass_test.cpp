// SPDX-License-Identifier: MIT
#include <kodo/measure.hpp>
#include <support/convex_oracle.hpp>
#include <support/near.hpp>
#include <support/random_shapes.hpp>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;
using support::nearShare;

// R4, P1: closed forms, with some ten roundings of the result.
constexpr Real kExact = byPrecision(1e-6, 2e-15);

BasicPolygon<long double> widened(const Polygon& polygon) {
    BasicPolygon<long double> wide;
    for (const Vec2 corner : polygon.corners) {
        wide.corners.push_back(support::toLong(corner));
    }
    return wide;
}

Polygon regular(std::size_t corners, double radius, Vec2 center) {
    Polygon polygon;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / double(corners);
        polygon.corners.push_back(center + Vec2{static_cast<Real>(radius * std::cos(angle)),
                                                static_cast<Real>(radius * std::sin(angle))});
    }
    return polygon;
}

/// Mass by boundary integrals (Green) about the mean corner. The engine sums a triangle fan
/// instead.
BasicMass<long double> greenMass(const BasicPolygon<long double>& polygon, long double density) {
    const std::size_t n = polygon.corners.size();
    support::LongVec middle;
    for (const support::LongVec corner : polygon.corners) {
        middle += corner / static_cast<long double>(n);
    }
    long double area = 0;
    long double second = 0;
    support::LongVec first;
    for (std::size_t i = 0; i < n; ++i) {
        const support::LongVec p = polygon.corners[i] - middle;
        const support::LongVec q = polygon.corners[(i + 1) % n] - middle;
        const long double d = cross(p, q);
        area += d / 2;
        first += d / 6 * (p + q);
        second += d / 12 * (dot(p, p) + dot(p, q) + dot(q, q));
    }
    const support::LongVec center = first / area;
    return {density * area, middle + center, density * (second - area * dot(center, center))};
}

TEST(Mass, OfACircleIsTheClosedForm) {
    const Mass mass = massOf(Circle{2, {5, -3}}, Real(3));
    const long double expected = 12 * std::numbers::pi_v<long double>;
    EXPECT_TRUE(nearShare(mass.mass, expected, kExact));
    EXPECT_TRUE(nearShare(mass.inertia, expected * 2, kExact)); // m r^2 / 2
    EXPECT_EQ(mass.center, (Vec2{5, -3}));
}

TEST(Mass, OfARotatedBoxIsTheClosedForm) {
    const Mass mass = massOf(Box{3, 4, {1, 2}, Rot::fromAngle(Real(0.7))}, Real(2));
    EXPECT_EQ(mass.mass, 24);
    EXPECT_EQ(mass.inertia, 50); // 24 (9 + 16) / 12
    EXPECT_EQ(mass.center, (Vec2{1, 2}));
}

// I = m (a^2 + b^2 + c^2) / 36 with the three sides 3, 4, 5.
TEST(Mass, OfATriangleIsTheClosedForm) {
    const Mass mass = massOf(Polygon{{{0, 0}, {3, 0}, {0, 4}}}, Real(1));
    EXPECT_TRUE(nearShare(mass.mass, 6, kExact));
    EXPECT_TRUE(nearShare(mass.inertia, 6.0L * 50 / 36, kExact));
    EXPECT_TRUE(near(mass.center, Vec2{1, Real(4) / 3}, 2 * kExact));
}

// A = n r^2 sin(2 pi / n) / 2,   I = m r^2 (2 + cos(2 pi / n)) / 6. The corners are rounded too,
// each by half an epsilon of its size.
TEST(Mass, OfARegularPolygonIsTheClosedForm) {
    for (const std::size_t n : {3u, 4u, 5u, 6u, 8u, 17u, 64u, 1000u}) {
        SCOPED_TRACE(n);
        const long double step = 2 * std::numbers::pi_v<long double> / static_cast<long double>(n);
        const long double area = static_cast<long double>(n) * 4 * std::sin(step) / 2;
        const Mass mass = massOf(regular(n, 2, {}), Real(1));
        const Real tolerance = byPrecision(4e-6, 1e-14);
        EXPECT_TRUE(nearShare(mass.mass, area, tolerance));
        EXPECT_TRUE(nearShare(mass.inertia, area * 4 * (2 + std::cos(step)) / 6, tolerance));
        EXPECT_TRUE(near(mass.center, Vec2{}, tolerance));
    }
}

TEST(Mass, OfABoxAsAPolygonIsThatOfTheBox) {
    const Mass box = massOf(Box{3, 2}, Real(5));
    const Mass polygon = massOf(Polygon{{{-1.5, -1}, {1.5, -1}, {1.5, 1}, {-1.5, 1}}}, Real(5));
    EXPECT_TRUE(nearShare(polygon.mass, box.mass, kExact));
    EXPECT_TRUE(nearShare(polygon.inertia, box.inertia, kExact));
}

// R4: the exact integral against another formula in long double, on the same rounded corners.
TEST(Mass, OfRandomPolygonsAgreesWithTheBoundaryIntegral) {
    support::RandomNumbers random(21);
    for (int i = 0; i < 2000; ++i) {
        const Polygon polygon = support::randomPolygon(random, 3 + random.below(30));
        const Mass mass = massOf(polygon, Real(2));
        const BasicMass<long double> exact = greenMass(widened(polygon), 2);
        ASSERT_TRUE(nearShare(mass.mass, exact.mass, 2 * kExact));
        ASSERT_TRUE(nearShare(mass.inertia, exact.inertia, 10 * kExact)); // one subtraction
        ASSERT_TRUE(near(support::toLong(mass.center), exact.center, 2 * kExact));
    }
}

// At 1000 m, a sum about the origin loses six digits of the inertia (an error of 6.9 % in float for
// a hexagon). The oracle uses the same rounded corners, so only the algorithm is measured.
TEST(Mass, KeepsPrecisionAThousandMetresFromTheOrigin) {
    for (const std::size_t n : {3u, 6u, 12u}) {
        SCOPED_TRACE(n);
        const Polygon polygon = regular(n, 1, {1000, -1000});
        const Mass mass = massOf(polygon, Real(1));
        const BasicMass<long double> exact = greenMass(widened(polygon), 1);
        EXPECT_TRUE(nearShare(mass.mass, exact.mass, 2 * kExact));
        EXPECT_TRUE(nearShare(mass.inertia, exact.inertia, 10 * kExact));
        EXPECT_TRUE(near(support::toLong(mass.center), exact.center, 1000 * kExact));
    }
}

// An L of two boxes: 2 x 1 lying, 1 x 1 on its left half. By the parallel axis theorem:
// m = 3, centre (5/6, 5/6), I = 2 (4 + 1)/12 + 2 |d1|^2 + 1 (1 + 1)/12 + 1 |d2|^2.
TEST(Mass, CombinesByTheParallelAxisTheorem) {
    const Mass lying = massOf(Box{2, 1, {1, Real(0.5)}}, Real(1));
    const Mass standing = massOf(Box{1, 1, {Real(0.5), Real(1.5)}}, Real(1));
    const Mass both = combine(lying, standing);
    EXPECT_EQ(both.mass, 3);
    EXPECT_TRUE(near(both.center, Vec2{Real(5) / 6, Real(5) / 6}, kExact));
    const long double d1 = (1.0L / 6) * (1.0L / 6) + (1.0L / 3) * (1.0L / 3);
    const long double d2 = (1.0L / 3) * (1.0L / 3) + (2.0L / 3) * (2.0L / 3);
    EXPECT_TRUE(nearShare(both.inertia, 10.0L / 12 + 2 * d1 + 2.0L / 12 + d2, kExact));
    const Mass other = combine(standing, lying);
    EXPECT_TRUE(nearShare(other.inertia, both.inertia, kExact));
}

TEST(Mass, OfTwoHalvesCombinesToThatOfTheWhole) {
    support::RandomNumbers random(22);
    for (int i = 0; i < 500; ++i) {
        const Polygon whole = support::randomPolygon(random, 5 + random.below(10));
        const std::size_t cut = 2 + random.below(whole.corners.size() - 3);
        const auto at = [&](std::size_t k) {
            return whole.corners.begin() + static_cast<std::ptrdiff_t>(k);
        };
        Polygon left{{at(0), at(cut + 1)}};
        Polygon right{{at(cut), whole.corners.end()}};
        right.corners.push_back(whole.corners[0]);
        const Mass sum = combine(massOf(left, Real(1)), massOf(right, Real(1)));
        const Mass expected = massOf(whole, Real(1));
        ASSERT_TRUE(nearShare(sum.mass, expected.mass, 4 * kExact));
        ASSERT_TRUE(nearShare(sum.inertia, expected.inertia, 10 * kExact));
        ASSERT_TRUE(near(sum.center, expected.center, 4 * kExact));
    }
}

// P1: the same templates in long double are more precise than double.
TEST(Mass, InLongDoubleHasItsPrecision) {
    const BasicMass<long double> disc = massOf(BasicCircle<long double>{1, {}}, 1.0L);
    EXPECT_TRUE(near(disc.mass, std::numbers::pi_v<long double>, 1e-18L));
    EXPECT_TRUE(near(disc.inertia, std::numbers::pi_v<long double> / 2, 1e-18L));
}

} // namespace
} // namespace kodo
