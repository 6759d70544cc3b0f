// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <array>
#include <optional>
#include <string_view>

namespace apart {

/// Where and when a ball that flies down will reach the height of the dome, bouncing off the side
/// walls alone.
struct Arrival {
    kodo::Real x = 0;       // m
    kodo::Real seconds = 0; // from now
};

std::optional<Arrival> arrivalOf(const Game& game, const Ball& ball);

enum class BotKind : std::uint8_t {
    Good,    // meets the ball with the spot of the dome that sends it to a block
    Lazy,    // goes where the ball comes down, and no farther: always the middle of the dome
    Random,  // meets it anywhere on the dome
    Clumsy,  // plays by keys, looks late and misses now and then: tells how hard a level is
    Erratic, // good, but jumps about and presses every button
};
inline constexpr std::array<std::string_view, 5> kBotNames = {"good", "lazy", "random", "clumsy",
                                                              "erratic"};

/// A player: a function of the game as it is. It meets the ball that comes first and serves at
/// once. The good one also catches parts when there is time, unless they do harm.
Input bot(const Game& game, BotKind kind = BotKind::Good);

} // namespace apart
