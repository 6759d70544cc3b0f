// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>

namespace kodo::inline KODO_PRECISION {

/// One of two that may meet.
struct Mover {
    std::uint32_t body;
    Real swing;      // m, of its outline: see Convex
    Real stopAt = 1; // share of the step
};

/// How far two outlines go at most towards each other within the step. What moves along with the
/// other goes hardly anywhere.
Real relativeMotion(const Bodies& bodies, const Mover& moverA, const Mover& moverB);

} // namespace kodo::inline KODO_PRECISION
