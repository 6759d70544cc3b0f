// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math.hpp>

#include <cmath>
#include <numbers>

/// Angles for picture and sound. The C library is allowed here: no game rule depends on the
/// results.
namespace apart {

inline constexpr kodo::Real kTurn = 2 * std::numbers::pi_v<kodo::Real>; // rad, a full turn

/// Unit vector at an angle (rad), counter-clockwise from +x.
inline kodo::Vec2 towards(kodo::Real angle) {
    return {std::cos(angle), std::sin(angle)};
}

} // namespace apart
