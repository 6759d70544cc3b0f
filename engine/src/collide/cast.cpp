// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>

#include "collide/faces.hpp"

#include <algorithm>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

using Hit = std::optional<RayHit>;

Segment segmentOf(const ConvexShape& line) {
    return {line.vertices[0], line.vertices[1], line.oneSided, {}};
}

/// In the shape's frame.
Hit rayAgainst(const ConvexShape& shape, const Ray& ray) {
    const std::span<const Vec2> corners(shape.vertices);
    switch (shape.kind) {
    case ConvexKind::Round:
        return rayCast(Circle{shape.radius, shape.vertices[0]}, ray);
    case ConvexKind::Polygonal:
        if (shape.radius == 0) {
            return rayCast(corners, ray);
        }
        return contains(shape, Transform{}, ray.from) ? RayHit{}
                                                      : rayCastOutline(corners, shape.radius, ray);
    case ConvexKind::Line:
        return rayCast(segmentOf(shape), ray);
    case ConvexKind::HalfPlane:
        break;
    }
    const Vec2 normal = shape.normals[0];
    return rayCast(Plane{normal, dot(normal, shape.vertices[0])}, ray);
}

/// Outline of a that is moved outwards by a radius (m), against the corners of b, which moves by
/// `move` (m); `ab`: pose of b in the frame of a. Each side, or (`ends`) a circle around each of
/// its ends, meets the ends of the edge of b that faces it. Others are farther away.
Hit skinAgainst(const ConvexShape& a, const ConvexShape& b, const Transform& ab, Vec2 move,
                Real radius, bool ends) {
    Hit best;
    const std::size_t n = a.vertices.size();
    const std::size_t corners = b.vertices.size();
    std::size_t support = 0;
    for (std::size_t i = 0; i < a.normals.size(); ++i) {
        const Vec2 normal = a.normals[i];
        const Vec2 out = radius * normal;
        const Vec2 start = a.vertices[i];
        const Vec2 end = a.vertices[(i + 1) % n];
        support = supportVertex(b, unrotate(ab.rotation, -normal), support);
        const std::size_t edge =
            corners > 1 ? incidentEdge(b, support, unrotate(ab.rotation, normal)) : 0;
        for (std::size_t k = 0; k < std::min(corners, std::size_t(2)); ++k) {
            const Vec2 from = ab * b.vertices[(edge + k) % corners];
            const Ray ray{from, from + move};
            if (ends) {
                best = earlierOf(best, rayCast(Circle{radius, start}, ray));
                best = earlierOf(best, rayCast(Circle{radius, end}, ray));
            } else {
                const Segment side{end + out, start + out, true, {}};
                best = earlierOf(best, rayCast(side, ray));
            }
        }
    }
    return best;
}

/// Shapes with a radius > 0 in sum, in the frame of the target. Sides of the moving shape meet
/// corners of the target, which move backwards.
Hit skinsAgainst(const ConvexShape& target, const ConvexShape& moving, const Transform& at,
                 Vec2 move) {
    const Real radius = target.radius + moving.radius;
    const Transform back = between(at, Transform{});
    const Vec2 backMove = unrotate(at.rotation, -move);
    Hit best;
    for (const bool ends : {false, true}) { // at a tie a side counts
        best = earlierOf(best, skinAgainst(target, moving, at, move, radius, ends));
        Hit other = skinAgainst(moving, target, back, backMove, radius, ends);
        if (other) {
            other->normal = -(at.rotation * other->normal);
        }
        best = earlierOf(best, other);
    }
    return best;
}

/// Drops a hit from behind a one-sided line.
Hit fromFront(const Hit& hit, const ConvexShape& target, const ConvexShape& moving,
              const Transform& at) {
    const bool passes =
        hit && ((target.oneSided && !(dot(hit->normal, target.normals[1]) > 0)) ||
                (moving.oneSided && !(dot(hit->normal, at.rotation * moving.normals[1]) < 0)));
    return passes ? Hit{} : hit;
}

/// A target with sides, in its frame, if the moving shape is round or one of both has a radius.
Hit roundedAgainst(const ConvexShape& target, const ConvexShape& moving, const Transform& at,
                   Vec2 move) {
    const Vec2 start = at * moving.vertices[0];
    const bool overlaps = moving.isRound()
                              ? distance(target, Transform{}, start).distance <= moving.radius
                              : distance(target, Transform{}, moving, at).distance <= 0;
    if (overlaps) {
        return target.oneSided || moving.oneSided ? Hit{} : Hit{RayHit{}};
    }
    const bool thin = target.radius + moving.radius == 0;
    return fromFront(thin ? rayAgainst(target, {start, start + move})
                          : skinsAgainst(target, moving, at, move),
                     target, moving, at);
}

/// Clips by the faces of a against the vertices of b, which moves by `move` (m). `ab`: pose of b in
/// the frame of a.
void cutBySides(BasicRayClip<Real>& clip, const ConvexShape& a, const ConvexShape& b,
                const Transform& ab, Vec2 move, bool reversed) {
    std::size_t support = 0;
    for (std::size_t i = 0; i < a.normals.size(); ++i) {
        const Vec2 normal = a.normals[i];
        support = supportVertex(b, unrotate(ab.rotation, -normal), support);
        const Real height = dot(normal, ab * b.vertices[support] - a.vertices[i]);
        clip.cut(height, dot(normal, move), reversed ? unrotate(ab.rotation, -normal) : normal);
    }
}

/// Two lines may also be separated along their directions, beyond their ends.
void cutByEnds(BasicRayClip<Real>& clip, const ConvexShape& a, const ConvexShape& b,
               const Transform& ab, Vec2 move, bool reversed) {
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        const Vec2 along = perp(a.normals[end]);
        const std::size_t support = supportVertex(b, unrotate(ab.rotation, -along), 0);
        const Real height = dot(along, ab * b.vertices[support] - a.vertices[1 - end]);
        clip.cut(height, dot(along, move), reversed ? unrotate(ab.rotation, -along) : along);
    }
}

/// In the target's frame.
Hit facesAgainst(const ConvexShape& target, const ConvexShape& moving, const Transform& at,
                 Vec2 move) {
    BasicRayClip<Real> clip;
    const Transform back = between(at, Transform{});
    const Vec2 backMove = unrotate(at.rotation, -move);
    cutBySides(clip, target, moving, at, move, false);
    cutBySides(clip, moving, target, back, backMove, true);
    if (target.isLine() && moving.isLine()) {
        cutByEnds(clip, target, moving, at, move, false);
        cutByEnds(clip, moving, target, back, backMove, true);
    }
    return fromFront(clip.hit(), target, moving, at);
}

Hit againstPlane(const ConvexShape& plane, const ConvexShape& moving, const Transform& at,
                 Vec2 move) {
    const Vec2 normal = plane.normals[0];
    const std::size_t lowest = supportVertex(moving, unrotate(at.rotation, -normal), 0);
    const Vec2 start = at * moving.vertices[lowest];
    const Real offset = dot(normal, plane.vertices[0]) + moving.radius;
    const Hit hit = rayCast(Plane{normal, offset}, Ray{start, start + move});
    const bool passes = hit && moving.oneSided &&
                        (hit->normal == Vec2{} || // initial overlap
                         dot(normal, at.rotation * moving.normals[1]) > 0);
    return passes ? Hit{} : hit;
}

/// In the target's frame; `at`: pose of the moving shape. If only the swapped pair is implemented,
/// the shapes are exchanged and the target moves by -`move`.
Hit castAgainst(const ConvexShape& target, const ConvexShape& moving, const Transform& at,
                Vec2 move) {
    if (target.isPlane()) {
        return moving.isPlane() ? Hit{RayHit{}} : againstPlane(target, moving, at, move);
    }
    if (target.isRound() && moving.isRound()) {
        const Vec2 start = at * moving.vertices[0];
        return rayCast(Circle{target.radius + moving.radius, target.vertices[0]},
                       Ray{start, start + move});
    }
    if (!target.isRound() && !moving.isPlane()) {
        return moving.isRound() || target.radius + moving.radius > 0
                   ? roundedAgainst(target, moving, at, move)
                   : facesAgainst(target, moving, at, move);
    }
    Hit hit = castAgainst(moving, target, between(at, Transform{}), unrotate(at.rotation, -move));
    if (hit) {
        hit->normal = -(at.rotation * hit->normal);
    }
    return hit;
}

/// Contact point at the end of the cast, on the shape that touches with a corner or a round side.
Vec2 touchingPoint(const ConvexShape& moving, const Transform& at, const ConvexShape& target,
                   const Transform& t, Vec2 normal) {
    if (normal == Vec2{}) {
        return distance(target, t, moving, at).onA;
    }
    const bool ofMoving = moving.isRound() || target.isPlane();
    if (!ofMoving && !target.isRound() && !moving.isPlane()) {
        if (target.radius + moving.radius > 0) {
            return distance(target, t, moving, at).onA;
        }
        const Manifold touch =
            collideFaces(target, t, moving, at, std::numeric_limits<Real>::max(), 0);
        return t.position + touch.points[0].armA;
    }
    const ConvexShape& shape = ofMoving ? moving : target;
    const Transform& place = ofMoving ? at : t;
    const Vec2 inwards = ofMoving ? -normal : normal;
    const std::size_t vertex = supportVertex(shape, unrotate(place.rotation, inwards), 0);
    return place * shape.vertices[vertex] + shape.radius * inwards;
}

} // namespace

std::optional<RayHit> rayCast(const ConvexShape& shape, const Transform& t, const Ray& ray) {
    const Ray local{toLocal(t, ray.from), toLocal(t, ray.to)};
    Hit hit = rayAgainst(shape, local);
    if (hit) {
        hit->normal = t.rotation * hit->normal;
    }
    return hit;
}

std::optional<CastHit> shapeCast(const ConvexShape& moving, const Transform& from, Vec2 move,
                                 const ConvexShape& target, const Transform& t) {
    const Hit hit = castAgainst(target, moving, between(t, from), unrotate(t.rotation, move));
    if (!hit) {
        return std::nullopt;
    }
    const Transform at{from.position + hit->fraction * move, from.rotation};
    const Vec2 normal = t.rotation * hit->normal;
    return CastHit{hit->fraction, normal, touchingPoint(moving, at, target, t, normal)};
}

} // namespace KODO_PRECISION
} // namespace kodo
