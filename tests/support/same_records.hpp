// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world/world.hpp>

#include <algorithm>
#include <tuple>

namespace support::inline KODO_PRECISION {

using kodo::CollisionRecord;
using kodo::World;

/// Do two Worlds report the same of their last step, to the bit?
inline bool sameRecords(const World& a, const World& b) {
    const auto same = [](const CollisionRecord& r, const CollisionRecord& s) {
        const auto all = [](const CollisionRecord& x) {
            return std::tuple(x.a, x.b, x.partA, x.partB, x.phase, x.pointCount, x.point.x,
                              x.point.y, x.normal.x, x.normal.y, x.separation, x.approachSpeed,
                              x.maxImpulse, x.totalImpulse);
        };
        return all(r) == all(s);
    };
    return std::equal(a.collisions().begin(), a.collisions().end(), b.collisions().begin(),
                      b.collisions().end(), same);
}

} // namespace support::inline KODO_PRECISION
