// SPDX-License-Identifier: MIT
#include <kodo/collide/cast.hpp>
#include <kodo/collide/distance.hpp>
#include <kodo/collide/faces.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

using Hit = std::optional<RayHit>;

/// The earlier of two; ties keep the first.
void keepFirst(Hit& best, const Hit& other) {
    if (other && (!best || other->fraction < best->fraction)) {
        best = other;
    }
}

Segment segmentOf(const Convex& line) {
    return {line.vertices[0], line.vertices[1], line.oneSided, {}, {}};
}

/// In the frame of the shape, without its skin.
Hit rayAgainstCore(const Convex& shape, const Ray& ray) {
    switch (shape.kind) {
    case OutlineKind::Round:
        return rayCast(Point{shape.vertices[0]}, ray);
    case OutlineKind::Sided:
        return rayCast(std::span<const Vec2>(shape.vertices), ray);
    case OutlineKind::Line:
        return rayCast(segmentOf(shape), ray);
    case OutlineKind::Half:
        break;
    }
    const Vec2 normal = shape.normals[0];
    return rayCast(Plane{normal, dot(normal, shape.vertices[0])}, ray);
}

/// A polygon or line with a skin: its sides, moved outwards, and a circle around each corner.
Hit rayAgainstSkin(const Convex& shape, const Ray& ray, Real radius) {
    Hit best;
    const std::size_t n = shape.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 out = radius * shape.normals[i];
        const Segment side{
            shape.vertices[(i + 1) % n] + out, shape.vertices[i] + out, true, {}, {}};
        if (!shape.oneSided || i == 1) {
            keepFirst(best, rayCast(side, ray));
        }
    }
    for (const Vec2 vertex : shape.vertices) {
        const Hit hit = rayCast(Circle{radius, vertex}, ray);
        // Of one side alone: not from within the skin either, which a ray enters from behind.
        if (hit && (!shape.oneSided || (dot(hit->normal, shape.normals[1]) > 0 &&
                                        dot(hit->normal, vertex - shape.middle) >= 0))) {
            keepFirst(best, hit);
        }
    }
    return best;
}

/// The centre of a round outline on its way past another, in the other's frame.
Hit roundAgainst(const Convex& shape, const Ray& ray, Real radius) {
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

/// Sides of a against the vertices of b, which moves by `move`; `ab` is b as seen from a.
void cutBySides(BasicRayClip<Real>& clip, const Convex& a, const Convex& b, const Transform& ab,
                Vec2 move, bool reversed) {
    std::size_t support = 0;
    for (std::size_t i = 0; i < a.normals.size(); ++i) {
        const Vec2 normal = a.normals[i];
        support = supportVertex(b, unrotate(ab.rotation, -normal), support);
        const Real height = dot(normal, ab * b.vertices[support] - a.vertices[i]);
        clip.cut(height, dot(normal, move), reversed ? unrotate(ab.rotation, -normal) : normal);
    }
}

/// Two lines are also kept apart by their ends.
void cutByEnds(BasicRayClip<Real>& clip, const Convex& a, const Convex& b, const Transform& ab,
               Vec2 move, bool reversed) {
    for (const std::size_t end : {std::size_t(0), std::size_t(1)}) {
        const Vec2 along = perp(a.normals[end]);
        const std::size_t support = supportVertex(b, unrotate(ab.rotation, -along), 0);
        const Real height = dot(along, ab * b.vertices[support] - a.vertices[1 - end]);
        clip.cut(height, dot(along, move), reversed ? unrotate(ab.rotation, -along) : along);
    }
}

/// In the frame of the target.
Hit facesAgainst(const Convex& target, const Convex& moving, const Transform& at, Vec2 move) {
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

Hit againstPlane(const Convex& plane, const Convex& moving, const Transform& at, Vec2 move) {
    const Vec2 normal = plane.normals[0];
    const std::size_t lowest = supportVertex(moving, unrotate(at.rotation, -normal), 0);
    const Vec2 start = at * moving.vertices[lowest];
    const Real offset = dot(normal, plane.vertices[0]) + moving.radius;
    const Hit hit = rayCast(Plane{normal, offset}, Ray{start, start + move});
    const bool passes = hit && moving.oneSided &&
                        (hit->normal == Vec2{} || // they overlap from the start
                         dot(normal, at.rotation * moving.normals[1]) > 0);
    return passes ? Hit{} : hit;
}

/// In the frame of the target, where the moving outline is at `at`. Swaps the two where only the
/// other way round has a form of its own: then the target moves back.
Hit castAgainst(const Convex& target, const Convex& moving, const Transform& at, Vec2 move) {
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

/// Where the two touch at the end of the cast: on the one that shows a corner or a round side.
Vec2 touchingPoint(const Convex& moving, const Transform& at, const Convex& target,
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
    const Convex& shape = ofMoving ? moving : target;
    const Transform& place = ofMoving ? at : t;
    const Vec2 inwards = ofMoving ? -normal : normal;
    const std::size_t vertex = supportVertex(shape, unrotate(place.rotation, inwards), 0);
    return place * shape.vertices[vertex] + shape.radius * inwards;
}

} // namespace

std::optional<RayHit> rayCast(const Convex& shape, const Transform& t, const Ray& ray) {
    const Ray local{toLocal(t, ray.from), toLocal(t, ray.to)};
    Hit hit = shape.isRound() ? roundAgainst(shape, local, 0) : rayAgainstCore(shape, local);
    if (hit) {
        hit->normal = t.rotation * hit->normal;
    }
    return hit;
}

std::optional<CastHit> shapeCast(const Convex& moving, const Transform& from, Vec2 move,
                                 const Convex& target, const Transform& t) {
    const Hit hit = castAgainst(target, moving, between(t, from), unrotate(t.rotation, move));
    if (!hit) {
        return std::nullopt;
    }
    const Transform at{from.position + hit->fraction * move, from.rotation};
    const Vec2 normal = t.rotation * hit->normal;
    return CastHit{hit->fraction, normal, touchingPoint(moving, at, target, t, normal)};
}

} // namespace kodo::inline KODO_PRECISION
