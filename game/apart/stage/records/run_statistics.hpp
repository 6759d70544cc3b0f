// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/core/medals.hpp>
#include <apart/core/way_watch.hpp>
#include <apart/stage/records/profile.hpp>

namespace apart {

/// Points of a game by their source. They add up to its score.
struct ScoreParts {
    std::int32_t broken = 0; // blocks hit to pieces, combo included
    std::int32_t fallen = 0; // blocks that fell, of buildings times those of the same collapse
    std::int32_t caught = 0; // parts
    std::int32_t lives = 0;  // balls left at the end
    std::int32_t prize = 0;  // for the best blow
    std::int32_t spared = 0; // Level::keep

    std::int32_t sum() const { return broken + fallen + caught + lives + prize + spared; }
};

/// Statistics of one game, for the result screen.
struct RunStatistics {
    ScoreParts points;
    WayWatch way;
    int broken = 0; // blocks
    int fallen = 0;
    int caught = 0;   // parts
    int lastFall = 0; // blocks of the last collapse
    std::uint32_t lastFallTick = 0;
    int bestCombo = 0;
    int cleared = 0;     // blocks that broke or fell
    int largestFall = 0; // most blocks of one collapse
    bool lifeLost = false;
    bool keptAtEnd = false;  // GameState::keeps() in the last tick of the game
    std::uint32_t ticks = 0; // until the end of the game

    /// Call after each tick of the game.
    void update(const Game& game);
    /// Its result; `marks` of the level, or nullptr.
    Best bestOf(const Game& game, const MedalMarks* marks = nullptr) const;
    /// This game as a part of the player's totals.
    PlayTotals totalsOf(const Game& game) const;
};

} // namespace apart
