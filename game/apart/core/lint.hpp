// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace apart {

// A longer gap counts (ticks): 3 s.
inline constexpr std::uint32_t kQuietGap = 3 * kTicksPerSecond;

/// Times in which something did not happen.
struct Gaps {
    std::uint32_t longest = 0; // ticks
    std::uint32_t ticks = 0;   // in gaps longer than kQuietGap
};

/// Result of one game of a bot.
struct BotRun {
    std::uint32_t seed = 0;
    std::uint32_t ticks = 0;
    Result result = Result::Playing;
    std::int32_t score = 0;
    std::int32_t livesLost = 0;
    std::int32_t paddleHits = 0;       // of balls on the paddle
    std::int32_t largestFall = 0;      // blocks of one collapse
    std::uint32_t longestWait = 0;     // ticks without damage to a block
    Gaps quiet{};                      // without a crack, break, fall or catch
    Gaps uncleared{};                  // without a block that is cleared
    std::uint32_t largestFallTick = 0; // at which its last block fell
    std::uint32_t firstHit = 0;        // ticks from the first serve to the first hit of a block
    std::uint32_t faults = 0;          // halts, escapes, bent paths
    std::size_t mostBodies = 0;
    std::uint32_t ways = 0; // bits, see WayWatch::ways(); 0 if it is not won
    double cleared = 0;     // 0..1, share of the blocks that broke or fell
    std::uint64_t work = 0; // bodies and contacts visited, summed over all ticks
};

/// Plays until the game ends or `mostTicks` have passed.
BotRun runBot(const Level& level, std::uint32_t seed, std::uint32_t mostTicks,
              BotKind kind = BotKind::Good);

struct LintOptions {
    std::uint32_t seeds = 1;                            // number of games, each with its seed
    std::uint32_t firstSeed = 1;                        // of the first game; then one more, ...
    std::uint32_t mostTicks = 5 * 60 * kTicksPerSecond; // of each game
};

/// What the check of one level found.
struct LintReport {
    std::string level;
    int blocks = 0;                      // breakable
    std::vector<Cell> outOfReach{};      // breakable blocks that no ball reaches
    std::uint32_t waitBound = 0;         // ticks; limit of the time without damage
    std::uint32_t clearBound = 0;        // ticks; limit of the time to clear the level without hits
    std::uint64_t workPerTick = 0;       // bodies and contacts visited, mean of all games
    std::vector<BotRun> runs{};          // by seed
    std::vector<std::string> problems{}; // one sentence each
    std::vector<std::string> warnings{}; // likewise; the level passes with them

    bool passed() const { return problems.empty(); }
};

/// Breakable blocks that no ball can reach. The test is a flood fill from the paddle by a ball of
/// true size, with all breakable blocks removed.
std::vector<Cell> outOfReach(const Level& level);

/// Checks that a level is playable. Every block of the grid and some block of a building must be
/// reachable, the letters of ways must stand for blocks, no standing block may move in a minute
/// without a player, and the bot must win each game.
/// No game may exceed the wait bound or contain a fault, and the mean work per tick is limited.
/// Warns of characters in its texts that the typefaces lack.
LintReport lint(const Level& level, const LintOptions& options = {});

} // namespace apart
