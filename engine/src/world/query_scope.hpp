// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/query.hpp>

#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "bodies/part_filter.hpp"
#include "world/except_list.hpp"
#include "world/world_impl.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {

/// Half-width (m) by which searches grow their boxes for rounding errors, from the largest
/// coordinate of the query.
inline Real queryRounding(Vec2 a, Vec2 b) {
    constexpr Real kShare = sizeof(Real) == 4 ? Real(8e-6) : Real(8e-15);
    return kShare * std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
}

inline Aabb withRounding(const Aabb& box) {
    return box.grown(queryRounding(box.lower, box.upper));
}

/// A moving point against boxes: the fraction of its way at which it enters one.
class PathEntry {
public:
    /// The point moves from `from` to `to` (m); boxes are grown by `reach` on each side.
    PathEntry(Vec2 from, Vec2 to, Vec2 reach)
        : from_(from),
          perWay_{1 / (to.x - from.x), 1 / (to.y - from.y)},
          reach_(reach + queryRounding(from, to) * Vec2{1, 1}) {}

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
          parts_(world.impl().contactData().candidates()),
          which_(which),
          except_(bodies_, except) {
        refuse(checkFilter({which.flags & ~kNoSensors, which.required, which.group}));
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
        if (!visitAll(accepted)) {
            std::for_each(parts_.planes().begin(), parts_.planes().end(), accepted);
            parts_.trees().search(entry, accepted);
        }
    }
    /// The same for parts whose bounds overlap the box.
    template <typename Visit>
    void forPartsIn(const Aabb& box, Visit visit) const {
        const auto accepted = ifAsked(visit);
        if (!visitAll(accepted)) {
            std::for_each(parts_.planes().begin(), parts_.planes().end(), accepted);
            parts_.trees().overlaps(box, accepted);
        }
    }

private:
    /// False, without a visit, if there are trees. Steps without Feature::Collision keep none.
    template <typename Visit>
    bool visitAll(const Visit& visit) const {
        const bool all = bodies_.leftOut.has(Feature::Collision);
        for (std::uint32_t i = 0; all && i < parts_.bounds().size(); ++i) {
            if (parts_.bounds().isUsed(i)) {
                visit(i);
            }
        }
        return all;
    }
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
               ((filter.flags & kSensor) == 0 || (which_.flags & kNoSensors) == 0) &&
               !except_.contains(part.body);
    }

    const Bodies& bodies_;
    const CandidatePairs& parts_;
    CollisionFilter which_;
    mutable ExceptList except_;
};

inline bool isBefore(const QueryHit& a, const QueryHit& b) { // total order: each part is hit once
    return std::tie(a.fraction, a.body, a.part) < std::tie(b.fraction, b.body, b.part);
}

/// Keeps the first of all hits.
inline bool keepFirst(std::optional<QueryHit>& best, const QueryHit& hit) {
    const bool isFirst = !best || isBefore(hit, *best);
    best = isFirst ? hit : best;
    return isFirst;
}

inline Real limitOf(const std::optional<QueryHit>& best) {
    return best ? best->fraction : 1;
}

} // namespace KODO_PRECISION
} // namespace kodo
