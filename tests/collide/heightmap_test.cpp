// SPDX-License-Identifier: MIT
#include <kodo/collide/collide.hpp>
#include <kodo/collide/time_of_impact.hpp>
#include <support/every_shape.hpp>
#include <support/minkowski_oracle.hpp>
#include <support/near.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kodo {
namespace {

using support::byPrecision;
using support::LongPoint;
using support::near;

constexpr Real kMargin = Real(1) / 64;
constexpr Real kTolerance = byPrecision(1e-5, 2e-14);
// A joint that bends by less than this sine counts as flush: a normal may be off by as much there.
constexpr Real kFlush = Real(1e-3);

std::vector<Convex> cellsOf(const Heightmap& map, Vec2 origin = {}) {
    std::vector<Convex> cells;
    for (const Primitive& cell : primitivesOf(Shape(map))) {
        cells.push_back(convexOf(cell, origin));
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

/// Signed distance of a point from the ground of cells, negative below.
long double heightOver(const std::vector<Convex>& cells, LongPoint p) {
    long double nearest = std::numeric_limits<long double>::infinity();
    bool below = false;
    for (const Convex& cell : cells) {
        const LongPoint from = support::widened(cell.vertices[0]);
        const LongPoint to = support::widened(cell.vertices[1]);
        nearest = std::min(nearest, support::toSegment(p, from, to));
        if (from.x <= p.x && p.x <= to.x) {
            below = cross(to - from, p - from) < 0;
        }
    }
    return below ? -nearest : nearest;
}

/// The deepest of all contacts of an outline with the cells.
Manifold deepest(const std::vector<Convex>& cells, const Convex& other, const Transform& at,
                 Real margin) {
    Manifold best;
    for (const Convex& cell : cells) {
        const Manifold manifold = collide(cell, {}, other, at, margin, 0);
        if (manifold.count > 0 &&
            (best.count == 0 || manifold.points[0].separation < best.points[0].separation)) {
            best = manifold;
        }
    }
    return best;
}

// F2: a ball anywhere over random hills touches as the ground as a whole says, and is pushed
// straight away from its nearest point. 10,000 places.
TEST(HeightmapContact, OfABallIsThatOfTheWholeGround) {
    support::RandomNumbers random(131);
    int touching = 0;
    for (int i = 0; i < 10000 && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "place " << i);
        const std::vector<Convex> cells = cellsOf(hills(random, 2));
        const Convex ball = convexOf(Circle{random.between(0.1, 1)}, {});
        const Convex& cell = cells[4 + random.below(cells.size() - 8)];
        const Transform at{cell.middle + random.between(0, 1) * ball.radius * cell.normals[1] +
                               random.point(0.2),
                           random.rotation()};
        const long double height = heightOver(cells, support::widened(at.position));
        if (height < static_cast<long double>(kTolerance)) {
            continue; // its centre is in the ground: it is let pass
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

/// Does the ground itself have this normal: that of a cell, or at a hilltop one between two?
bool isOfTheGround(const std::vector<Convex>& cells, Vec2 normal) {
    const Real slack = kFlush + kTolerance;
    for (const Convex& cell : cells) {
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

/// How high p lies straight above a line from left to right, or +infinity if it is not over it.
long double above(LongPoint p, LongPoint from, LongPoint to) {
    if (p.x < from.x || p.x > to.x || from.x == to.x) {
        return std::numeric_limits<long double>::infinity();
    }
    return p.y - from.y - (p.x - from.x) / (to.x - from.x) * (to.y - from.y);
}

/// How far a polygon can be lowered until it touches the ground.
long double fallOnto(const std::vector<Convex>& cells, const std::vector<LongPoint>& polygon) {
    long double fall = std::numeric_limits<long double>::infinity();
    for (const Convex& cell : cells) {
        const LongPoint from = support::widened(cell.vertices[0]);
        const LongPoint to = support::widened(cell.vertices[1]);
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const LongPoint p = polygon[i];
            const LongPoint q = polygon[(i + 1) % polygon.size()];
            fall = std::min(fall, above(p, from, to));
            // The ground's corner below the polygon's side, seen upside down.
            const long double below = -above(from, p.x < q.x ? p : q, p.x < q.x ? q : p);
            fall = std::min(fall,
                            below == -std::numeric_limits<long double>::infinity() ? fall : below);
        }
    }
    return fall;
}

// F2: whatever lies on the ground, however it is turned, no contact has a normal that the ground
// does not have, and what clearly sinks into it is noticed.
TEST(HeightmapContact, NeverTiltsANormal) {
    support::RandomNumbers random(132);
    int touching = 0;
    for (int i = 0; i < 10000 && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "place " << i);
        const std::vector<Convex> cells = cellsOf(hills(random, 0.5));
        const support::Kind kind = i % 2 == 0 ? support::Kind::Box : support::Kind::Polygon;
        const Convex other = convexOf(support::randomPrimitive(random, kind), {});
        Transform at{{random.between(4, 8), 10}, random.rotation()};
        const Real gap = static_cast<Real>(fallOnto(cells, support::placedCorners(other, at)));
        const Real sunk = random.between(0, 0.01);
        at.position.y -= gap + sunk;
        int found = 0;
        for (const Convex& cell : cells) {
            const Manifold manifold = collide(cell, {}, other, at, kMargin, 0);
            if (manifold.count > 0) {
                ASSERT_TRUE(isOfTheGround(cells, manifold.normal))
                    << manifold.normal.x << ", " << manifold.normal.y;
                // Just past a hilltop a corner is under both lines, and deeper under the one
                // before: for slopes s by sqrt(1 + s^2) / (1 - s^2) at most.
                ASSERT_GT(manifold.points[0].separation, Real(-1.5) * sunk - kTolerance);
                ++found;
            }
        }
        ASSERT_GT(found, 0);
        touching += found;
    }
    EXPECT_GT(touching, 10000);
}

// F2: on flat ground every normal is straight up, wherever the box is over its joints.
TEST(HeightmapContact, OverAFlushJointIsStraightUp) {
    const std::vector<Convex> cells = cellsOf(flat(12));
    const Convex shapes[] = {convexOf(Box{1, 1}, {}), convexOf(Circle{Real(0.5)}, {}),
                             convexOf(Box{Real(2.5), 1}, {}),
                             convexOf(Segment{{0, Real(-0.5)}, {0, Real(0.5)}, false, {}, {}}, {})};
    for (const Convex& shape : shapes) {
        for (int i = 0; i <= 4096; ++i) {
            // 4 to 6 m: over two joints, and exactly over them; by turns deep, touching and near.
            const Real x = 4 + static_cast<Real>(i) / 2048;
            const Real y = Real(0.5) + Real(0.002) * static_cast<Real>(i % 5 - 3);
            int found = 0;
            for (const Convex& cell : cells) {
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

// F2: the sweep sees no joint either, but it does see a wall that the ground makes.
TEST(HeightmapContact, OfASweepStopsAtAWallButAtNoJoint) {
    Heightmap map = flat(12);
    map.heights[11] = 5; // a steep end
    const std::vector<Convex> cells = cellsOf(map);
    const Convex shapes[] = {convexOf(Box{1, 1}, {}), convexOf(Circle{Real(0.5)}, {})};
    constexpr Real kTarget = Real(1) / 1024;
    for (const Convex& shape : shapes) {
        for (const Real sunk : {Real(0.002), Real(0), Real(-0.002)}) {
            const Sweep sliding{{{2, Real(0.5) - sunk}, {}}, {7, 0}};
            for (std::size_t i = 3; i + 1 < cells.size(); ++i) {
                EXPECT_GT(timeOfImpact(cells[i], {}, shape, sliding, kTarget), 1) << i;
            }
            EXPECT_GT(timeOfImpact(cells.back(), {}, shape, sliding, kTarget), 1);
            const Sweep further{{{2, Real(0.5) - sunk}, {}}, {9, 0}};
            EXPECT_LT(timeOfImpact(cells.back(), {}, shape, further, kTarget), 1);
        }
    }
}

// F2: a fast wide box is stopped by the tip of a hill that reaches none of its corners.
TEST(HeightmapContact, OfASweepStopsAtAHilltop) {
    const std::vector<Convex> cells = cellsOf({{-1, 0}, 1, {-2, 0, -2}});
    const Convex box = convexOf(Box{4, Real(0.25)}, {});
    const Convex ball = convexOf(Circle{Real(0.125)}, {});
    constexpr Real kTarget = Real(1) / 1024;
    for (const Convex* shape : {&box, &ball}) {
        const Sweep falling{{{0, 2}, {}}, {0, -8}};
        Real first = 2;
        for (const Convex& cell : cells) {
            first = std::min(first, timeOfImpact(cell, {}, *shape, falling, kTarget));
        }
        EXPECT_TRUE(near(first, Real(1.875) / 8, kTarget)) << "it came through";
    }
}

} // namespace
} // namespace kodo
