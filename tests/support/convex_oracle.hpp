// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>

#include <limits>
#include <vector>

/// Slow oracle for the relative position of two convex shapes, in long double and by brute force.
/// Every edge is tested against every corner, without hill climbing, early out or local frames.
namespace support {

using LongVec = kodo::BasicVec2<long double>;

inline LongVec toLong(kodo::Vec2 v) {
    return {static_cast<long double>(v.x), static_cast<long double>(v.y)};
}

/// A convex shape in world coordinates.
struct Outline {
    std::vector<LongVec> corners;
    long double radius = 0;

    LongVec corner(std::size_t i) const { return corners[i % corners.size()]; }
};

inline Outline outlineOf(const kodo::ConvexShape& convex, const kodo::Transform& pose) {
    const kodo::BasicRot<long double> turn{static_cast<long double>(pose.rotation.c),
                                           static_cast<long double>(pose.rotation.s)};
    Outline outline;
    for (const kodo::Vec2 vertex : convex.vertices) {
        outline.corners.push_back(turn * toLong(vertex) + toLong(pose.position));
    }
    outline.radius = static_cast<long double>(convex.radius);
    return outline;
}

inline long double distanceToSegment(LongVec p, LongVec from, LongVec to) {
    const LongVec edge = to - from;
    long double share = dot(p - from, edge) / dot(edge, edge);
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    return length(p - (from + share * edge));
}

/// True when p is to the left of every edge.
inline bool isInside(const Outline& polygon, LongVec p) {
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const LongVec edge = polygon.corner(i + 1) - polygon.corner(i);
        if (cross(edge, p - polygon.corner(i)) < 0) {
            return false;
        }
    }
    return true;
}

/// Distance from the polygon to p; negative inside.
inline long double signedDistance(const Outline& polygon, LongVec p) {
    long double nearest = std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        nearest = std::min(nearest, distanceToSegment(p, polygon.corner(i), polygon.corner(i + 1)));
    }
    return isInside(polygon, p) ? -nearest : nearest;
}

/// The largest separation along any edge normal of `a`.
inline long double gapAlongNormals(const Outline& a, const Outline& b) {
    long double best = -std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < a.corners.size(); ++i) {
        const LongVec edge = a.corner(i + 1) - a.corner(i);
        const LongVec normal = normalize(LongVec{edge.y, -edge.x});
        long double gap = std::numeric_limits<long double>::infinity();
        for (const LongVec corner : b.corners) {
            gap = std::min(gap, dot(normal, corner - a.corner(i)));
        }
        best = std::max(best, gap);
    }
    return best;
}

/// Oracle for kodo::separation: separation along the best axis, negative if the shapes overlap.
inline long double separationOf(const Outline& a, const Outline& b) {
    const bool roundA = a.corners.size() == 1;
    const bool roundB = b.corners.size() == 1;
    if (roundA && roundB) {
        return length(b.corners[0] - a.corners[0]) - a.radius - b.radius;
    }
    if (roundB) {
        return signedDistance(a, b.corners[0]) - b.radius;
    }
    if (roundA) {
        return signedDistance(b, a.corners[0]) - a.radius;
    }
    return std::max(gapAlongNormals(a, b), gapAlongNormals(b, a));
}

/// True if two polygons share a point. Tests edge crossings and contained corners instead of
/// separating axes.
inline bool polygonsMeet(const Outline& a, const Outline& b) {
    if (isInside(a, b.corners[0]) || isInside(b, a.corners[0])) {
        return true;
    }
    for (std::size_t i = 0; i < a.corners.size(); ++i) {
        for (std::size_t k = 0; k < b.corners.size(); ++k) {
            const LongVec p = a.corner(i);
            const LongVec q = b.corner(k);
            const LongVec u = a.corner(i + 1) - p;
            const LongVec v = b.corner(k + 1) - q;
            const bool splitsB = (cross(u, q - p) < 0) != (cross(u, q + v - p) < 0);
            const bool splitsA = (cross(v, p - q) < 0) != (cross(v, p + u - q) < 0);
            if (splitsA && splitsB) {
                return true;
            }
        }
    }
    return false;
}

/// Distance between the nearest points of two disjoint polygons. For corner against corner it
/// exceeds the separation along every axis.
inline long double distanceOf(const Outline& a, const Outline& b) {
    long double nearest = std::numeric_limits<long double>::infinity();
    for (const Outline* one : {&a, &b}) {
        const Outline& other = one == &a ? b : a;
        for (const LongVec corner : one->corners) {
            nearest = std::min(nearest, signedDistance(other, corner));
        }
    }
    return nearest;
}

} // namespace support
