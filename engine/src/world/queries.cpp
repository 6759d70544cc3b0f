// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo/query.hpp>

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "bodies/part_filter.hpp"
#include "world/except_list.hpp"
#include "world/query_checks.hpp"
#include "world/world_impl.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Half-width (m) by which searches grow their boxes for rounding errors, from the largest
/// coordinate of the query.
Real roundingOf(Vec2 a, Vec2 b) {
    constexpr Real kShare = sizeof(Real) == 4 ? Real(8e-6) : Real(8e-15);
    return kShare * std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
}

Aabb withRounding(const Aabb& box) {
    return box.grown(roundingOf(box.lower, box.upper));
}

/// A moving point against boxes: the fraction of its way at which it enters one.
class PathEntry {
public:
    /// The point moves from `from` to `to` (m); boxes are grown by `reach` on each side.
    PathEntry(Vec2 from, Vec2 to, Vec2 reach)
        : from_(from),
          perWay_{1 / (to.x - from.x), 1 / (to.y - from.y)},
          reach_(reach + roundingOf(from, to) * Vec2{1, 1}) {}

    /// BoundsTrees::kMissed if that is beyond `limit`.
    Real operator()(const Aabb& box, Real limit) const {
        const Range x = along(box.lower.x - reach_.x, box.upper.x + reach_.x, from_.x, perWay_.x);
        const Range y = along(box.lower.y - reach_.y, box.upper.y + reach_.y, from_.y, perWay_.y);
        const Real first = std::max({x.first, y.first, Real(0)});
        return first <= std::min({x.last, y.last, limit}) ? first : BoundsTrees::kMissed;
    }

private:
    struct Range {
        Real first;
        Real last;
    };
    static Range along(Real lower, Real upper, Real from, Real perWay) {
        if (!std::isfinite(perWay)) { // no way along this axis
            return lower <= from && from <= upper ? Range{0, 1} : Range{1, 0};
        }
        const Real a = (lower - from) * perWay;
        const Real b = (upper - from) * perWay;
        return a < b ? Range{a, b} : Range{b, a};
    }

    Vec2 from_;
    Vec2 perWay_; // 1/m
    Vec2 reach_;  // m
};

/// The bodies that a query visits.
class QueryScope {
public:
    QueryScope(const World& world, CollisionFilter which, std::span<const BodyId> except)
        : bodies_(world.impl().bodyData()),
          parts_(world.impl().partData()),
          which_(which),
          except_(bodies_, except) {
        refuse(checkFilter(which));
    }

    BodyId idOf(std::uint32_t body) const { return bodies_.idAt(body); }
    const ConvexShape& convex(std::uint32_t body, std::uint32_t part) const {
        return bodies_.convex(body, part);
    }
    const Transform& pose(std::uint32_t body) const { return bodies_.pose[body]; }

    /// Calls visit(body, part) for parts whose bounds have entry(box) < BoundsTrees::kMissed, in
    /// unspecified order; for planes always.
    template <typename Entry, typename Visit>
    void forParts(Entry entry, Visit visit) const {
        const auto accepted = ifAsked(visit);
        std::for_each(parts_.planes().begin(), parts_.planes().end(), accepted);
        parts_.trees().search(entry, accepted);
    }
    /// The same for parts whose bounds overlap the box.
    template <typename Visit>
    void forPartsIn(const Aabb& box, Visit visit) const {
        const auto accepted = ifAsked(visit);
        std::for_each(parts_.planes().begin(), parts_.planes().end(), accepted);
        parts_.trees().overlaps(box, accepted);
    }

private:
    template <typename Visit>
    auto ifAsked(Visit& visit) const {
        return [&](std::uint32_t i) {
            const PartBounds::Part& part = parts_.bounds().part(i);
            if (isAsked(part)) {
                visit(part.body, part.part);
            }
        };
    }
    bool isAsked(const PartBounds::Part& part) const {
        const CollisionFilter filter = filterOf(bodies_, part.body, part.part);
        return (filter.flags & kDisabled) == 0 && accepts(which_, filter) &&
               !except_.contains(part.body);
    }

    const Bodies& bodies_;
    const CandidatePairs& parts_;
    CollisionFilter which_;
    mutable ExceptList except_;
};

bool isBefore(const QueryHit& a, const QueryHit& b) { // total order: each part is hit once
    return std::tie(a.fraction, a.body, a.part) < std::tie(b.fraction, b.body, b.part);
}

/// Keeps the first of all hits.
void keepFirst(std::optional<QueryHit>& best, const QueryHit& hit) {
    if (!best || isBefore(hit, *best)) {
        best = hit;
    }
}

Real limitOf(const std::optional<QueryHit>& best) {
    return best ? best->fraction : 1;
}

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
    requireRay(world, from, to);
    const QueryScope scope(world, which, except);
    const PathEntry path(from, to, {});
    scope.forParts([&](const Aabb& box) { return path(box, 1); },
                   [&](std::uint32_t body, std::uint32_t part) {
                       if (const auto hit = hitOf(scope, body, part, {from, to})) {
                           hits.push_back(*hit);
                       }
                   });
    std::sort(hits.begin(), hits.end(), isBefore); // total order: see isBefore
    return hits;
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

std::optional<QueryHit> shapeCast(const World& world, const Shape& shape, const Transform& start,
                                  Vec2 displacement, CollisionFilter which,
                                  std::span<const BodyId> except) {
    std::optional<QueryHit> best;
    const std::vector<ConvexShape> convexes = requireShape(world, shape, "start", start);
    requireDisplacement(world, convexes, start, displacement);
    const QueryScope scope(world, which, except);
    for (const ConvexShape& convex : convexes) {
        const Aabb box = boundsOf(convex, start);
        const PathEntry path(box.center(), box.center() + displacement, Real(0.5) * box.extent());
        scope.forParts([&](const Aabb& other) { return path(other, limitOf(best)); },
                       [&](std::uint32_t body, std::uint32_t part) {
                           const auto hit = shapeCast(convex, start, displacement,
                                                      scope.convex(body, part), scope.pose(body));
                           if (hit) {
                               keepFirst(best, {scope.idOf(body), static_cast<std::uint16_t>(part),
                                                hit->fraction, hit->point, hit->normal});
                           }
                       });
    }
    return best;
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
    const Real rounding = roundingOf(point, point);
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
