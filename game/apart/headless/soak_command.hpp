// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace apart {

inline constexpr std::uint64_t kMostSoaked = 1000000000000; // ticks
inline constexpr std::uint32_t kMostSeed = 1000000000;      // largest first seed

struct SoakCommand {
    std::vector<std::string> levels; // names; empty: all of assets/levels
    std::uint64_t ticks = 1000000;   // in total
    std::uint32_t firstSeed = 1;
    std::uint32_t endless = 0;                 // additional endless levels for each seed
    std::uint32_t longestGame = 10 * 60 * 120; // ticks
    std::optional<BotKind> player;             // nullopt: each but the planner in turn
    std::optional<Mode> mode;                  // nullopt: each in turn
    bool json = false;
};

/// Plays all levels with the bot, seed by seed, until `ticks` have passed, and checks each game
/// with GameObserver. Returns 1 if a check failed, else 0.
int runSoak(const SoakCommand& command);

} // namespace apart
