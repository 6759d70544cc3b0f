// SPDX-License-Identifier: MIT
#include <support/near.hpp>
#include <support/random_shapes.hpp>

#include "collide/sat.hpp"

#include <numbers>

namespace kodo::sat_test {
namespace {

Real linearSupport(const ConvexShape& convex, Vec2 direction) {
    Real best = dot(direction, convex.vertices[0]);
    for (const Vec2 vertex : convex.vertices) {
        best = std::max(best, dot(direction, vertex));
    }
    return best;
}

// C3: the climb finds the same height as a search of all corners, from any start.
TEST(SupportVertex, ClimbFindsTheExtremeVertexOfRandomPolygons) {
    support::RandomNumbers random(61);
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE(i);
        const std::size_t corners = 3 + random.below(62);
        const ConvexShape convex =
            convexShapeOf(support::randomPolygon(random, corners), random.point(2));
        for (int k = 0; k < 8; ++k) {
            const Vec2 direction = random.rotation().xAxis();
            const std::size_t found = supportVertex(convex, direction, random.below(corners));
            ASSERT_LT(found, corners);
            // Neighbours that differ by a rounding are equally valid.
            ASSERT_TRUE(support::near(dot(direction, convex.vertices[found]),
                                      linearSupport(convex, direction), 8 * support::kEpsilon));
        }
    }
}

// The climb must not stop at the first corner of a level edge if the edge rises later, nor loop.
TEST(SupportVertex, ClimbEndsOnALevelEdge) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    for (std::size_t start = 0; start < 4; ++start) {
        for (const Vec2 normal : box.normals) {
            const std::size_t found = supportVertex(box, normal, start);
            EXPECT_EQ(dot(normal, box.vertices[found]), 1);
        }
    }
}

TEST(LeastPenetratingFace, FacesTheOtherShape) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const FaceAxis axis = leastPenetratingFace(box, box, {{3, Real(0.5)}, {}}, 100);
    EXPECT_EQ(axis.face, 1u); // the right one
    EXPECT_EQ(axis.separation, 1);
}

TEST(LeastPenetratingFace, IsTheFaceOfLowestIndexInATie) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    EXPECT_EQ(leastPenetratingFace(box, box, {}, 100).face, 0u);
    EXPECT_EQ(leastPenetratingFace(box, box, {}, 100).separation, -2);
}

// C2: a face separated by more than the margin is sufficient, and the search stops there.
TEST(LeastPenetratingFace, StopsAtASeparatingFace) {
    std::vector<Vec2> corners;
    for (int i = 0; i < 16; ++i) {
        corners.push_back(
            Rot::fromAngle((static_cast<Real>(i) + Real(0.5)) * std::numbers::pi_v<Real> / 8) *
            Vec2{1, 0});
    }
    const ConvexShape round = convexShapeOf(Polygon{corners}, {});
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    const Transform place{{5, 0}, {}};
    const FaceAxis any = leastPenetratingFace(round, box, place, 0);
    const FaceAxis most = leastPenetratingFace(round, box, place, 100);
    EXPECT_GT(any.separation, 0);
    EXPECT_LT(any.separation, most.separation);
    EXPECT_NEAR(most.separation, 4 - Rot::fromAngle(std::numbers::pi_v<Real> / 16).c,
                4 * support::kEpsilon);
}

// C2, counted: for separated polygons the search tests the faces in order up to the first
// separating one. On average these are less than half of the faces.
TEST(LeastPenetratingFace, VisitsFewerThanHalfOfTheFacesOfSeparatedShapes) {
    support::RandomNumbers random(62);
    std::size_t seen = 0;
    std::size_t all = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::size_t corners = ConvexShape::kFew + 1 + random.below(32);
        const ConvexShape a = convexShapeOf(support::randomPolygon(random, corners), {});
        const ConvexShape b = convexShapeOf(support::randomPolygon(random, corners), {});
        const Transform place{Real(6) * random.rotation().xAxis(), random.rotation()};
        const FaceAxis first = leastPenetratingFace(a, b, place, 0);
        if (first.separation > 0) {
            seen += first.face + 1;
            all += corners;
        }
    }
    EXPECT_GT(all, 10000u);
    EXPECT_LT(2 * seen, all);
}

} // namespace
} // namespace kodo::sat_test
