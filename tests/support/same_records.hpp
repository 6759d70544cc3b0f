// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

namespace support {
inline namespace KODO_PRECISION {

using kodo::CollisionRecord;
using kodo::World;

/// True if two lists have bitwise equal records in the same order.
inline bool sameRecords(std::span<const CollisionRecord> one,
                        std::span<const CollisionRecord> other) {
    const auto same = [](const CollisionRecord& r, const CollisionRecord& s) {
        const auto all = [](const CollisionRecord& x) {
            const auto& [p, q] = x.points;
            return std::tuple(p.position.x, p.position.y, p.separation, p.maxImpulse, q.position.x,
                              q.position.y, q.separation, q.maxImpulse, x.a, x.b, x.partA, x.partB,
                              x.phase, x.pointCount, x.point.x, x.point.y, x.normal.x, x.normal.y,
                              x.separation, x.approachSpeed, x.maxImpulse, x.totalImpulse,
                              x.tangentImpulse);
        };
        return all(r) == all(s);
    };
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), same);
}

/// True if two worlds report bitwise equal records of their last step.
inline bool sameRecords(const World& a, const World& b) {
    return sameRecords(a.begunCollisions(), b.begunCollisions()) &&
           sameRecords(a.endedCollisions(), b.endedCollisions()) &&
           sameRecords(a.collisions(), b.collisions());
}

/// The records of a list for which accept(record) is true.
template <typename Accept>
std::vector<CollisionRecord> recordsWith(std::span<const CollisionRecord> all, Accept accept) {
    std::vector<CollisionRecord> some;
    std::copy_if(all.begin(), all.end(), std::back_inserter(some), accept);
    return some;
}

} // namespace KODO_PRECISION
} // namespace support
