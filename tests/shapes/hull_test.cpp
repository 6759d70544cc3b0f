// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo/measure.hpp>
#include <support/every_shape.hpp>
#include <support/near.hpp>

#include "collide/sat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace kodo {
namespace {

using support::near;

std::string problemOf(const std::vector<Vec2>& points) {
    const auto hull = convexHull(points);
    const auto* problem = std::get_if<Problem>(&hull);
    return problem == nullptr ? "" : problem->text();
}

std::vector<Vec2> cloud(support::RandomNumbers& random, std::size_t count) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(random.point(2));
    }
    return points;
}

bool isAPoint(const std::vector<Vec2>& points, Vec2 p) {
    return std::find(points.begin(), points.end(), p) != points.end();
}

/// By brute force: p is a corner if all other points are strictly on one side of some line through
/// it.
std::size_t countCorners(const std::vector<Vec2>& points) {
    std::size_t corners = 0;
    for (const Vec2 p : points) {
        // The widest gap between the directions to the other points is then more than pi.
        std::vector<double> angles;
        for (const Vec2 q : points) {
            if (q != p) {
                angles.push_back(
                    std::atan2(static_cast<double>(q.y - p.y), static_cast<double>(q.x - p.x)));
            }
        }
        std::sort(angles.begin(), angles.end());
        double widest = angles.front() + 2 * std::numbers::pi - angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i) {
            widest = std::max(widest, angles[i] - angles[i - 1]);
        }
        corners += widest > std::numbers::pi + 1e-3 ? 1u : 0u;
    }
    return corners;
}

// P3: every corner is one of the points, every point is inside, and no corner is missing.
TEST(ConvexHull, AgreesWithBruteForce) {
    support::RandomNumbers random(171);
    int hulls = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::vector<Vec2> points = cloud(random, 3 + random.below(20));
        const auto hull = convexHull(points);
        if (!std::holds_alternative<Polygon>(hull)) {
            continue; // three nearly collinear points
        }
        ++hulls;
        const Polygon& polygon = std::get<Polygon>(hull);
        ASSERT_FALSE(check(Primitive(polygon)));
        for (const Vec2 corner : polygon.corners) {
            ASSERT_TRUE(isAPoint(points, corner));
        }
        // An omitted flat corner may protrude by its height.
        const Real slack = 8 * kFlatness * 4;
        for (const Vec2 p : points) {
            for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
                const Vec2 from = polygon.corners[k];
                const Vec2 to = polygon.corners[(k + 1) % polygon.corners.size()];
                ASSERT_GT(cross(normalize(to - from), p - from), -slack);
            }
        }
        ASSERT_GE(polygon.corners.size(), countCorners(points));
    }
    EXPECT_GE(hulls, 1999); // of 3 points in 4 x 4 m one in 1e5 is flat by kFlatness
}

TEST(ConvexHull, DropsDuplicatesAndCollinearPoints) {
    const std::vector<Vec2> points{{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 1}, {2, 1}};
    const auto hull = convexHull(points);
    ASSERT_TRUE(std::holds_alternative<Polygon>(hull));
    EXPECT_EQ(std::get<Polygon>(hull).corners, (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

// P3: a bulge below the flatness limit of polygons is no corner, so the hull is a valid polygon.
TEST(ConvexHull, DropsNearlyCollinearPoints) {
    const Real bulge = kFlatness / 10;
    const auto hull =
        convexHull(std::vector<Vec2>{{0, 0}, {1, -bulge}, {2, 0}, {2 + bulge, 1}, {2, 2}, {0, 2}});
    ASSERT_TRUE(std::holds_alternative<Polygon>(hull));
    EXPECT_EQ(std::get<Polygon>(hull).corners, (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

// P3: points in a needle are refused. No hull leaves out the point of the needle, which is
// farthest.
TEST(ConvexHull, RefusesNeedlesWhateverTheirDirection) {
    const Real far = sizeof(Real) == 4 ? Real(1e8) : Real(1e12);
    for (int turn = 0; turn < 64; ++turn) {
        const Rot rotation = Rot::fromAngle(static_cast<Real>(turn) / 10);
        std::vector<Vec2> points{{-1, -5}, {-7, -5}, {-5, -5}, {-far, 5}, {5, 5}};
        for (Vec2& point : points) {
            point = rotation * point;
        }
        EXPECT_TRUE(std::holds_alternative<Problem>(convexHull(points))) << turn;
        EXPECT_TRUE(std::holds_alternative<Problem>(fitBox(points))) << turn;
    }
}

TEST(ConvexHull, DoesNotDependOnTheOrderOfThePoints) {
    support::RandomNumbers random(172);
    std::vector<Vec2> points = cloud(random, 30);
    const auto first = convexHull(points);
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(std::get<Polygon>(first), std::get<Polygon>(convexHull(points)));
}

// P3: named errors.
TEST(ConvexHull, RefusalNamesTheReason) {
    EXPECT_EQ(problemOf({}), "points: must contain at least 3 distinct ones, but contain 0");
    EXPECT_EQ(problemOf({{1, 1}, {2, 2}, {1, 1}, {2, 2}}),
              "points: must contain at least 3 distinct ones, but contain 2");
    EXPECT_EQ(problemOf({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), "points: lie on one line, to rounding");
    const bool isFloat = sizeof(Real) == 4;
    const std::string beyond = std::string("must be from ") +
                               (isFloat ? "-1e+11 to 1e+11" : "-1e+19 to 1e+19") + " m, but is ";
    EXPECT_EQ(problemOf({{0, 0}, {1, 1}, {0, std::numeric_limits<Real>::infinity()}}),
              "points[2]: y " + beyond + "inf");
    const Real far = 2 * kMaxLength;
    EXPECT_EQ(problemOf({{0, 0}, {far, 0}, {0, far}}),
              "points[1]: x " + beyond + (isFloat ? "2e+11" : "2e+19"));
}

TEST(ConvexHull, IsRefusedAboveTheMaximumNumberOfCorners) {
    std::vector<Vec2> points;
    for (int i = 0; i < 3000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 3000;
        points.push_back({static_cast<Real>(std::cos(angle)), static_cast<Real>(std::sin(angle))});
    }
    EXPECT_EQ(problemOf(points), "points: have a hull of 3000 corners; a polygon has at most 1024");
}

/// Area of the box around points, in a frame rotated by `angle` (rad).
double boxArea(const std::vector<Vec2>& points, double angle) {
    double low[2] = {1e9, 1e9};
    double high[2] = {-1e9, -1e9};
    for (const Vec2 p : points) {
        const double x = static_cast<double>(p.x);
        const double y = static_cast<double>(p.y);
        const double at[2] = {x * std::cos(angle) + y * std::sin(angle),
                              y * std::cos(angle) - x * std::sin(angle)};
        for (int k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], at[k]);
            high[k] = std::max(high[k], at[k]);
        }
    }
    return (high[0] - low[0]) * (high[1] - low[1]);
}

// P2: no orientation in steps of a tenth of a degree has a smaller box. The box contains all
// points.
TEST(FitBox, IsTheSmallestOfAllOrientations) {
    support::RandomNumbers random(173);
    for (int i = 0; i < 300; ++i) {
        const std::vector<Vec2> points = cloud(random, 5 + random.below(20));
        const auto fitted = fitBox(points);
        ASSERT_TRUE(std::holds_alternative<Box>(fitted));
        const Box& box = std::get<Box>(fitted);
        ASSERT_FALSE(check(Primitive(box)));
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 900; ++k) {
            least = std::min(least, boxArea(points, k * std::numbers::pi / 1800));
        }
        const double area = static_cast<double>(areaOf(box));
        ASSERT_LE(area, least * (1 + 1e-5));
        ASSERT_GT(area, least * 0.99) << "a tenth of a degree misses less than 1 %";
        Box grown = box;
        const Real slack = support::byPrecision(1e-4, 1e-9);
        grown.width += slack;
        grown.height += slack;
        for (const Vec2 p : points) {
            ASSERT_TRUE(contains(grown, p));
        }
    }
}

TEST(FitBox, RecoversARotatedBox) {
    const Box box{3, 1, {5, -2}, Rot::fromAngle(Real(0.7))};
    const auto fitted = fitBox(polygonOf(box).corners);
    const Real tolerance = support::byPrecision(4e-6, 1e-14);
    EXPECT_TRUE(near(areaOf(std::get<Box>(fitted)), 3, tolerance));
    EXPECT_TRUE(near(std::get<Box>(fitted).center, box.center, tolerance));
}

TEST(FitBox, RefusalNamesTheField) {
    const auto fitted = fitBox(std::vector<Vec2>{{1, 1}, {1, 1}});
    ASSERT_TRUE(std::holds_alternative<Problem>(fitted));
    EXPECT_EQ(std::get<Problem>(fitted).field, "points");
}

// P4: the same shape, with the sharpest corner first and the smallest bounds.
TEST(Arrange, KeepsTheShapeAndPutsTheSharpestCornerFirst) {
    support::RandomNumbers random(174);
    for (int i = 0; i < 500; ++i) {
        const Polygon polygon = support::randomPolygon(random, 3 + random.below(14));
        const Arranged arranged = arrange(polygon);
        const auto& corners = arranged.polygon.corners;
        ASSERT_EQ(corners.size(), polygon.corners.size());
        const auto place = [&](std::size_t k) { return arranged.back * corners[k]; };
        std::size_t start = 0;
        while (start < corners.size() && length(polygon.corners[start] - place(0)) > Real(1e-5)) {
            ++start;
        }
        ASSERT_LT(start, corners.size());
        for (std::size_t k = 0; k < corners.size(); ++k) {
            ASSERT_TRUE(near(place(k), polygon.corners[(start + k) % corners.size()], 1e-5));
        }
        const auto sharpness = [&](std::size_t k) {
            const std::size_t n = corners.size();
            const Vec2 before = normalize(corners[(k + n - 1) % n] - corners[k]);
            return dot(before, normalize(corners[(k + 1) % n] - corners[k]));
        };
        for (std::size_t k = 1; k < corners.size(); ++k) {
            ASSERT_LE(sharpness(k), sharpness(0) + 64 * support::kEpsilon);
        }
        ASSERT_LE(areaOf(boundsOf(arranged.polygon)),
                  areaOf(boundsOf(polygon)) * (1 + 64 * support::kEpsilon));
    }
}

int climbingSteps(const Polygon& polygon, support::RandomNumbers random) {
    const ConvexShape convex = convexShapeOf(polygon, {});
    int steps = 0;
    for (int i = 0; i < 500; ++i) {
        steps += climbToSupport(convex, random.rotation().xAxis(), 0).steps;
    }
    return steps;
}

// P4: a climb from the first corner to the extreme one takes fewer steps, summed over random
// polygons and directions.
TEST(Arrange, ShortensHillClimbs) {
    support::RandomNumbers random(175);
    int before = 0;
    int after = 0;
    for (int i = 0; i < 400; ++i) {
        // Drops: a tip and a round end. The list of corners starts at a random one.
        Polygon polygon{{{3, 0}}};
        const int count = 6 + static_cast<int>(random.below(8));
        for (int k = 0; k < count; ++k) {
            const Real angle =
                Real(1.2) + static_cast<Real>(k) * (Real(3.9) / static_cast<Real>(count - 1));
            polygon.corners.push_back(Rot::fromAngle(angle).xAxis());
        }
        const auto shift = static_cast<std::ptrdiff_t>(random.below(polygon.corners.size()));
        std::rotate(polygon.corners.begin(), polygon.corners.begin() + shift,
                    polygon.corners.end());
        ASSERT_FALSE(check(Primitive(polygon)));
        before += climbingSteps(polygon, random);
        after += climbingSteps(arrange(polygon).polygon, random);
    }
    EXPECT_LT(static_cast<double>(after), 0.95 * static_cast<double>(before))
        << after << " steps instead of " << before;
    RecordProperty("steps", after);
    RecordProperty("stepsUnarranged", before);
}

} // namespace
} // namespace kodo
