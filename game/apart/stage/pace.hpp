// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/player_settings.hpp>

namespace apart {

/// How fast the game's time runs on the screen: slowly when a ball is about to meet the last block,
/// and not at all for a moment at a hard blow. Ticks come later, but they are the same ticks.
class Pace {
public:
    /// The pace of this frame: 1 is real time.
    double next(const Game& game, double seconds);
    /// After each tick.
    void feel(const Game& game, const Settings& settings);

private:
    double pace_ = 1;
    double slow_ = 0;   // s spent slowly; there is an end to patience
    double frozen_ = 0; // s still to wait
    double rest_ = 0;   // s until time may freeze again
};

} // namespace apart
