// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace apart {

/// What must never happen in a game, looked for after each tick.
class Watch {
public:
    /// `game` has just been ticked.
    void look(const Game& game);

    std::uint32_t escapes = 0;     // balls that left the field other than below, or are not numbers
    std::uint32_t longestSlow = 0; // ticks in a row that a ball flew at less than half its speed
    std::uint32_t longestWait = 0; // ticks in a row without damage and without a block let go
    kodo::Real worstBend = 0; // sine of the turn in one tick of free flight that no field bends

private:
    struct Seen {
        kodo::BodyId body;
        kodo::Vec2 heading;
        std::uint32_t slow = 0;
    };

    void lookAtBall(const Game& game, const Ball& ball);

    std::uint32_t wait_ = 0;
    std::vector<Seen> before_; // the balls that flew after the last tick
    std::vector<Seen> now_;
};

/// Who holds the paddle in a soak.
enum class Player : std::uint8_t {
    Good,   // the bot
    Lazy,   // stays under the first ball
    Erratic // jumps about, presses every button
};
inline constexpr std::array<std::string_view, 3> kPlayerNames = {"good", "lazy", "erratic"};
Input inputOf(Player player, const Game& game);

/// Sums over many games. What is listed in `failures` names its game.
struct SoakReport {
    std::uint64_t ticks = 0;
    std::uint32_t games = 0;
    std::uint32_t won = 0;
    std::uint32_t escapes = 0;
    std::uint32_t longestSlow = 0; // ticks
    std::uint32_t longestWait = 0; // ticks
    kodo::Real worstBend = 0;
    std::uint64_t bounces = 0; // in the standard mode
    std::uint64_t bent = 0;    // see Ledger
    std::uint64_t thrown = 0;
    std::uint64_t alteredPure = 0; // both, in the pure mode; none
    std::vector<std::string> failures;
};

// Bounds that a soak holds games against.
inline constexpr std::uint32_t kLongestSlow = 240; // ticks; squeezed between rubble and walls
inline constexpr kodo::Real kMostBend = kodo::Real(2e-6); // rounding of one scaling and one step

/// Plays games until there were so many ticks: all levels, players and modes in turn, with rising
/// seeds, each at most kLongestSoakGame ticks.
SoakReport soak(std::span<const std::shared_ptr<const Level>> levels, std::uint64_t ticks,
                std::uint32_t seed);
inline constexpr std::uint32_t kLongestSoakGame = 36000; // 5 minutes

} // namespace apart
