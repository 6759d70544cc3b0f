// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas.hpp>
#include <apart/stage/tally.hpp>

namespace apart {

/// What is said after a game.
struct ResultsLook {
    const Game& game;
    const Tally& tally;
    std::int32_t score = 0; // of an endless run, all its levels; else the game's
    Best before{};          // what was won of this level before this game
    bool newBest = false;
    double seconds = 0; // since it came up: the score counts up
};

void paintResults(Canvas& canvas, const ResultsLook& look);

/// The three signs of what can be won in a level, one step apart: dim where it has not been.
void paintHonours(Canvas& canvas, Vec2 place, Vec2 step, Real size, Best best);

} // namespace apart
