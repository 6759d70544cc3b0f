// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/vec2.hpp>

#include <cmath>
#include <numbers>

/// Angles of what is only looked at and heard, which may use the C library: no rule sees them.
namespace apart {

inline constexpr kodo::Real kTurn = 2 * std::numbers::pi_v<kodo::Real>; // rad, once around

/// Of unit length, at an angle (rad), counter-clockwise from +x.
inline kodo::Vec2 towards(kodo::Real angle) {
    return {std::cos(angle), std::sin(angle)};
}

} // namespace apart
