// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <array>
#include <optional>
#include <string_view>

namespace apart {

/// Place and time at which a descending ball reaches the height of the dome. Only bounces off the
/// side walls are considered.
struct Arrival {
    kodo::Real x = 0;       // m
    kodo::Real seconds = 0; // from now
};

std::optional<Arrival> arrivalOf(const Game& game, const Ball& ball);
/// Of the ball that arrives first at the height of the dome `offset` (m) from its middle.
std::optional<Arrival> firstArrival(const Game& game, kodo::Real offset);

enum class BotKind : std::uint8_t {
    Good,    // aims: meets the ball where the dome sends it to a block
    Lazy,    // meets the ball with the middle of the dome
    Random,  // meets the ball with a random point of the dome
    Clumsy,  // uses keys, reacts late, misses at times
    Erratic, // as Good, with random moves and buttons
    Novice,  // as Clumsy, but sees the ball earlier and misses seldom
    Fair,    // as Clumsy, but follows the ball from the top, without a miss of its own
    Perfect, // as Good, but each shot is the surest one
    Absent,  // never moves, launches twice a second, and holds an aim and a force by the seed
    Planner, // tries its shots on copies of the game; needs a Player, else as Good
};
inline constexpr std::array<std::string_view, 10> kBotNames = {
    "good",   "lazy", "random",  "clumsy", "erratic",
    "novice", "fair", "perfect", "absent", "planner"};

/// The scale of skills by which the difficulty of levels is measured, from the lowest.
inline constexpr std::array<BotKind, 5> kSkills = {BotKind::Clumsy, BotKind::Novice, BotKind::Fair,
                                                   BotKind::Good, BotKind::Perfect};

/// Input of a bot, a function of the current state. It meets the ball that arrives first and serves
/// at once. Good also catches parts that do no harm, if time allows.
Input bot(const Game& game, BotKind kind = BotKind::Good);

} // namespace apart
