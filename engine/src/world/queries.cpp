// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo/query.hpp>

#include "world/world_impl.hpp"

#include <algorithm>
#include <span>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

bool isAsked(const BodyView& body, CollisionFilter which) {
    return (body.flags() & kDisabled) == 0 && accepts(which, body.flags());
}

/// Calls visit(body, part index) for every part whose bounds overlap a box, in order.
template <typename Visit>
void forPartsIn(const WorldImpl& world, const Aabb& box, CollisionFilter which, Visit visit) {
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        if (!isAsked(body, which)) {
            continue;
        }
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            if (overlap(boundsOf(body.part(i).convex, body.massFrame()), box)) {
                visit(body, i);
            }
        }
    }
}

Aabb around(Vec2 from, Vec2 to) {
    return unite(Aabb{from, from}, {to, to});
}

/// Grows a box by the rounding error of bounds, so that no touching shape is missed.
Aabb withRounding(const Aabb& box) {
    constexpr Real kShare = sizeof(Real) == 4 ? Real(1e-6) : Real(1e-15);
    Real size = 0;
    for (const Real x : {box.lower.x, box.lower.y, box.upper.x, box.upper.y}) {
        size = std::max(size, x < 0 ? -x : x);
    }
    return box.grown(8 * kShare * size);
}

QueryHit queryHit(const BodyView& body, std::size_t part, Real fraction, Vec2 point, Vec2 normal) {
    return {body.id(), static_cast<std::uint16_t>(part), fraction, point, normal};
}

/// The convex shapes of a shape, relative to its own origin.
std::vector<ConvexShape> convexesOf(const Shape& shape) {
    if (const auto problem = check(shape)) {
        throw BadDefinition(*problem);
    }
    std::vector<ConvexShape> convexes;
    for (const Primitive& primitive : primitivesOf(shape)) {
        convexes.push_back(convexShapeOf(primitive, {}));
    }
    return convexes;
}

bool isFinite(const Transform& t) {
    return isFinite(t.position) && isFinite(Vec2{t.rotation.c, t.rotation.s});
}

std::vector<BodyId> overlapping(const WorldImpl& world, std::span<const ConvexShape> convexes,
                                const Transform& at, CollisionFilter which) {
    std::vector<BodyId> found;
    for (const ConvexShape& convex : convexes) {
        const Aabb box = withRounding(boundsOf(convex, at));
        forPartsIn(world, box, which, [&](const BodyView& body, std::size_t i) {
            if (std::find(found.begin(), found.end(), body.id()) == found.end() &&
                distance(body.part(i).convex, body.massFrame(), convex, at).distance <= 0) {
                found.push_back(body.id());
            }
        });
    }
    std::sort(found.begin(), found.end()); // total order: bodies are distinct
    return found;
}

/// Calls visit(hit) for every part that a ray hits, in order of body and part.
template <typename Visit>
void forHits(const WorldImpl& world, Vec2 from, Vec2 to, CollisionFilter which, Visit visit) {
    if (!isFinite(from) || !isFinite(to)) {
        return;
    }
    const Ray ray{from, to};
    forPartsIn(world, withRounding(around(from, to)), which,
               [&](const BodyView& body, std::size_t i) {
                   if (const auto hit = rayCast(body.part(i).convex, body.massFrame(), ray)) {
                       visit(queryHit(body, i, hit->fraction, ray.at(hit->fraction), hit->normal));
                   }
               });
}

} // namespace

std::optional<QueryHit> rayCast(const World& world, Vec2 from, Vec2 to, CollisionFilter which) {
    std::optional<QueryHit> best;
    forHits(world.impl(), from, to, which, [&](const QueryHit& hit) {
        if (!best || hit.fraction < best->fraction) {
            best = hit;
        }
    });
    return best;
}

std::vector<QueryHit> rayCastAll(const World& world, Vec2 from, Vec2 to, CollisionFilter which) {
    std::vector<QueryHit> hits;
    forHits(world.impl(), from, to, which, [&](const QueryHit& hit) { hits.push_back(hit); });
    std::sort(hits.begin(), hits.end(), // total order: each part is hit at most once
              [](const QueryHit& a, const QueryHit& b) {
                  return std::tie(a.fraction, a.body, a.part) <
                         std::tie(b.fraction, b.body, b.part);
              });
    return hits;
}

std::optional<QueryHit> shapeCast(const World& world, const Shape& shape, const Transform& start,
                                  Vec2 displacement, CollisionFilter which) {
    std::optional<QueryHit> best;
    const std::vector<ConvexShape> convexes = convexesOf(shape);
    if (!isFinite(start) || !isFinite(displacement)) {
        return best;
    }
    const Transform end{start.position + displacement, start.rotation};
    for (const ConvexShape& convex : convexes) {
        const Aabb box = withRounding(unite(boundsOf(convex, start), boundsOf(convex, end)));
        forPartsIn(world.impl(), box, which, [&](const BodyView& body, std::size_t i) {
            const auto hit =
                shapeCast(convex, start, displacement, body.part(i).convex, body.massFrame());
            const BodyId id = body.id();
            const auto part = static_cast<std::uint16_t>(i);
            if (hit && (!best || std::tie(hit->fraction, id, part) <
                                     std::tie(best->fraction, best->body, best->part))) {
                best = queryHit(body, i, hit->fraction, hit->point, hit->normal);
            }
        });
    }
    return best;
}

std::vector<BodyId> overlap(const World& world, const Aabb& box, CollisionFilter which) {
    const Vec2 lower = box.lower;
    const Vec2 upper = box.upper;
    if (!isFinite(lower) || !isFinite(upper) || !(lower.x <= upper.x && lower.y <= upper.y)) {
        return {};
    }
    // Relative to the box's own centre, for precision far from the origin. A box without width or
    // height is a line; one without both is a point.
    const Vec2 center = box.center();
    const Vec2 half = Real(0.5) * box.extent();
    Primitive primitive = Point{};
    if (half.x > 0 && half.y > 0) {
        primitive = Box{2 * half.x, 2 * half.y, {}, {}};
    } else if (half.x > 0 || half.y > 0) {
        primitive = Segment{-half, half, false, {}, {}};
    }
    const ConvexShape convex = convexShapeOf(primitive, {});
    return overlapping(world.impl(), std::span<const ConvexShape>(&convex, 1), {center, {}}, which);
}

std::vector<BodyId> overlap(const World& world, const Shape& shape, const Transform& at,
                            CollisionFilter which) {
    const std::vector<ConvexShape> convexes = convexesOf(shape);
    return isFinite(at) ? overlapping(world.impl(), convexes, at, which) : std::vector<BodyId>{};
}

std::optional<QueryPoint> closestPoint(const World& world, Vec2 point, Real maxDistance,
                                       CollisionFilter which) {
    std::optional<QueryPoint> best;
    if (!isFinite(point) || !(maxDistance >= 0)) {
        return best;
    }
    const Aabb box = withRounding(Aabb{point, point}.grown(maxDistance));
    forPartsIn(world.impl(), box, which, [&](const BodyView& body, std::size_t i) {
        const ClosestPoints near = distance(body.part(i).convex, body.massFrame(), point);
        if (near.distance <= maxDistance && (!best || near.distance < best->distance)) {
            best = QueryPoint{body.id(), static_cast<std::uint16_t>(i), near.onA, near.normal,
                              near.distance};
        }
    });
    return best;
}

} // namespace KODO_PRECISION
} // namespace kodo
