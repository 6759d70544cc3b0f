// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo/query.hpp>

#include "world/query_checks.hpp"
#include "world/query_scope.hpp"

#include <algorithm>
#include <span>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

std::optional<QueryHit> hitOf(const QueryScope& scope, std::uint32_t body, std::uint32_t part,
                              const Ray& ray) {
    const auto hit = rayCast(scope.convex(body, part), scope.pose(body), ray);
    if (!hit) {
        return std::nullopt;
    }
    return QueryHit{scope.idOf(body), static_cast<std::uint16_t>(part), hit->fraction,
                    ray.at(hit->fraction), hit->normal};
}

/// A part whose bounds a query reaches.
struct Candidate {
    Real entry = 0; // fraction at which a ray enters the bounds
    std::uint32_t body = 0;
    std::uint32_t part = 0;
};

/// Visits overlapping bodies in order, each once. overlapsSurely(convex, pose) may return true for
/// parts that need no exact test.
template <typename Surely, typename Visit>
void forOverlapping(const QueryScope& scope, std::span<const ConvexShape> convexes,
                    const Transform& at, Surely overlapsSurely, Visit visit) {
    struct PartPair {
        std::uint32_t body;
        std::uint32_t part;
        std::uint32_t convex;
    };
    SmallVector<PartPair, 32> pairs;
    for (std::uint32_t i = 0; i < convexes.size(); ++i) {
        scope.forPartsIn(withRounding(boundsOf(convexes[i], at)),
                         [&](std::uint32_t body, std::uint32_t part) {
                             pairs.push_back({body, part, i});
                         });
    }
    std::sort(pairs.begin(), pairs.end(), // total order: pairs are distinct
              [](const PartPair& a, const PartPair& b) {
                  return std::tie(a.body, a.part, a.convex) < std::tie(b.body, b.part, b.convex);
              });
    for (std::size_t i = 0; i < pairs.size();) {
        const PartPair& pair = pairs[i++];
        const ConvexShape& convex = scope.convex(pair.body, pair.part);
        const Transform& pose = scope.pose(pair.body);
        if (!overlapsSurely(convex, pose) &&
            distance(convex, pose, convexes[pair.convex], at).distance > 0) {
            continue;
        }
        if (!visit(scope.idOf(pair.body))) {
            return;
        }
        while (i < pairs.size() && pairs[i].body == pair.body) {
            ++i;
        }
    }
}

bool unsure(const ConvexShape&, const Transform&) {
    return false;
}

template <typename Surely>
std::vector<BodyId> overlapping(const QueryScope& scope, std::span<const ConvexShape> convexes,
                                const Transform& at, Surely overlapsSurely) {
    std::vector<BodyId> found;
    forOverlapping(scope, convexes, at, overlapsSurely, [&](BodyId id) {
        found.push_back(id);
        return true;
    });
    return found;
}

} // namespace

std::optional<QueryHit> rayCast(const World& world, Vec2 from, Vec2 to, CollisionFilter which,
                                std::span<const BodyId> except) {
    std::optional<QueryHit> best;
    requireRay(world, from, to);
    const QueryScope scope(world, which, except);
    const PathEntry path(from, to, {});
    scope.forParts([&](const Aabb& box) { return path(box, limitOf(best)); },
                   [&](std::uint32_t body, std::uint32_t part) {
                       if (const auto hit = hitOf(scope, body, part, {from, to})) {
                           keepFirst(best, *hit);
                       }
                   });
    return best;
}

std::vector<QueryHit> rayCastAll(const World& world, Vec2 from, Vec2 to, CollisionFilter which,
                                 std::span<const BodyId> except) {
    std::vector<QueryHit> hits;
    const auto take = [&](const QueryHit& hit) {
        hits.push_back(hit);
        return true;
    };
    visitRay(world, from, to, take, which, except);
    return hits;
}

std::vector<RaySpan> raySpans(const World& world, Vec2 from, Vec2 to, CollisionFilter which,
                              std::span<const BodyId> except) {
    std::vector<RaySpan> spans;
    for (const QueryHit& entry : rayCastAll(world, from, to, which, except)) {
        const ConvexShape& convex = world.impl().bodyData().convex(entry.body.index, entry.part);
        const Transform& pose = world.impl().bodyData().pose[entry.body.index];
        RaySpan span{entry, entry.fraction, entry.point, entry.normal};
        if (contains(convex, pose, to)) {
            span = {entry, 1, to, {}};
        } else if (const auto back =
                       rayCast(convex, pose, Ray{to, from})) { // leaves where it enters
            const Real fraction = std::max(1 - back->fraction, entry.fraction);
            span = {entry, fraction, Ray{to, from}.at(back->fraction), back->normal};
        }
        spans.push_back(span);
    }
    return spans;
}

void visitRay(const World& world, Vec2 from, Vec2 to,
              const std::function<bool(const QueryHit&)>& visit, CollisionFilter which,
              std::span<const BodyId> except) {
    requireVisitor(visit);
    requireRay(world, from, to);
    const QueryScope scope(world, which, except);
    const PathEntry path(from, to, {});
    std::vector<Candidate> near;
    scope.forParts([&](const Aabb& box) { return path(box, 1); },
                   [&](std::uint32_t body, std::uint32_t part) {
                       const Aabb box = boundsOf(scope.convex(body, part), scope.pose(body));
                       const Real entry = path(box, 1);
                       if (entry < BoundsTrees::kMissed) {
                           near.push_back({entry, body, part});
                       }
                   });
    std::sort(near.begin(), near.end(), // total order: parts are distinct
              [](const Candidate& a, const Candidate& b) {
                  return std::tie(a.entry, a.body, a.part) < std::tie(b.entry, b.body, b.part);
              });
    const ChangeGuard::Visit visiting(world.impl().guard());
    std::vector<QueryHit> hits; // a heap: the first one on top
    const auto isBehind = [](const QueryHit& a, const QueryHit& b) { return isBefore(b, a); };
    std::size_t next = 0;
    while (next < near.size() || !hits.empty()) {
        if (next < near.size() && (hits.empty() || near[next].entry <= hits.front().fraction)) {
            if (const auto hit = hitOf(scope, near[next].body, near[next].part, {from, to})) {
                hits.push_back(*hit);
                std::push_heap(hits.begin(), hits.end(), isBehind);
            }
            ++next;
            continue;
        }
        std::pop_heap(hits.begin(), hits.end(), isBehind);
        const QueryHit hit = hits.back();
        hits.pop_back();
        if (!visit(hit)) {
            return;
        }
    }
}

std::vector<BodyId> overlap(const World& world, const Aabb& box, CollisionFilter which,
                            std::span<const BodyId> except) {
    requireBox(world, box);
    // Relative to the box's own centre, for precision far from the origin. A box without width or
    // height is a line; one without both is a point.
    const Vec2 center = box.center();
    const Vec2 half = Real(0.5) * box.extent();
    Primitive primitive = Point{};
    if (half.x > 0 && half.y > 0) {
        primitive = Box{2 * half.x, 2 * half.y, {}, {}, {}};
    } else if (half.x > 0 || half.y > 0) {
        primitive = Segment{-half, half};
    }
    const ConvexShape convex = convexShapeOf(primitive, {});
    const auto hasCornerInside = [&](const ConvexShape& part, const Transform& pose) {
        return !part.isPlane() &&
               std::any_of(part.vertices.begin(), part.vertices.end(),
                           [&](Vec2 vertex) { return box.contains(pose * vertex); });
    };
    return overlapping(QueryScope(world, which, except), {&convex, 1}, {center, {}},
                       hasCornerInside);
}

std::vector<BodyId> overlap(const World& world, const Shape& shape, const Transform& at,
                            CollisionFilter which, std::span<const BodyId> except) {
    const std::vector<ConvexShape> convexes = requireShape(world, shape, "at", at);
    return overlapping(QueryScope(world, which, except), convexes, at, unsure);
}

void visitOverlaps(const World& world, const Shape& shape, const Transform& at,
                   const std::function<bool(BodyId)>& visit, CollisionFilter which,
                   std::span<const BodyId> except) {
    requireVisitor(visit);
    const std::vector<ConvexShape> convexes = requireShape(world, shape, "at", at);
    const ChangeGuard::Visit visiting(world.impl().guard());
    forOverlapping(QueryScope(world, which, except), convexes, at, unsure, visit);
}

std::optional<QueryPoint> closestPoint(const World& world, Vec2 point, Real maxDistance,
                                       CollisionFilter which, std::span<const BodyId> except) {
    std::optional<QueryPoint> best;
    requirePoint(world, "point", point);
    requireDistance(maxDistance);
    const QueryScope scope(world, which, except);
    const Real rounding = queryRounding(point, point);
    const auto entry = [&](const Aabb& box) {
        const Vec2 near{std::clamp(point.x, box.lower.x, box.upper.x),
                        std::clamp(point.y, box.lower.y, box.upper.y)};
        const Real least = length(near - point) - rounding;
        return least <= (best ? best->distance : maxDistance) ? least : BoundsTrees::kMissed;
    };
    scope.forParts(entry, [&](std::uint32_t body, std::uint32_t part) {
        const ClosestPoints near = distance(scope.convex(body, part), scope.pose(body), point);
        const BodyId id = scope.idOf(body);
        const auto number = static_cast<std::uint16_t>(part);
        if (near.distance <= maxDistance &&
            (!best || std::tie(near.distance, id, number) <
                          std::tie(best->distance, best->body, best->part))) {
            best = QueryPoint{id, number, near.onA, near.normal, near.distance};
        }
    });
    return best;
}

} // namespace KODO_PRECISION
} // namespace kodo
