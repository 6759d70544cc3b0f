// SPDX-License-Identifier: MIT
#include <kodo/convex_shape.hpp>
#include <kodo/measure.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

#include <limits>

namespace kodo {
namespace {

using support::near;

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

std::string fieldOf(const Shape& shape) {
    const std::optional<Problem> problem = check(shape);
    return problem ? problem->field : "";
}

Segment segment(Vec2 from, Vec2 to) {
    return {from, to};
}

// P1: a refusal names the invalid field.
TEST(ShapeKinds, RefusalsNameTheField) {
    EXPECT_EQ(fieldOf(Point{{0, kInfinity}}), "position");
    EXPECT_EQ(fieldOf(segment({kInfinity, 0}, {1, 0})), "from");
    EXPECT_EQ(fieldOf(segment({1, 0}, {1, 0})), "to");
    EXPECT_EQ(fieldOf(segment({1, 0}, {1, kInfinity})), "to");
    EXPECT_EQ(fieldOf(Plane{{0, 2}, 0}), "normal");
    EXPECT_EQ(fieldOf(Plane{{0, 1}, kInfinity}), "offset");
    EXPECT_EQ(fieldOf(Heightmap{{kInfinity, 0}, 1, {0, 1}}), "origin");
    EXPECT_EQ(fieldOf(Heightmap{{0, 0}, 0, {0, 1}}), "spacing");
    EXPECT_EQ(fieldOf(Heightmap{{-kMaxLength, 0}, 1, {0, 1}}), "spacing");
    EXPECT_EQ(fieldOf(Heightmap{{0, 0}, 1, {0}}), "heights");
    EXPECT_EQ(fieldOf(Heightmap{{0, 0}, 1, {0, 1, kInfinity}}), "heights[2]");
    EXPECT_EQ(fieldOf(Heightmap{{0, 0}, 1, std::vector<Real>(kMaxHeights + 1, 0)}), "heights");
    EXPECT_EQ(fieldOf(Compound{{Point{}, segment({0, 0}, {0, 0})}}), "parts[1].to");
}

TEST(ShapeKinds, ValidShapesAreAccepted) {
    support::RandomNumbers random(161);
    for (int i = 0; i < 1000; ++i) {
        for (const support::AnyKind kind : support::kEveryKind) {
            EXPECT_FALSE(check(support::randomPrimitive(random, kind))) << support::nameOf(kind);
        }
    }
    EXPECT_FALSE(check(Shape(Heightmap{{-5, 2}, Real(0.5), {0, 1, -1}})));
}

// R4: the density of a point is in kg, that of a segment in kg/m.
TEST(ShapeKinds, PointsAndSegmentsHaveTextbookMass) {
    const Mass point = massOf(Point{{1, 2}}, Real(3));
    EXPECT_EQ(point.mass, 3);
    EXPECT_EQ(point.inertia, 0);
    EXPECT_EQ(point.center, (Vec2{1, 2}));
    const Mass rod = massOf(segment({0, 0}, {3, 4}), Real(2));
    EXPECT_EQ(rod.mass, 10);
    EXPECT_TRUE(near(rod.inertia, 250 / 12.0L, 8 * support::kEpsilon * 20));
    EXPECT_EQ(rod.center, (Vec2{Real(1.5), 2}));
    const Mass both = combine(massOf(Plane{{0, 1}, 2}, Real(1)), massOf(Plane{{0, 1}, 4}, Real(1)));
    EXPECT_EQ(both.mass, 0);
    EXPECT_EQ(both.center, (Vec2{0, 3})) << "the mean of both, not NaN";
}

// F2: cells from left to right.
TEST(ShapeKinds, AHeightmapIsARowOfOneSidedSegments) {
    const std::vector<Primitive> cells = primitivesOf(Shape(Heightmap{{1, 10}, 2, {0, 1, 3}}));
    ASSERT_EQ(cells.size(), 2u);
    EXPECT_EQ(std::get<Segment>(cells[0]), (Segment{{1, 10}, {3, 11}, true}));
    EXPECT_EQ(std::get<Segment>(cells[1]), (Segment{{3, 11}, {5, 13}, true}));
}

TEST(ShapeKinds, OnlyPlanesAndHeightmapsNeedALock) {
    EXPECT_TRUE(needsLock(Shape(Plane{})));
    EXPECT_TRUE(needsLock(Shape(Heightmap{{0, 0}, 1, {0, 0}})));
    EXPECT_TRUE(needsLock(Shape(Compound{{Circle{1}, Plane{}}})));
    EXPECT_FALSE(needsLock(Shape(Compound{{Circle{1}, Point{}}})));
    EXPECT_FALSE(needsLock(Shape(segment({0, 0}, {1, 0}))));
}

// The half-plane is solid below its surface. Its bounds cover it as far as finite bounds can.
TEST(ShapeKinds, APlaneHasFiniteBoundsUpToItsSurface) {
    const ConvexShape plane = convexShapeOf(Plane{{0, 1}, 2}, {});
    const Aabb up = boundsOf(plane, {{5, 1}, {}});
    EXPECT_EQ(up.upper, (Vec2{kPlaneExtent, 3}));
    EXPECT_EQ(up.lower, (Vec2{-kPlaneExtent, -kPlaneExtent}));
    const Aabb left = boundsOf(plane, {{5, 1}, {0, 1}}); // rotated: its normal is (-1, 0)
    EXPECT_EQ(left.lower, (Vec2{3, -kPlaneExtent}));
    EXPECT_EQ(left.upper, (Vec2{kPlaneExtent, kPlaneExtent}));
    support::RandomNumbers random(162);
    for (int i = 0; i < 10000; ++i) {
        const ConvexShape any =
            convexShapeOf(support::randomPrimitive(random, support::AnyKind::Plane), {});
        const Transform t = random.pose(10);
        const Vec2 p = random.point(20);
        if (contains(any, t, p)) {
            ASSERT_TRUE(boundsOf(any, t).contains(p));
        }
    }
}

// Moving the primitive is equivalent to a pose of the shape.
TEST(ShapeKinds, AMovedShapeAgreesWithAPlacedShape) {
    support::RandomNumbers random(163);
    const Real tolerance = support::byPrecision(4e-6, 1e-14); // up to 6 m, a few roundings
    for (int i = 0; i < 2000; ++i) {
        for (const support::AnyKind kind : support::kEveryKind) {
            const Primitive primitive = support::randomPrimitive(random, kind);
            const Transform t = random.pose(4);
            const ConvexShape placed = convexShapeOf(primitive, {});
            const ConvexShape movedOne = convexShapeOf(moved(primitive, t), {});
            ASSERT_EQ(placed.vertices.size(), movedOne.vertices.size());
            ASSERT_EQ(placed.oneSided, movedOne.oneSided);
            for (std::size_t k = 0; k < placed.normals.size(); ++k) {
                ASSERT_TRUE(
                    near(t.rotation * placed.normals[k], movedOne.normals[k], 16 * tolerance));
                const Vec2 gap = t * placed.vertices[k] - movedOne.vertices[k];
                ASSERT_TRUE(near(dot(movedOne.normals[k], gap), 0, tolerance));
            }
        }
    }
}

TEST(ShapeKinds, ALineContainsOnlyItself) {
    const ConvexShape line = convexShapeOf(segment({-1, 0}, {1, 0}), {});
    EXPECT_TRUE(contains(line, {}, {Real(0.5), 0}));
    EXPECT_FALSE(contains(line, {}, {Real(0.5), Real(1e-6)}));
    EXPECT_FALSE(contains(line, {}, {Real(1.5), 0}));
}

TEST(ShapeKinds, APrimitiveAsAShapeIsTheSame) {
    support::RandomNumbers random(9);
    for (const support::AnyKind kind : support::kEveryKind) {
        const Primitive primitive = support::randomPrimitive(random, kind);
        EXPECT_EQ(primitivesOf(shapeOf(primitive)), std::vector<Primitive>{primitive});
    }
}

} // namespace
} // namespace kodo
