// SPDX-License-Identifier: MIT
#include "collide/faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

struct Edge {
    Vec2 start;
    Vec2 end;
};

/// Clips away the part beyond `limit` along `axis`. False if nothing remains.
bool clip(Edge& edge, Vec2 axis, Real limit) {
    const Real start = dot(axis, edge.start) - limit;
    const Real end = dot(axis, edge.end) - limit;
    if (start > 0 && end > 0) {
        return false;
    }
    if (start > 0) {
        edge.start += (start / (start - end)) * (edge.end - edge.start);
    } else if (end > 0) {
        edge.end += (end / (end - start)) * (edge.start - edge.end);
    }
    return true;
}

/// True if two points, clipped to a face, are equal except for rounding.
bool areOne(Vec2 p, Vec2 q, Vec2 faceStart, Vec2 faceEnd) {
    constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
    const Real size = std::max(lengthSquared(faceStart), lengthSquared(faceEnd));
    return lengthSquared(q - p) <= kRounding * kRounding * size;
}

std::size_t nextVertex(const ConvexShape& shape, std::size_t vertex) {
    return vertex + 1 == shape.vertices.size() ? 0 : vertex + 1;
}

/// True if a direction from a vertex leads beyond the ends of both its edges. This is more precise
/// than the search for the gap, which compares squares of distances.
bool isBeyondEdges(const ConvexShape& shape, std::size_t vertex, Vec2 direction) {
    const std::size_t before = vertex == 0 ? shape.vertices.size() - 1 : vertex - 1;
    return dot(direction, perp(shape.normals[vertex])) <= 0 &&
           dot(direction, perp(shape.normals[before])) >= 0;
}

} // namespace

Manifold collideCorners(Placed a, std::size_t vertexA, Placed b, std::size_t vertexB, Real margin) {
    const Vec2 armA = a.at.rotation * a.shape.vertices[vertexA];
    const Vec2 armB = b.at.rotation * b.shape.vertices[vertexB];
    const Vec2 d = armB + (b.at.position - a.at.position) - armA;
    const Real distance = length(d);
    const Real gap = distance - a.shape.radius - b.shape.radius;
    if (gap > margin) {
        return apart(gap);
    }
    const bool round = a.shape.isRound() && b.shape.isRound();
    const auto feature =
        static_cast<std::uint32_t>((round ? 0 : 1u << 30) | vertexA << 12 | vertexB);
    Manifold manifold;
    // Corners at one place have no unique normal.
    manifold.normal = distance > 0 ? d / distance : a.at.rotation.yAxis();
    manifold.points[0] = {armA + (a.shape.radius + gap / 2) * manifold.normal,
                          armB - (b.shape.radius + gap / 2) * manifold.normal, gap, feature};
    manifold.count = 1;
    return manifold;
}

bool isOfCorners(const CoreGap& gap, Placed a, Placed b, Vec2 faceA, Vec2 faceB) {
    if (!gap.ofVertices || !isClear(gap, a.shape, b.shape)) {
        return false;
    }
    const Vec2 towardsA = unrotate(b.at.rotation, a.at.rotation * -gap.normal);
    if (!isBeyondEdges(a.shape, gap.vertexA, gap.normal) ||
        !isBeyondEdges(b.shape, gap.vertexB, towardsA)) {
        return false;
    }
    constexpr Real kParallel = Real(1e-2); // sine
    const Real turn = std::abs(cross(faceA, faceB));
    const bool parallel = turn < kParallel && dot(faceA, faceB) < 0;
    const Real rounding = roundingOf(a.shape, b.shape) / gap.distance;
    return !(parallel && std::abs(cross(gap.normal, faceA)) <= turn + rounding);
}

std::size_t incidentEdge(const ConvexShape& b, std::size_t vertex, Vec2 normalInB) {
    const std::size_t before = vertex == 0 ? b.vertices.size() - 1 : vertex - 1;
    return dot(b.normals[before], normalInB) < dot(b.normals[vertex], normalInB) ? before : vertex;
}

Manifold clipAgainstFace(Placed a, Placed b, const Transform& ab, const FaceAxis& axis, Real margin,
                         BeyondEnds beyond) {
    const ConvexShape& shapeA = a.shape;
    const ConvexShape& shapeB = b.shape;
    const Vec2 normal = shapeA.normals[axis.face];
    const Vec2 normalInB = unrotate(ab.rotation, normal);
    const std::size_t deepest = supportVertex(shapeB, -normalInB, 0);
    const std::size_t other = incidentEdge(shapeB, deepest, normalInB);
    // The facing edge is antiparallel to the reference edge: its end is at the reference's start.
    Edge edge{ab * shapeB.vertices[nextVertex(shapeB, other)], ab * shapeB.vertices[other]};

    const Vec2 first = shapeA.vertices[axis.face];
    const Vec2 second = shapeA.vertices[nextVertex(shapeA, axis.face)];
    const Vec2 along = perp(normal);
    Manifold manifold;
    const Real height = dot(normal, first);
    const Real radii = shapeA.radius + shapeB.radius;
    if (!clip(edge, -along, -dot(along, first)) || !clip(edge, along, dot(along, second)) ||
        std::min(dot(normal, edge.start), dot(normal, edge.end)) - height - radii > margin) {
        if (beyond == BeyondEnds::Nothing) {
            return manifold;
        }
        edge = {ab * shapeB.vertices[deepest], ab * shapeB.vertices[deepest]};
    }
    manifold.normal = a.at.rotation * normal;
    const std::uint32_t feature = static_cast<std::uint32_t>(axis.face << 12 | other << 1);
    LocalPoint points[2] = {{edge.start, dot(normal, edge.start) - height - radii, feature},
                            {edge.end, dot(normal, edge.end) - height - radii, feature + 1}};
    if (points[1].separation < points[0].separation) {
        std::swap(points[0], points[1]);
    }
    const bool same = areOne(points[0].point, points[1].point, first, second);
    for (std::size_t i = 0; i < (same ? 1u : 2u); ++i) {
        LocalPoint& p = points[i];
        if (p.separation <= margin) {
            p.point -= (shapeB.radius + p.separation / 2) * normal;
            add(manifold, p, a.at, b.at);
        }
    }
    return manifold;
}

Manifold clipAgainstFaceOfB(Placed a, Placed b, const Transform& ba, const FaceAxis& axis,
                            Real margin, BeyondEnds beyond) {
    Manifold manifold = swapped(clipAgainstFace(b, a, ba, axis, margin, beyond));
    for (ManifoldPoint& point : manifold.points) {
        point.feature |= 1u << 31;
    }
    return manifold;
}

Manifold collideFaces(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                      const Transform& b, Real margin, Real preference) {
    const Transform ab = between(a, b);
    const Real radii = shapeA.radius + shapeB.radius;
    const Real reach = margin + radii;
    const FaceAxis faceA = leastPenetratingFace(shapeA, shapeB, ab, reach);
    if (faceA.separation > reach) {
        return apart(faceA.separation - radii);
    }
    const Transform ba = between(b, a);
    const FaceAxis faceB = leastPenetratingFace(shapeB, shapeA, ba, reach);
    if (faceB.separation > reach) {
        return apart(faceB.separation - radii);
    }
    if (radii > 0 || (shapeA.isLine() && shapeB.isLine())) {
        const CoreGap gap = gapOfCores(shapeA, shapeB, ab);
        if (isOfCorners(gap, {shapeA, a}, {shapeB, b}, shapeA.normals[faceA.face],
                        ab.rotation * shapeB.normals[faceB.face])) {
            return collideCorners({shapeA, a}, gap.vertexA, {shapeB, b}, gap.vertexB, margin);
        }
    }
    if (faceB.separation > faceA.separation + preference) {
        return clipAgainstFaceOfB({shapeA, a}, {shapeB, b}, ba, faceB, margin);
    }
    return clipAgainstFace({shapeA, a}, {shapeB, b}, ab, faceA, margin);
}

} // namespace KODO_PRECISION
} // namespace kodo
