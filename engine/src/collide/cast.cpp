// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>

#include "collide/faces.hpp"

#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

using Hit = std::optional<RayHit>;

/// Keeps the earlier hit; ties keep the first argument.
void keepFirst(Hit& best, const Hit& other) {
    if (other && (!best || other->fraction < best->fraction)) {
        best = other;
    }
}

Segment segmentOf(const ConvexShape& line) {
    return {line.vertices[0], line.vertices[1], line.oneSided};
}

/// In the shape's frame, without its radius.
Hit rayAgainstCore(const ConvexShape& shape, const Ray& ray) {
    switch (shape.kind) {
    case ConvexKind::Round:
        return rayCast(Point{shape.vertices[0]}, ray);
    case ConvexKind::Sided:
        return rayCast(std::span<const Vec2>(shape.vertices), ray);
    case ConvexKind::Line:
        return rayCast(segmentOf(shape), ray);
    case ConvexKind::Half:
        break;
    }
    const Vec2 normal = shape.normals[0];
    return rayCast(Plane{normal, dot(normal, shape.vertices[0])}, ray);
}

/// A polygon or line with a radius: its sides, moved outwards, and a circle around each corner.
Hit rayAgainstSkin(const ConvexShape& shape, const Ray& ray, Real radius) {
    Hit best;
    const std::size_t n = shape.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 out = radius * shape.normals[i];
        const Segment side{shape.vertices[(i + 1) % n] + out, shape.vertices[i] + out, true};
        if (!shape.oneSided || i == 1) {
            keepFirst(best, rayCast(side, ray));
        }
    }
    for (const Vec2 vertex : shape.vertices) {
        const Hit hit = rayCast(Circle{radius, vertex}, ray);
        // One-sided: a ray that enters the radius from behind is not hit from inside it either.
        if (hit && (!shape.oneSided || (dot(hit->normal, shape.normals[1]) > 0 &&
                                        dot(hit->normal, vertex - shape.middle) >= 0))) {
            keepFirst(best, hit);
        }
    }
    return best;
}

/// Ray of the centre of a round shape against another shape, in the other's frame.
Hit roundAgainst(const ConvexShape& shape, const Ray& ray, Real radius) {
    if (shape.isRound()) {
        return rayCast(Circle{shape.radius + radius, shape.vertices[0]}, ray);
    }
    if (shape.isPlane()) {
        const Vec2 normal = shape.normals[0];
        return rayCast(Plane{normal, dot(normal, shape.vertices[0]) + radius}, ray);
    }
    const Real gap = distance(shape, Transform{}, ray.from).distance;
    if (gap <= radius) {
        return shape.oneSided ? Hit{} : Hit{RayHit{}};
    }
    return radius > 0 ? rayAgainstSkin(shape, ray, radius) : rayAgainstCore(shape, ray);
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
    const Hit hit = clip.hit();
    const bool passes =
        hit && ((target.oneSided && !(dot(hit->normal, target.normals[1]) > 0)) ||
                (moving.oneSided && !(dot(hit->normal, at.rotation * moving.normals[1]) < 0)));
    return passes ? Hit{} : hit;
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
    if (moving.isRound()) {
        const Vec2 center = at * moving.vertices[0];
        return roundAgainst(target, Ray{center, center + move}, moving.radius);
    }
    if (!target.isRound() && !moving.isPlane()) {
        return facesAgainst(target, moving, at, move);
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
    Hit hit = shape.isRound() ? roundAgainst(shape, local, 0) : rayAgainstCore(shape, local);
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
