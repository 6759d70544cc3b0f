// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

namespace apart {

/// How fast the game's time runs on the screen: slowly when a ball is about to meet the last block.
/// Ticks come later, but they are the same ticks.
class Pace {
public:
    /// The pace of this frame: 1 is real time.
    double next(const Game& game, double seconds);

private:
    double pace_ = 1;
    double slow_ = 0; // s spent slowly; there is an end to patience
};

} // namespace apart
