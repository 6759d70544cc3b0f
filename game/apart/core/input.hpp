// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace apart {

/// The paddle's field of force: on balls, shards, parts and loose blocks.
enum class Force : std::uint8_t { None, Pull, Push };
inline constexpr std::array<std::string_view, 3> kForceNames = {"0", "pull", "push"};

/// All that a player can say in one tick. Integers, so that a replay is text and the device that
/// it came from no longer matters.
struct Input {
    std::int8_t paddle = 0;               // keys: -127..127 of the key speed, left to right
    std::optional<std::int16_t> target{}; // mouse: 1/1000 m from the middle; beats `paddle`
    bool launch = false;       // serve the ball that rides on the paddle; leap, with Power::Spring
    Force force = Force::None; // while the button is held

    friend bool operator==(const Input&, const Input&) = default;
};

} // namespace apart
