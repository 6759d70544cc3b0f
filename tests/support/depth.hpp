// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collide/collide.hpp>
#include <kodo/kodo.hpp>

namespace support {

/// How deep (m) any two bodies of one part lie in each other, of which one is not locked, by
/// separating axes.
inline kodo::Real deepest(const kodo::World& world) {
    kodo::Real depth = 0;
    const std::vector<kodo::BodyId> ids = world.bodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        for (std::size_t k = i + 1; k < ids.size(); ++k) {
            const kodo::BodyView a = world[ids[i]];
            const kodo::BodyView b = world[ids[k]];
            if ((a.flags() & b.flags() & kodo::kLocked) == 0 && overlap(a.bounds(), b.bounds())) {
                depth = std::max(depth, -separation(a.part(0).convex, a.placement(),
                                                    b.part(0).convex, b.placement())
                                             .distance);
            }
        }
    }
    return depth;
}

} // namespace support
