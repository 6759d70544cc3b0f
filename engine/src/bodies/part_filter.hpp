// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <cstddef>

namespace kodo {
inline namespace KODO_PRECISION {

/// The filter that counts for a part, with the engine's flags of its body.
inline CollisionFilter filterOf(const Bodies& bodies, std::size_t body, std::size_t part) {
    const CollisionFilter& ofBody = bodies.filter[body];
    if (!bodies.changes.partFilters || !bodies.parts[body][part].filter) {
        return ofBody;
    }
    CollisionFilter own = *bodies.parts[body][part].filter;
    own.flags |= ofBody.flags & ~(kUserFlags | kMatchModes | kSensor);
    return own;
}

} // namespace KODO_PRECISION
} // namespace kodo
