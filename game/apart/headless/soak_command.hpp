// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace apart {

inline constexpr std::uint64_t kMostSoaked = 1000000000000; // ticks
inline constexpr std::uint32_t kMostSeed = 1000000000;      // to begin a soak with

struct SoakCommand {
    std::vector<std::string> levels; // names; all of assets/levels unless given
    std::uint64_t ticks = 1000000;   // to be played in all
    std::uint32_t firstSeed = 1;
    std::uint32_t endless = 0;                 // endless levels for each seed, besides
    std::uint32_t longestGame = 10 * 60 * 120; // ticks
    std::optional<BotKind> player;             // each in turn unless given
    std::optional<Mode> mode;                  // the same
    bool json = false;
};

/// Lets the bot play level after level, seed after seed, until so many ticks are over, and looks
/// for what must never be. 1 when there was some, else 0.
int runSoak(const SoakCommand& command);

} // namespace apart
