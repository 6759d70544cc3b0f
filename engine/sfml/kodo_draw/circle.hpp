// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_draw/values.hpp>

#include <cmath>
#include <numbers>

namespace kodo_draw {

/// Position of one corner of a regular polygon inscribed in a circle.
inline Pixel onCircle(Pixel center, float radius, int corner, int corners) {
    constexpr float kTurn = 2 * std::numbers::pi_v<float>;
    const float angle = kTurn * static_cast<float>(corner) / static_cast<float>(corners);
    return {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
}

} // namespace kodo_draw
