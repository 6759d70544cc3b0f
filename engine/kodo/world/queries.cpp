// SPDX-License-Identifier: MIT
#include <kodo/collide/cast.hpp>
#include <kodo/collide/distance.hpp>
#include <kodo/world/queries.hpp>

#include <algorithm>
#include <span>
#include <tuple>

namespace kodo::inline KODO_PRECISION {
namespace {

bool isAsked(const BodyView& body, CollisionFilter which) {
    return (body.flags() & kDisabled) == 0 && accepts(which, body.flags());
}

/// Calls visit(body, part index) for every part whose bounds meet a box, in order.
template <typename Visit>
void forPartsIn(const World& world, const Aabb& box, CollisionFilter which, Visit visit) {
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        if (!isAsked(body, which)) {
            continue;
        }
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            if (overlap(boundsOf(body.part(i).convex, body.placement()), box)) {
                visit(body, i);
            }
        }
    }
}

Aabb around(Vec2 from, Vec2 to) {
    return unite(Aabb{from, from}, {to, to});
}

/// Bounds are found with roundings of their own; a touch must not be lost by them.
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

/// The parts of a shape as outlines about its own origin.
std::vector<Convex> outlinesOf(const Shape& shape) {
    if (const auto problem = check(shape)) {
        throw BadDefinition(*problem);
    }
    std::vector<Convex> outlines;
    for (const Primitive& primitive : primitivesOf(shape)) {
        outlines.push_back(convexOf(primitive, {}));
    }
    return outlines;
}

bool isFinite(const Transform& t) {
    return isFinite(t.position) && isFinite(Vec2{t.rotation.c, t.rotation.s});
}

std::vector<BodyId> overlapping(const World& world, std::span<const Convex> outlines,
                                const Transform& at, CollisionFilter which) {
    std::vector<BodyId> found;
    for (const Convex& outline : outlines) {
        const Aabb box = withRounding(boundsOf(outline, at));
        forPartsIn(world, box, which, [&](const BodyView& body, std::size_t i) {
            if (std::find(found.begin(), found.end(), body.id()) == found.end() &&
                distance(body.part(i).convex, body.placement(), outline, at).distance <= 0) {
                found.push_back(body.id());
            }
        });
    }
    std::sort(found.begin(), found.end()); // total order: no two are equal
    return found;
}

/// Calls visit(hit) for every part that a ray meets, by body and part.
template <typename Visit>
void forHits(const World& world, Vec2 from, Vec2 to, CollisionFilter which, Visit visit) {
    if (!isFinite(from) || !isFinite(to)) {
        return;
    }
    const Ray ray{from, to};
    forPartsIn(world, withRounding(around(from, to)), which,
               [&](const BodyView& body, std::size_t i) {
                   if (const auto hit = rayCast(body.part(i).convex, body.placement(), ray)) {
                       visit(queryHit(body, i, hit->fraction, ray.at(hit->fraction), hit->normal));
                   }
               });
}

} // namespace

std::optional<QueryHit> rayCast(const World& world, Vec2 from, Vec2 to, CollisionFilter which) {
    std::optional<QueryHit> best;
    forHits(world, from, to, which, [&](const QueryHit& hit) {
        if (!best || hit.fraction < best->fraction) {
            best = hit;
        }
    });
    return best;
}

std::vector<QueryHit> rayCastAll(const World& world, Vec2 from, Vec2 to, CollisionFilter which) {
    std::vector<QueryHit> hits;
    forHits(world, from, to, which, [&](const QueryHit& hit) { hits.push_back(hit); });
    std::sort(hits.begin(), hits.end(), // total order: no part is met twice
              [](const QueryHit& a, const QueryHit& b) {
                  return std::tie(a.fraction, a.body, a.part) <
                         std::tie(b.fraction, b.body, b.part);
              });
    return hits;
}

std::optional<QueryHit> shapeCast(const World& world, const Shape& shape, const Transform& start,
                                  Vec2 move, CollisionFilter which) {
    std::optional<QueryHit> best;
    const std::vector<Convex> outlines = outlinesOf(shape);
    if (!isFinite(start) || !isFinite(move)) {
        return best;
    }
    const Transform end{start.position + move, start.rotation};
    for (const Convex& outline : outlines) {
        const Aabb box = withRounding(unite(boundsOf(outline, start), boundsOf(outline, end)));
        forPartsIn(world, box, which, [&](const BodyView& body, std::size_t i) {
            const auto hit = shapeCast(outline, start, move, body.part(i).convex, body.placement());
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
    // About its own centre, so that nothing is lost far from the origin. A box without width is a
    // line, and one without height too.
    const Vec2 center = box.center();
    const Vec2 half = Real(0.5) * box.extent();
    Primitive primitive = Point{};
    if (half.x > 0 && half.y > 0) {
        primitive = Box{2 * half.x, 2 * half.y, {}, {}};
    } else if (half.x > 0 || half.y > 0) {
        primitive = Segment{-half, half, false, {}, {}};
    }
    const Convex outline = convexOf(primitive, {});
    return overlapping(world, std::span<const Convex>(&outline, 1), {center, {}}, which);
}

std::vector<BodyId> overlap(const World& world, const Shape& shape, const Transform& at,
                            CollisionFilter which) {
    const std::vector<Convex> outlines = outlinesOf(shape);
    return isFinite(at) ? overlapping(world, outlines, at, which) : std::vector<BodyId>{};
}

std::optional<QueryPoint> closestPoint(const World& world, Vec2 point, Real maxDistance,
                                       CollisionFilter which) {
    std::optional<QueryPoint> best;
    if (!isFinite(point) || !(maxDistance >= 0)) {
        return best;
    }
    const Aabb box = withRounding(Aabb{point, point}.grown(maxDistance));
    forPartsIn(world, box, which, [&](const BodyView& body, std::size_t i) {
        const Nearness near = distance(body.part(i).convex, body.placement(), point);
        if (near.distance <= maxDistance && (!best || near.distance < best->distance)) {
            best = QueryPoint{body.id(), static_cast<std::uint16_t>(i), near.onA, near.normal,
                              near.distance};
        }
    });
    return best;
}

} // namespace kodo::inline KODO_PRECISION
