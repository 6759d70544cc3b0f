// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace apart {

/// One game of the bot, as the check of a level sees it.
struct BotRun {
    std::uint32_t seed = 0;
    std::uint32_t ticks = 0;
    Result result = Result::Playing;
    std::int32_t livesLost = 0;
    std::uint32_t longestWait = 0; // ticks in which no block took harm
    std::uint32_t faults = 0;      // halts, escapes, bent flights
    std::size_t mostBodies = 0;
    std::uint64_t work = 0; // visits of bodies and contacts, all ticks added up
};
/// Plays until the game ends, or that many ticks are over.
BotRun runBot(const Level& level, std::uint32_t seed, std::uint32_t mostTicks,
              BotKind kind = BotKind::Good);

struct LintOptions {
    std::uint32_t seeds = 1;                            // games of the bot, seeds 1, 2, ...
    std::uint32_t mostTicks = 5 * 60 * kTicksPerSecond; // of each
};

/// What the check of one level found.
struct LintReport {
    std::string level;
    int blocks = 0;                 // that can break
    std::vector<Cell> outOfReach{}; // of these
    std::uint32_t waitBound = 0;    // ticks until something is struck or gives way, at most
    std::uint32_t clearBound = 0;   // ticks until all is gone if nothing is struck or pulled off
    std::uint64_t workPerTick = 0;  // visits of bodies and contacts, mean of all games
    std::vector<BotRun> runs{};     // by seed
    std::vector<std::string> problems{}; // a sentence each

    bool passed() const { return problems.empty(); }
};

/// Blocks that can break, but that no ball can come to: a ball of the true size is moved from the
/// paddle through all the room that there is when every other block that can break is gone.
std::vector<Cell> outOfReach(const Level& level);

/// Is the level fit to be played? It is when every block can be reached, the bot wins each of its
/// games, and in these nobody waits beyond the bound, nothing happens that must not, and a tick is
/// cheap enough.
LintReport lint(const Level& level, const LintOptions& options = {});

} // namespace apart
