// SPDX-License-Identifier: MIT
// Not in the header: tests are compiled without optimisation, and this is most of the time of some.
#include "support/minkowski_oracle.hpp"

#include <algorithm>
#include <limits>

namespace support {

LongPoint widened(kodo::Vec2 v) {
    return {static_cast<long double>(v.x), static_cast<long double>(v.y)};
}

LongPoint placed(const kodo::Transform& t, kodo::Vec2 v) {
    const kodo::BasicRot<long double> turn{static_cast<long double>(t.rotation.c),
                                           static_cast<long double>(t.rotation.s)};
    return turn * widened(v) + widened(t.position);
}

std::vector<LongPoint> placedCorners(const kodo::ConvexShape& convex, const kodo::Transform& t) {
    std::vector<LongPoint> corners;
    for (const kodo::Vec2 vertex : convex.vertices) {
        corners.push_back(placed(t, vertex));
    }
    return corners;
}

std::vector<LongPoint> wrapped(const std::vector<LongPoint>& points) {
    std::size_t start = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const LongPoint p = points[i];
        const LongPoint q = points[start];
        start = p.x < q.x || (p.x == q.x && p.y < q.y) ? i : start;
    }
    std::vector<LongPoint> hull{points[start]};
    while (hull.size() <= points.size()) {
        LongPoint next = hull.back();
        for (const LongPoint p : points) {
            const LongPoint way = next - hull.back();
            const LongPoint other = p - hull.back();
            const long double turn = cross(way, other);
            if (way == LongPoint{} || turn < 0 ||
                (turn == 0 && dot(other, other) > dot(way, way))) {
                next = p;
            }
        }
        if (next == points[start] || next == hull.back()) {
            break;
        }
        hull.push_back(next);
    }
    return hull;
}

long double toSegment(LongPoint p, LongPoint from, LongPoint to) {
    const LongPoint edge = to - from;
    const long double size = dot(edge, edge);
    const long double share = size > 0 ? std::clamp(dot(p - from, edge) / size, 0.0L, 1.0L) : 0;
    return length(p - (from + share * edge));
}

long double signedDistance(const std::vector<LongPoint>& hull, LongPoint p) {
    long double nearest = std::numeric_limits<long double>::infinity();
    bool inside = hull.size() >= 3;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const LongPoint from = hull[i];
        const LongPoint to = hull[(i + 1) % hull.size()];
        nearest = std::min(nearest, toSegment(p, from, to));
        inside = inside && cross(to - from, p - from) > 0;
    }
    return inside ? -nearest : nearest;
}

static long double fromPlane(const kodo::ConvexShape& plane, const kodo::Transform& a,
                             const kodo::ConvexShape& other, const kodo::Transform& b) {
    const LongPoint normal = placed({{}, a.rotation}, plane.normals[0]);
    long double lowest = std::numeric_limits<long double>::infinity();
    for (const LongPoint corner : placedCorners(other, b)) {
        lowest = std::min(lowest, dot(normal, corner - placed(a, plane.vertices[0])));
    }
    return lowest - static_cast<long double>(other.radius);
}

std::vector<LongPoint> differencesOf(const kodo::ConvexShape& shapeA, const kodo::Transform& a,
                                     const kodo::ConvexShape& shapeB, const kodo::Transform& b) {
    std::vector<LongPoint> differences;
    for (const LongPoint p : placedCorners(shapeA, a)) {
        for (const LongPoint q : placedCorners(shapeB, b)) {
            differences.push_back(q - p);
        }
    }
    return wrapped(differences);
}

long double signedDistance(const kodo::ConvexShape& shapeA, const kodo::Transform& a,
                           const kodo::ConvexShape& shapeB, const kodo::Transform& b) {
    if (shapeA.isPlane()) {
        return fromPlane(shapeA, a, shapeB, b);
    }
    if (shapeB.isPlane()) {
        return fromPlane(shapeB, b, shapeA, a);
    }
    return signedDistance(differencesOf(shapeA, a, shapeB, b), {}) -
           static_cast<long double>(shapeA.radius) - static_cast<long double>(shapeB.radius);
}

/// The point of a hull nearest to p.
static LongPoint nearestOn(const std::vector<LongPoint>& hull, LongPoint p) {
    LongPoint nearest = hull[0];
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const LongPoint from = hull[i];
        const LongPoint edge = hull[(i + 1) % hull.size()] - from;
        const long double size = dot(edge, edge);
        const long double share = size > 0 ? std::clamp(dot(p - from, edge) / size, 0.0L, 1.0L) : 0;
        const LongPoint q = from + share * edge;
        nearest = length(p - q) < length(p - nearest) ? q : nearest;
    }
    return nearest;
}

/// Conservative advancement of b. The gap closes no faster than the speed along the direction to
/// the nearest point. Each round advances by that safe fraction.
static Passage passageOf(const std::vector<LongPoint>& differences, long double radius,
                         LongPoint move) {
    const long double speed = length(move);
    if (signedDistance(differences, {}) <= radius) {
        return {Passage::End::Hits, 0};
    }
    long double t = 0;
    LongPoint normal; // last direction above the rounding error
    for (int round = 0; round < 1000 && t <= 1; ++round) {
        const LongPoint p = -t * move;
        const LongPoint arm = p - nearestOn(differences, p);
        const long double gap = length(arm) - radius;
        const long double closing = dot(arm, move) / length(arm);
        normal = length(arm) > 1e-12L ? -(1 / length(arm)) * arm : normal;
        if (gap < 1e-17L) {
            const bool steep = closing > 1e-3L * speed;
            return {steep ? Passage::End::Hits : Passage::End::Grazes, t, normal};
        }
        if (closing <= 0) {
            return {gap > 1e-4L ? Passage::End::Misses : Passage::End::Grazes, 0};
        }
        t += gap / closing;
    }
    return {t > 1.0001L ? Passage::End::Misses : Passage::End::Grazes, 0};
}

Passage passageOf(const kodo::ConvexShape& moving, const kodo::Transform& from, kodo::Vec2 move,
                  const kodo::ConvexShape& target, const kodo::Transform& t) {
    if (!target.isPlane() && !moving.isPlane()) {
        const long double radius =
            static_cast<long double>(target.radius) + static_cast<long double>(moving.radius);
        return passageOf(differencesOf(target, t, moving, from), radius, widened(move));
    }
    const kodo::ConvexShape& plane = target.isPlane() ? target : moving;
    const kodo::Transform& at = target.isPlane() ? t : from;
    const long double side = target.isPlane() ? 1 : -1; // the plane moves towards the target
    const long double gap = signedDistance(moving, from, target, t);
    const LongPoint normal = side * placed({{}, at.rotation}, plane.normals[0]);
    const long double fall = -dot(normal, widened(move));
    if (gap <= 0) {
        return {Passage::End::Hits, 0};
    }
    return {fall >= gap ? Passage::End::Hits : Passage::End::Misses, fall > 0 ? gap / fall : 0,
            normal};
}

Passage frontPassageOf(const kodo::ConvexShape& moving, const kodo::Transform& from,
                       kodo::Vec2 move, const kodo::ConvexShape& target, const kodo::Transform& t) {
    const Passage passage = passageOf(moving, from, move, target, t);
    const auto passes = [&](const kodo::ConvexShape& line, kodo::Rot rotation, LongPoint away) {
        return line.oneSided && dot(placed({{}, rotation}, line.normals[1]), away) <= 0;
    };
    if (passage.end == Passage::End::Hits && (passes(target, t.rotation, passage.normal) ||
                                              passes(moving, from.rotation, -passage.normal))) {
        return {Passage::End::Misses, 0};
    }
    return passage;
}

} // namespace support
