// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>

#include "collide/core_gap.hpp"
#include "collide/faces.hpp"
#include "collide/one_sided.hpp"
#include "collide/round.hpp"

#include <algorithm>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Manifold collideFacesRound(const ConvexShape& sided, const Transform& a, const ConvexShape& circle,
                           const Transform& b, Real margin) {
    const Transform ab = between(a, b);
    const Vec2 center = ab * circle.vertices[0];
    const RoundAxis axis = nearestToCenter(sided, center);
    const Real gap = axis.distance - circle.radius;
    Manifold manifold;
    if (gap > margin) {
        return apart(gap);
    }
    manifold.normal = a.rotation * axis.normal;
    const Vec2 point = center - (circle.radius + gap / 2) * axis.normal;
    add(manifold, {point, gap, static_cast<std::uint32_t>(axis.feature)}, a, b);
    armFromOwnCenter(manifold, circle, b);
    return manifold;
}

Real heightOver(const ConvexShape& plane, Vec2 p) {
    return dot(plane.normals[0], p - plane.vertices[0]);
}

/// The deepest vertex, and the other end of its edge that faces the plane. Two planes never
/// collide.
Manifold collidePlane(const ConvexShape& plane, const Transform& a, const ConvexShape& other,
                      const Transform& b, Real margin) {
    Manifold manifold;
    if (other.isPlane()) {
        return manifold;
    }
    const Transform ab = between(a, b);
    const Vec2 normal = plane.normals[0];
    const Vec2 down = unrotate(ab.rotation, -normal);
    if (other.oneSided && dot(other.normals[1], down) < 0) {
        manifold.fromBehind = true; // the line faces away from the plane
        return manifold;
    }
    const std::size_t deepest = supportVertex(other, down, 0);
    const std::size_t n = other.vertices.size();
    std::size_t second = deepest;
    if (n > 1) {
        const std::size_t edge = incidentEdge(other, deepest, unrotate(ab.rotation, normal));
        second = edge == deepest ? (edge + 1) % n : edge;
    }
    const std::size_t vertices[2] = {deepest, second};
    for (std::size_t i = 0; i < (second == deepest ? 1u : 2u); ++i) {
        const Vec2 p = ab * other.vertices[vertices[i]];
        const Real gap = heightOver(plane, p) - other.radius;
        if (gap <= margin) {
            manifold.normal = a.rotation * normal;
            const Vec2 point = p - (other.radius + gap / 2) * normal;
            add(manifold, {point, gap, static_cast<std::uint32_t>(vertices[i])}, a, b);
        }
    }
    if (other.isRound() && manifold.count > 0) {
        armFromOwnCenter(manifold, other, b);
    }
    return manifold;
}

/// Planes and one-sided lines.
Manifold collideSpecial(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                        const Transform& b, const ContactLimits& limits) {
    if (shapeA.isPlane()) {
        return collidePlane(shapeA, a, shapeB, b, limits.margin);
    }
    if (shapeB.isPlane()) {
        return swapped(collidePlane(shapeB, b, shapeA, a, limits.margin));
    }
    if (shapeA.oneSided) {
        return collideOneSided(shapeA, a, shapeB, b, limits);
    }
    return swapped(collideOneSided(shapeB, b, shapeA, a, limits));
}

bool isPlain(const ConvexShape& shape) {
    return shape.isRound() || (shape.isLine() && !shape.oneSided);
}

Separation reversed(Separation s) {
    return {-s.axis, s.distance};
}

Separation fromPlane(const ConvexShape& plane, const Transform& a, const ConvexShape& other,
                     const Transform& b) {
    const Vec2 normal = plane.normals[0];
    if (other.isPlane()) {
        return {a.rotation * normal, std::numeric_limits<Real>::max()};
    }
    const Transform ab = between(a, b);
    const std::size_t deepest = supportVertex(other, unrotate(ab.rotation, -normal), 0);
    return {a.rotation * normal, heightOver(plane, ab * other.vertices[deepest]) - other.radius};
}

Separation fromFaces(const ConvexShape& sided, const Transform& a, const ConvexShape& circle,
                     const Transform& b) {
    const RoundAxis axis = nearestToCenter(sided, between(a, b) * circle.vertices[0]);
    return {a.rotation * axis.normal, axis.distance - circle.radius};
}

Separation betweenFaces(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                        const Transform& b) {
    constexpr Real kAny = std::numeric_limits<Real>::max();
    const FaceAxis faceA = leastPenetratingFace(shapeA, shapeB, between(a, b), kAny);
    const FaceAxis faceB = leastPenetratingFace(shapeB, shapeA, between(b, a), kAny);
    Separation best{a.rotation * shapeA.normals[faceA.face], faceA.separation};
    if (faceB.separation > faceA.separation) {
        best = {-(b.rotation * shapeB.normals[faceB.face]), faceB.separation};
    }
    const Real radii = shapeA.radius + shapeB.radius;
    if (radii > 0 || (shapeA.isLine() && shapeB.isLine())) {
        const CoreGap gap = gapOfCores(shapeA, shapeB, between(a, b));
        if (gap.distance > best.distance && isClear(gap, shapeA, shapeB)) {
            best = {a.rotation * gap.normal, gap.distance};
        }
        best.distance -= radii;
    }
    return best;
}

} // namespace

Manifold collide(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                 const Transform& b, Real margin, Real preference) {
    return collideAhead(shapeA, a, shapeB, b, {margin, preference});
}

Manifold collideAhead(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                      const Transform& b, const ContactLimits& limits) {
    if (shapeA.isRound() && shapeB.isRound()) {
        return collideCorners({shapeA, a}, 0, {shapeB, b}, 0, limits.margin);
    }
    const bool sidedA = shapeA.kind == ConvexKind::Polygonal;
    const bool sidedB = shapeB.kind == ConvexKind::Polygonal;
    if (!(sidedA || isPlain(shapeA)) || !(sidedB || isPlain(shapeB))) {
        return collideSpecial(shapeA, a, shapeB, b, limits);
    }
    if (shapeB.isRound()) {
        return collideFacesRound(shapeA, a, shapeB, b, limits.margin);
    }
    if (shapeA.isRound()) {
        return swapped(collideFacesRound(shapeB, b, shapeA, a, limits.margin));
    }
    return collideFaces(shapeA, a, shapeB, b, limits.margin, limits.preference);
}

Separation separation(const ConvexShape& shapeA, const Transform& a, const ConvexShape& shapeB,
                      const Transform& b) {
    if (shapeA.isPlane()) {
        return fromPlane(shapeA, a, shapeB, b);
    }
    if (shapeB.isPlane()) {
        return reversed(fromPlane(shapeB, b, shapeA, a));
    }
    if (shapeA.isRound() && shapeB.isRound()) {
        const Manifold manifold =
            collideCorners({shapeA, a}, 0, {shapeB, b}, 0, std::numeric_limits<Real>::max());
        return {manifold.normal, manifold.points[0].separation};
    }
    if (shapeB.isRound()) {
        return fromFaces(shapeA, a, shapeB, b);
    }
    if (shapeA.isRound()) {
        return reversed(fromFaces(shapeB, b, shapeA, a));
    }
    return betweenFaces(shapeA, a, shapeB, b);
}

} // namespace KODO_PRECISION
} // namespace kodo
