// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/math/lanes.hpp>

#include <cstddef>
#include <cstdint>

/// How passes over blocks read and write the bodies. Internal linkage throughout, for the reason
/// that lanes.hpp gives.
namespace kodo::inline KODO_PRECISION {
namespace { // NOLINT: see above

/// The first half of Motion: velocity x, y, angular velocity, 1/mass.
KODO_LANES_INLINE Real* firstHalf(Motion* motion) {
    return &motion->velocity.x;
}
/// The second half: move x, y, turn, 1/inertia.
KODO_LANES_INLINE const Real* secondHalf(const Motion* motion) {
    return &motion->move.x;
}

/// Writes the speeds back of those that can be pushed. The others are left alone: another thread
/// may be reading them.
KODO_LANES_INLINE void putBack(Motion* motion, const std::uint32_t* index, const Quad& speed,
                               std::uint8_t moves, int at) {
    constexpr unsigned kAll = (1u << kLanes) - 1;
    const unsigned which = static_cast<unsigned>(moves) >> at & kAll;
    if (which == kAll) {
        scatter(firstHalf(motion), index, speed);
    } else if (which != 0) {
        scatterSome({firstHalf(motion), index}, speed.x, speed.y, speed.z, speed.w, which);
    }
}

} // namespace
} // namespace kodo::inline KODO_PRECISION
