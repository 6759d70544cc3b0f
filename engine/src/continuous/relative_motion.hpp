// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// A body of a pair that may meet.
struct Mover {
    std::uint32_t body;
    Real rotationReach; // m, of its shape; see ConvexShape
    Real stopAt = 1;    // fraction of the step
};

/// Bound (m) of the motion of two shapes towards each other within the step. It is small for bodies
/// that move together.
Real relativeMotion(const Bodies& bodies, const Mover& moverA, const Mover& moverB);

} // namespace KODO_PRECISION
} // namespace kodo
