// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/profile.hpp>

namespace apart {

/// What is counted of one game, for its result.
struct Tally {
    int bestCombo = 0;
    int broken = 0; // blocks
    bool lifeLost = false;
    std::uint32_t ticks = 0; // until the game ended

    /// After each tick of the game.
    void hear(const Game& game);
    Best bestOf(const Game& game) const;
};

} // namespace apart
