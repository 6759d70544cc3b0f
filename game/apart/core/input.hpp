// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace apart {

/// Force field of the paddle. It acts on balls, shards, parts, and loose or hanging blocks.
enum class Force : std::uint8_t { None, Pull, Push };
inline constexpr std::array<std::string_view, 3> kForceNames = {"0", "pull", "push"};

/// Player input of one tick. Integers, so that text reproduces it exactly, whatever the device.
struct Input {
    std::int8_t paddle = 0;               // keys: -127 (left) to 127, in 1/127 of kKeySpeed
    std::optional<std::int16_t> target{}; // mouse: x in 1/1000 m; overrides `paddle`
    bool launch = false;                  // serves a riding ball; leaps, with Power::Spring
    Force force = Force::None;            // active while its button is held
    std::optional<std::int16_t> aim{};    // direction of the serve, x/y in 1/1000; it holds until
                                          // the next one

    friend bool operator==(const Input&, const Input&) = default;
};

} // namespace apart
