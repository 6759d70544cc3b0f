// SPDX-License-Identifier: MIT
#include <kodo/base/assert.hpp>
#include <kodo/collide/collide.hpp>
#include <kodo/collide/round.hpp>
#include <kodo/collide/sat.hpp>

#include <limits>
#include <utility>

namespace kodo::inline KODO_PRECISION {
namespace {

/// Found in A's frame, around A's centre; the last step turns it to world axes. So nothing is lost
/// far from the origin.
struct LocalPoint {
    Vec2 point;
    Real separation;
    std::uint32_t feature;
};

void add(Manifold& manifold, const LocalPoint& local, const Transform& a, const Transform& b) {
    const Vec2 armA = a.rotation * local.point;
    manifold.points[static_cast<std::size_t>(manifold.count)] = {
        armA, armA + (a.position - b.position), local.separation, local.feature};
    ++manifold.count;
}

Manifold collideRound(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                      const Transform& b, Real margin) {
    const Vec2 centerA = a.rotation * shapeA.vertices[0];
    const Vec2 d = b.rotation * shapeB.vertices[0] + (b.position - a.position) - centerA;
    const Real distance = length(d);
    const Real gap = distance - shapeA.radius - shapeB.radius;
    Manifold manifold;
    if (gap > margin) {
        return manifold;
    }
    // Two circles on one point have no direction of their own.
    manifold.normal = distance > 0 ? d / distance : Vec2{0, 1};
    const Vec2 armA = centerA + (shapeA.radius + gap / 2) * manifold.normal;
    manifold.points[0] = {armA, armA + (a.position - b.position), gap, 0};
    manifold.count = 1;
    return manifold;
}

Manifold collidePolygonRound(const Convex& polygon, const Transform& a, const Convex& circle,
                             const Transform& b, Real margin) {
    const Transform ab = between(a, b);
    const Vec2 center = ab * circle.vertices[0];
    const RoundAxis axis = nearestToCenter(polygon, center);
    const Real gap = axis.distance - circle.radius - polygon.radius;
    Manifold manifold;
    if (gap > margin) {
        return manifold;
    }
    manifold.normal = a.rotation * axis.normal;
    const Vec2 point = center - (circle.radius + gap / 2) * axis.normal;
    add(manifold, {point, gap, static_cast<std::uint32_t>(axis.feature)}, a, b);
    return manifold;
}

/// The other way round: swaps the arms and turns the normal.
Manifold swapped(Manifold manifold) {
    manifold.normal = -manifold.normal;
    for (ManifoldPoint& point : manifold.points) {
        std::swap(point.armA, point.armB);
    }
    return manifold;
}

/// A line segment with the place where it was cut, for features.
struct Edge {
    Vec2 start;
    Vec2 end;
};

/// The edge at `vertex` of b that faces the normal most directly.
std::size_t incidentEdge(const Convex& b, std::size_t vertex, Vec2 normalInB) {
    const std::size_t n = b.vertices.size();
    const std::size_t before = (vertex + n - 1) % n;
    return dot(b.normals[before], normalInB) < dot(b.normals[vertex], normalInB) ? before : vertex;
}

/// Cuts away what lies beyond `limit` along `axis`. Nothing is left when both ends do.
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

/// Face of a against the facing edge of b, both seen from a. Only what lies above the face counts:
/// a corner that has come out on the far side is no second point [Thesis06, fig. 3.5].
Manifold clipAgainstFace(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                         const Transform& b, const FaceAxis& axis, Real margin) {
    const Transform ab = between(a, b);
    const Vec2 normal = shapeA.normals[axis.face];
    const std::size_t other = incidentEdge(shapeB, axis.support, unrotate(ab.rotation, normal));
    const std::size_t n = shapeB.vertices.size();
    // The facing edge runs against the reference edge, so its end lies at the reference's start.
    Edge edge{ab * shapeB.vertices[(other + 1) % n], ab * shapeB.vertices[other]};

    const Vec2 first = shapeA.vertices[axis.face];
    const Vec2 second = shapeA.vertices[(axis.face + 1) % shapeA.vertices.size()];
    const Vec2 along = perp(normal);
    Manifold manifold;
    const bool left = clip(edge, -along, -dot(along, first));
    if (!left || !clip(edge, along, dot(along, second))) {
        // Beyond the ends of the face: the deepest corner alone tells how near they are.
        edge = {ab * shapeB.vertices[axis.support], ab * shapeB.vertices[axis.support]};
    }
    manifold.normal = a.rotation * normal;
    const std::uint32_t feature = static_cast<std::uint32_t>(axis.face << 12 | other << 1);
    const Real height = dot(normal, first);
    LocalPoint points[2] = {{edge.start, dot(normal, edge.start) - height, feature},
                            {edge.end, dot(normal, edge.end) - height, feature + 1}};
    if (points[1].separation < points[0].separation) {
        std::swap(points[0], points[1]);
    }
    for (LocalPoint& p : points) {
        const bool same = manifold.count > 0 && p.point == points[0].point;
        if (p.separation <= margin && !same) {
            p.point -= (p.separation / 2) * normal;
            add(manifold, p, a, b);
        }
    }
    return manifold;
}

Manifold collidePolygons(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                         const Transform& b, Real margin, Real preference) {
    const FaceAxis faceA = leastPenetratingFace(shapeA, shapeB, between(a, b), margin);
    if (faceA.separation > margin) {
        return {};
    }
    const FaceAxis faceB = leastPenetratingFace(shapeB, shapeA, between(b, a), margin);
    if (faceB.separation > margin) {
        return {};
    }
    if (faceB.separation > faceA.separation + preference) {
        Manifold manifold = swapped(clipAgainstFace(shapeB, b, shapeA, a, faceB, margin));
        for (ManifoldPoint& point : manifold.points) {
            point.feature |= 1u << 31;
        }
        return manifold;
    }
    return clipAgainstFace(shapeA, a, shapeB, b, faceA, margin);
}

} // namespace

Manifold collide(const Convex& shapeA, const Transform& a, const Convex& shapeB, const Transform& b,
                 Real margin, Real preference) {
    if (shapeA.isRound() && shapeB.isRound()) {
        return collideRound(shapeA, a, shapeB, b, margin);
    }
    if (shapeB.isRound()) {
        return collidePolygonRound(shapeA, a, shapeB, b, margin);
    }
    if (shapeA.isRound()) {
        return swapped(collidePolygonRound(shapeB, b, shapeA, a, margin));
    }
    return collidePolygons(shapeA, a, shapeB, b, margin, preference);
}

Separation separation(const Convex& shapeA, const Transform& a, const Convex& shapeB,
                      const Transform& b) {
    constexpr Real kAny = std::numeric_limits<Real>::max();
    if (shapeA.isRound() || shapeB.isRound()) {
        const Manifold manifold = collide(shapeA, a, shapeB, b, kAny, 0);
        return {manifold.normal, manifold.points[0].separation};
    }
    const FaceAxis faceA = leastPenetratingFace(shapeA, shapeB, between(a, b), kAny);
    const FaceAxis faceB = leastPenetratingFace(shapeB, shapeA, between(b, a), kAny);
    if (faceB.separation > faceA.separation) {
        return {-(b.rotation * shapeB.normals[faceB.face]), faceB.separation};
    }
    return {a.rotation * shapeA.normals[faceA.face], faceA.separation};
}

} // namespace kodo::inline KODO_PRECISION
