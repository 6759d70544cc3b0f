// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/geometry.hpp>
#include <kodo/kodo.hpp>

namespace support {

/// Largest overlap (m) of any two single-part bodies of which at least one is dynamic, by
/// separating axes.
inline kodo::Real maxOverlap(const kodo::World& world) {
    kodo::Real depth = 0;
    const std::vector<kodo::BodyId> ids = world.bodies();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        for (std::size_t k = i + 1; k < ids.size(); ++k) {
            const kodo::BodyView a = world[ids[i]];
            const kodo::BodyView b = world[ids[k]];
            const bool dynamic =
                a.type() == kodo::BodyType::Dynamic || b.type() == kodo::BodyType::Dynamic;
            if (dynamic && overlap(a.bounds(), b.bounds())) {
                depth = std::max(depth, -separation(a.part(0).convex, a.massFrame(),
                                                    b.part(0).convex, b.massFrame())
                                             .distance);
            }
        }
    }
    return depth;
}

} // namespace support
