// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/world.hpp>

#include <algorithm>
#include <tuple>

namespace support {
inline namespace KODO_PRECISION {

using kodo::CollisionRecord;
using kodo::World;

/// True if two worlds report bitwise equal records of their last step.
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

} // namespace KODO_PRECISION
} // namespace support
