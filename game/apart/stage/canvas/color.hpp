// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace apart {

/// Red, green, blue and opacity, 0..255 each.
struct Color {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;

    friend constexpr bool operator==(Color, Color) = default;
};

/// Linear interpolation: a at share 0, b at share 1.
constexpr Color mix(Color a, Color b, float share) {
    const float s = std::clamp(share, 0.0f, 1.0f);
    const auto blend = [s](std::uint8_t from, std::uint8_t to) {
        const float value = static_cast<float>(from) + s * static_cast<float>(to - from);
        return static_cast<std::uint8_t>(value + 0.5f);
    };
    return {blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b), blend(a.a, b.a)};
}

constexpr Color lighter(Color color, float share) {
    return mix(color, {255, 255, 255, color.a}, share);
}

constexpr Color darker(Color color, float share) {
    return mix(color, {0, 0, 0, color.a}, share);
}

/// Multiplies the opacity by `share`.
constexpr Color faded(Color color, float share) {
    color.a =
        static_cast<std::uint8_t>(static_cast<float>(color.a) * std::clamp(share, 0.0f, 1.0f));
    return color;
}

} // namespace apart
