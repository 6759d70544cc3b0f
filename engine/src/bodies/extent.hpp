// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/real.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kodo {
inline namespace KODO_PRECISION {

/// Sizes from the body geometry, contiguous for loops over many bodies.
struct Extent {
    Real rotationReach = 0; // m; see ConvexShape::rotationReach()
    Real coreRadius = 0;    // m; smallest of all parts

    /// 1 for a body with a point or a line, else 0.
    std::size_t thin() const { return coreRadius > 0 ? 0 : 1; }
    /// Bound (m) of the displacement of any point of the core by a turn (rad): the chord is not
    /// longer than the arc, nor than the diameter.
    Real reachOfTurn(Real angle) const {
        return std::min(std::abs(angle), Real(2)) * rotationReach;
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
