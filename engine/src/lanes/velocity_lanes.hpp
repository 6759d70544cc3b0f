// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "math/lanes.hpp"

#include <cstdint>

/// Access of the passes over blocks to the bodies. Internal linkage throughout; lanes.hpp gives the
/// reason.
namespace kodo {
inline namespace KODO_PRECISION {
namespace { // NOLINT: see above

/// The first half of BodyVelocity: velocity x, y, angular velocity, 1/mass.
KODO_LANES_INLINE Real* firstHalf(BodyVelocity* motion) {
    return &motion->velocity.x;
}
/// The second half: deltaPosition x, y, deltaAngle, 1/inertia.
KODO_LANES_INLINE const Real* secondHalf(const BodyVelocity* motion) {
    return &motion->deltaPosition.x;
}

/// Stores the velocities of bodies that are not locked. Locked bodies are not written, since
/// another thread may be reading them.
KODO_LANES_INLINE void putBack(BodyVelocity* motion, const std::uint32_t* index, const Quad& speed,
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
} // namespace KODO_PRECISION
} // namespace kodo
