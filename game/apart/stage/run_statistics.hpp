// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/profile.hpp>

namespace apart {

/// Statistics of one game, for the result screen.
struct RunStatistics {
    int bestCombo = 0;
    int cleared = 0;     // blocks that broke or fell
    int largestFall = 0; // most blocks of one collapse
    bool lifeLost = false;
    std::uint32_t ticks = 0; // until the end of the game

    /// Call after each tick of the game.
    void hear(const Game& game);
    Best bestOf(const Game& game) const;
};

} // namespace apart
