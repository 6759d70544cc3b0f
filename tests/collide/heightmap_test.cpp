// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include "bodies/line_links.hpp"
#include "collide/time_of_impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kodo::heightmap_test {
namespace {

using support::byPrecision;
using support::LongPoint;
using support::near;

constexpr Real kMargin = Real(1) / 64;
constexpr Real kTolerance = byPrecision(1e-5, 2e-14);
// Sine of the bend below which a vertex counts as flush. A normal may be off by as much there.
constexpr Real kFlush = Real(1e-3);

std::vector<ConvexShape> cellsOf(const Heightmap& map, Vec2 origin = {}) {
    std::vector<Part> parts;
    for (const Primitive& cell : primitivesOf(Shape(map))) {
        parts.push_back({.primitive = cell, .convex = convexShapeOf(cell, origin)});
    }
    linkLines(parts);
    std::vector<ConvexShape> cells;
    for (const Part& part : parts) {
        cells.push_back(part.convex);
    }
    return cells;
}

Heightmap flat(std::size_t heights) {
    return {{0, 0}, 1, std::vector<Real>(heights, 0)};
}

/// Hills and valleys with slopes of up to `steepest`.
Heightmap hills(support::RandomNumbers& random, double steepest) {
    Heightmap map{{0, 0}, Real(0.5), {0}};
    for (int i = 0; i < 24; ++i) {
        map.heights.push_back(map.heights.back() +
                              map.spacing * random.between(-steepest, steepest));
    }
    return map;
}

/// Signed distance of a point from the ground, negative below.
long double heightOver(const std::vector<ConvexShape>& cells, LongPoint p) {
    long double nearest = std::numeric_limits<long double>::infinity();
    bool below = false;
    for (const ConvexShape& cell : cells) {
        const LongPoint from = support::widened(cell.vertices[0]);
        const LongPoint to = support::widened(cell.vertices[1]);
        nearest = std::min(nearest, support::toSegment(p, from, to));
        if (from.x <= p.x && p.x <= to.x) {
            below = cross(to - from, p - from) < 0;
        }
    }
    return below ? -nearest : nearest;
}

/// The deepest contact of a shape with any cell.
Manifold deepest(const std::vector<ConvexShape>& cells, const ConvexShape& other,
                 const Transform& at, Real margin) {
    Manifold best;
    for (const ConvexShape& cell : cells) {
        const Manifold manifold = collide(cell, {}, other, at, margin, 0);
        if (manifold.count > 0 &&
            (best.count == 0 || manifold.points[0].separation < best.points[0].separation)) {
            best = manifold;
        }
    }
    return best;
}

// F2: a ball at 10,000 random places touches exactly as the ground as a whole does. The normal
// points away from the nearest point of the ground.
TEST(HeightmapContact, OfABallAgreesWithTheWholeGround) {
    support::RandomNumbers random(131);
    int touching = 0;
    for (int i = 0; i < 10000 && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "place " << i);
        const std::vector<ConvexShape> cells = cellsOf(hills(random, 2));
        const ConvexShape ball = convexShapeOf(Circle{random.between(0.1, 1)}, {});
        const ConvexShape& cell = cells[4 + random.below(cells.size() - 8)];
        const Transform at{cell.middle + random.between(0, 1) * ball.radius * cell.normals[1] +
                               random.point(0.2),
                           random.rotation()};
        const long double height = heightOver(cells, support::widened(at.position));
        if (height < static_cast<long double>(kTolerance)) {
            continue; // its centre is below the ground: it passes
        }
        const long double gap = height - static_cast<long double>(ball.radius);
        const Manifold manifold = deepest(cells, ball, at, kMargin);
        if (std::abs(gap - static_cast<long double>(kMargin)) > 1e-5L) {
            ASSERT_EQ(manifold.count > 0, gap < static_cast<long double>(kMargin)) << gap;
        }
        if (manifold.count > 0) {
            ASSERT_TRUE(near(manifold.points[0].separation, gap, kTolerance));
            const Vec2 below =
                at.position - (ball.radius + manifold.points[0].separation) * manifold.normal;
            ASSERT_TRUE(near(heightOver(cells, support::widened(below)), 0, kTolerance));
            ++touching;
        }
    }
    EXPECT_GT(touching, 3000);
}

/// True if the segments ab and cd meet.
bool meet(const LongPoint& a, const LongPoint& b, const LongPoint& c, const LongPoint& d) {
    return cross(b - a, c - a) * cross(b - a, d - a) <= 0 &&
           cross(d - c, a - c) * cross(d - c, b - c) <= 0;
}

/// Distance of a core above the ground; negative if they cross or the core is below.
long double coreGap(const std::vector<ConvexShape>& cells, const ConvexShape& core,
                    const Transform& at) {
    long double nearest = std::numeric_limits<long double>::infinity();
    const std::size_t n = core.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
        const LongPoint p = support::widened(at * core.vertices[i]);
        const LongPoint q = support::widened(at * core.vertices[(i + 1) % n]);
        if (heightOver(cells, p) <= 0) {
            return -1;
        }
        for (const ConvexShape& cell : cells) {
            const LongPoint from = support::widened(cell.vertices[0]);
            const LongPoint to = support::widened(cell.vertices[1]);
            if (meet(p, q, from, to)) {
                return -1;
            }
            nearest = std::min({nearest, support::toSegment(p, from, to),
                                support::toSegment(from, p, q), support::toSegment(to, p, q)});
        }
    }
    return nearest;
}

// Regression: capsules, rounded boxes and rounded polygons had no contact with hilltops and free
// ends that their corners were nearest to, sank in by their radius, and passed when they were fast.
TEST(HeightmapContact, OfARoundedShapeAgreesWithTheWholeGround) {
    support::RandomNumbers random(132);
    int touching = 0;
    for (int i = 0; i < 10000 && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "place " << i);
        const std::vector<ConvexShape> cells = cellsOf(hills(random, 1));
        const Real radius = random.between(0.1, 0.4);
        const Real half = random.between(0.1, 0.6);
        const Primitive kinds[] = {Capsule{{-half, 0}, {half, 0}, radius},
                                   Box{half, 2 * half, {}, {}, radius},
                                   Polygon{{{-half, 0}, {half, 0}, {0, half}}, radius}};
        const ConvexShape shape = convexShapeOf(kinds[random.below(3)], {});
        const ConvexShape& cell = cells[6 + random.below(cells.size() - 12)];
        const Transform at{cell.middle + random.between(0, 1) * (half + radius) * cell.normals[1] +
                               random.point(0.2),
                           random.rotation()};
        const long double core = coreGap(cells, shape, at);
        if (core < 0.02L) {
            continue;
        }
        const long double gap = core - static_cast<long double>(radius);
        const Manifold manifold = deepest(cells, shape, at, kMargin);
        // Faces that are parallel within 0.01 rad remain in contact as faces.
        constexpr long double kParallel = 5e-5L;
        if (std::abs(gap - static_cast<long double>(kMargin)) > kParallel) {
            ASSERT_EQ(manifold.count > 0, gap < static_cast<long double>(kMargin)) << gap;
        }
        if (manifold.count > 0) {
            ASSERT_TRUE(near(manifold.points[0].separation, gap, kParallel));
            ++touching;
        }
    }
    EXPECT_GT(touching, 3000);
}

/// True if the ground has this normal: that of a cell, or one between those of two cells at a
/// hilltop.
bool isOfTheGround(const std::vector<ConvexShape>& cells, Vec2 normal) {
    const Real slack = kFlush + kTolerance;
    for (const ConvexShape& cell : cells) {
        const Vec2 own = cell.normals[1];
        const Vec2 before = perp(cell.before);
        if (length(normal - own) < slack) {
            return true;
        }
        if (before != Vec2{} && cross(own, before) > 0 && cross(own, normal) > -slack &&
            cross(normal, before) > -slack && dot(normal, own + before) > 0) {
            return true;
        }
    }
    return false;
}

/// Height of p straight above a line from left to right; +infinity if p is not over it.
long double above(LongPoint p, LongPoint from, LongPoint to) {
    if (p.x < from.x || p.x > to.x || from.x == to.x) {
        return std::numeric_limits<long double>::infinity();
    }
    return p.y - from.y - (p.x - from.x) / (to.x - from.x) * (to.y - from.y);
}

/// Distance by which a polygon can be lowered until it touches the ground.
long double fallOnto(const std::vector<ConvexShape>& cells, const std::vector<LongPoint>& polygon) {
    long double fall = std::numeric_limits<long double>::infinity();
    for (const ConvexShape& cell : cells) {
        const LongPoint from = support::widened(cell.vertices[0]);
        const LongPoint to = support::widened(cell.vertices[1]);
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const LongPoint p = polygon[i];
            const LongPoint q = polygon[(i + 1) % polygon.size()];
            fall = std::min(fall, above(p, from, to));
            // A vertex of the ground below a side of the polygon, mirrored vertically.
            const long double below = -above(from, p.x < q.x ? p : q, p.x < q.x ? q : p);
            fall = std::min(fall,
                            below == -std::numeric_limits<long double>::infinity() ? fall : below);
        }
    }
    return fall;
}

// F2: every contact normal of a shape in any rotation is a normal of the ground. A clear overlap
// always has a contact.
TEST(HeightmapContact, HasOnlyNormalsOfTheGround) {
    support::RandomNumbers random(132);
    int touching = 0;
    for (int i = 0; i < 10000 && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "place " << i);
        const std::vector<ConvexShape> cells = cellsOf(hills(random, 0.5));
        const support::Kind kind = i % 2 == 0 ? support::Kind::Box : support::Kind::Polygon;
        const ConvexShape other = convexShapeOf(support::randomPrimitive(random, kind), {});
        Transform at{{random.between(4, 8), 10}, random.rotation()};
        const Real gap = static_cast<Real>(fallOnto(cells, support::placedCorners(other, at)));
        const Real sunk = random.between(0, 0.01);
        at.position.y -= gap + sunk;
        int found = 0;
        for (const ConvexShape& cell : cells) {
            const Manifold manifold = collide(cell, {}, other, at, kMargin, 0);
            if (manifold.count > 0) {
                ASSERT_TRUE(isOfTheGround(cells, manifold.normal))
                    << manifold.normal.x << ", " << manifold.normal.y;
                // Just past a hilltop a corner is below both lines, and deeper below the previous
                // one: by a factor of at most sqrt(1 + s^2) / (1 - s^2) for slopes s.
                ASSERT_GT(manifold.points[0].separation, Real(-1.5) * sunk - kTolerance);
                ++found;
            }
        }
        ASSERT_GT(found, 0);
        touching += found;
    }
    EXPECT_GT(touching, 10000);
}

// F2: on flat ground every normal points straight up, wherever the box is over the vertices.
TEST(HeightmapContact, OverAFlushVertexPointsStraightUp) {
    const std::vector<ConvexShape> cells = cellsOf(flat(12));
    const ConvexShape shapes[] = {convexShapeOf(Box{1, 1}, {}),
                                  convexShapeOf(Circle{Real(0.5)}, {}),
                                  convexShapeOf(Box{Real(2.5), 1}, {}),
                                  convexShapeOf(Segment{{0, Real(-0.5)}, {0, Real(0.5)}}, {})};
    for (const ConvexShape& shape : shapes) {
        for (int i = 0; i <= 4096; ++i) {
            // 4 to 6 m: over two vertices, and exactly over them; alternately overlapping, touching
            // and near.
            const Real x = 4 + static_cast<Real>(i) / 2048;
            const Real y = Real(0.5) + Real(0.002) * static_cast<Real>(i % 5 - 3);
            int found = 0;
            for (const ConvexShape& cell : cells) {
                const Manifold manifold = collide(cell, {}, shape, {{x, y}, {}}, kMargin, 0);
                if (manifold.count > 0) {
                    ASSERT_EQ(manifold.normal, (Vec2{0, 1})) << x;
                    ASSERT_TRUE(near(manifold.points[0].separation, y - Real(0.5), kTolerance));
                    ++found;
                }
            }
            ASSERT_GT(found, 0) << x;
        }
    }
}

// F2: the time of impact has no ghost impacts at vertices, but is found at a wall of the ground.
TEST(HeightmapContact, TimeOfImpactStopsAtAWallButNotAtAFlushVertex) {
    Heightmap map = flat(12);
    map.heights[11] = 5; // a steep end
    const std::vector<ConvexShape> cells = cellsOf(map);
    const ConvexShape shapes[] = {convexShapeOf(Box{1, 1}, {}),
                                  convexShapeOf(Circle{Real(0.5)}, {})};
    constexpr Real kTarget = Real(1) / 1024;
    for (const ConvexShape& shape : shapes) {
        for (const Real sunk : {Real(0.002), Real(0), Real(-0.002)}) {
            const MotionPath sliding{{{2, Real(0.5) - sunk}, {}}, {7, 0}};
            for (std::size_t i = 3; i + 1 < cells.size(); ++i) {
                EXPECT_GT(timeOfImpact(cells[i], {}, shape, sliding, kTarget), 1) << i;
            }
            EXPECT_GT(timeOfImpact(cells.back(), {}, shape, sliding, kTarget), 1);
            const MotionPath further{{{2, Real(0.5) - sunk}, {}}, {9, 0}};
            EXPECT_LT(timeOfImpact(cells.back(), {}, shape, further, kTarget), 1);
        }
    }
}

// F2: a fast wide box stops at the tip of a hill that hits none of its corners.
TEST(HeightmapContact, TimeOfImpactStopsAtAHilltop) {
    const std::vector<ConvexShape> cells = cellsOf({{-1, 0}, 1, {-2, 0, -2}});
    const ConvexShape box = convexShapeOf(Box{4, Real(0.25)}, {});
    const ConvexShape ball = convexShapeOf(Circle{Real(0.125)}, {});
    constexpr Real kTarget = Real(1) / 1024;
    for (const ConvexShape* shape : {&box, &ball}) {
        const MotionPath falling{{{0, 2}, {}}, {0, -8}};
        Real first = 2;
        for (const ConvexShape& cell : cells) {
            first = std::min(first, timeOfImpact(cell, {}, *shape, falling, kTarget));
        }
        EXPECT_TRUE(near(first, Real(1.875) / 8, kTarget)) << "tunnelled";
    }
}

} // namespace
} // namespace kodo::heightmap_test
