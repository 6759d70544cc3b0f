// SPDX-License-Identifier: MIT
#include <kodo/convex_shape.hpp>
#include <support/convex_oracle.hpp>
#include <support/near.hpp>
#include <support/random_shapes.hpp>

#include <algorithm>
#include <cmath>

namespace kodo {
namespace {

using support::byPrecision;
using support::near;

// Coordinates up to 10 m, a dozen roundings.
constexpr Real kTolerance = byPrecision(1e-5, 1e-14);

TEST(ConvexShape, OfACircleIsOneVertexWithARadius) {
    const ConvexShape convex = convexShapeOf(Circle{2, {1, 1}}, {1, 0});
    EXPECT_TRUE(convex.isRound());
    EXPECT_EQ(convex.vertices[0], (Vec2{0, 1}));
    EXPECT_TRUE(convex.normals.empty());
    EXPECT_EQ(convex.boundingRadius, 3);
    EXPECT_EQ(convex.rotationReach(), 3);
    EXPECT_EQ(convex.coreRadius, 2);
}

TEST(ConvexShape, OfABoxHasItsFourCorners) {
    const ConvexShape convex = convexShapeOf(Box{4, 2, {1, 0}}, {});
    const std::vector<Vec2> corners{{-1, -1}, {3, -1}, {3, 1}, {-1, 1}};
    EXPECT_EQ(std::vector<Vec2>(convex.vertices.begin(), convex.vertices.end()), corners);
    const std::vector<Vec2> normals{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    EXPECT_EQ(std::vector<Vec2>(convex.normals.begin(), convex.normals.end()), normals);
    EXPECT_EQ(convex.coreRadius, 1);
    EXPECT_TRUE(near(convex.boundingRadius, std::sqrt(10.0L), 4 * support::kEpsilon));
}

TEST(ConvexShape, OfARotatedBoxIsRotated) {
    const ConvexShape convex = convexShapeOf(Box{4, 2, {}, {0, 1}}, {});
    EXPECT_EQ(convex.vertices[0], (Vec2{1, -2}));
    EXPECT_EQ(convex.normals[0], (Vec2{1, 0}));
}

TEST(ConvexShape, NormalsPointOutward) {
    support::RandomNumbers random(31);
    for (int i = 0; i < 1000; ++i) {
        const ConvexShape convex =
            convexShapeOf(support::randomPolygon(random, 3 + random.below(60)), random.point(5));
        const std::size_t n = convex.vertices.size();
        for (std::size_t k = 0; k < n; ++k) {
            ASSERT_TRUE(near(length(convex.normals[k]), 1, 4 * support::kEpsilon));
            for (const Vec2 vertex : convex.vertices) {
                ASSERT_LE(dot(convex.normals[k], vertex - convex.vertices[k]), kTolerance);
            }
        }
        for (const Vec2 vertex : convex.vertices) {
            ASSERT_LE(length(vertex), convex.boundingRadius * (1 + 4 * support::kEpsilon));
        }
    }
}

// The support point along any axis moves by at most that. A disc about its own centre does not
// move.
TEST(ConvexShape, RotationMovesItByAtMostItsRotationReachTimesTheAngle) {
    support::RandomNumbers random(35);
    int still = 0;
    for (int i = 0; i < 2000; ++i) {
        const support::Kind kind = support::kAllKinds[random.below(3)];
        const Primitive primitive = support::randomPrimitive(random, kind);
        const bool inTheMiddle = random.below(4) == 0;
        const Vec2 origin =
            inTheMiddle ? convexShapeOf(primitive, {}).vertices[0] : random.point(2);
        const ConvexShape convex = convexShapeOf(primitive, origin);
        const Real angle = random.between(-0.5, 0.5);
        const Rot turned = random.rotation();
        const Aabb before = boundsOf(convex, {{}, turned});
        const Aabb after = boundsOf(convex, {{}, Rot::fromAngle(angle) * turned});
        const Real way = convex.rotationReach() * std::abs(angle) + kTolerance;
        ASSERT_TRUE(before.grown(way).contains(after));
        ASSERT_TRUE(after.grown(way).contains(before));
        still += convex.rotationReach() == 0 ? 1 : 0;
    }
    EXPECT_GT(still, 100);
    EXPECT_LT(still, 300);
}

// P1: contains, against the distance to the edge. Within 1e-4 m of the edge either answer is valid.
TEST(ConvexShape, ContainsPointsInside) {
    support::RandomNumbers random(32);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const support::Kind kind = support::kAllKinds[random.below(3)];
        const ConvexShape convex = convexShapeOf(support::randomPrimitive(random, kind), {});
        const Transform pose = random.pose(5);
        const Vec2 point = pose.position + random.point(2);
        const support::Outline outline = support::outlineOf(convex, pose);
        const long double distance =
            convex.isRound() ? length(support::toLong(point) - outline.corners[0]) - outline.radius
                             : support::signedDistance(outline, support::toLong(point));
        if (std::abs(distance) > 1e-4L) {
            ASSERT_EQ(contains(convex, pose, point), distance < 0)
                << support::nameOf(kind) << " " << i << ", distance " << distance;
            inside += distance < 0 ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 2000);
}

TEST(ConvexShape, ContainsItsEdge) {
    const ConvexShape box = convexShapeOf(Box{2, 2}, {});
    EXPECT_TRUE(contains(box, {}, {1, 1}));
    EXPECT_TRUE(contains(box, {}, {0, -1}));
    EXPECT_TRUE(contains(convexShapeOf(Circle{2}, {}), {}, {0, 2}));
}

// P1: the smallest bounds that contain the shape.
TEST(ConvexShape, BoundsAreTight) {
    support::RandomNumbers random(33);
    for (int i = 0; i < 5000; ++i) {
        const support::Kind kind = support::kAllKinds[random.below(3)];
        const ConvexShape convex = convexShapeOf(support::randomPrimitive(random, kind), {});
        const Transform pose = random.pose(5);
        const support::Outline outline = support::outlineOf(convex, pose);
        support::LongVec lower = outline.corners[0];
        support::LongVec upper = lower;
        for (const support::LongVec corner : outline.corners) {
            lower = {std::min(lower.x, corner.x), std::min(lower.y, corner.y)};
            upper = {std::max(upper.x, corner.x), std::max(upper.y, corner.y)};
        }
        const support::LongVec skin{outline.radius, outline.radius};
        const Aabb bounds = boundsOf(convex, pose);
        ASSERT_TRUE(near(support::toLong(bounds.lower), lower - skin, kTolerance));
        ASSERT_TRUE(near(support::toLong(bounds.upper), upper + skin, kTolerance));
    }
}

} // namespace
} // namespace kodo
