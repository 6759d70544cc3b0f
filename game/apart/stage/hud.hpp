// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// What the panel beside the field shows besides the game itself.
struct HudLook {
    std::string place;            // of the level among the others
    std::int32_t scoreBefore = 0; // of the levels before, in a row without end
    std::int32_t best = 0;        // score to beat; 0: none
    bool muted = false;
    const char* pilot = ""; // who plays, unless it is the player
};

void paintHud(Canvas& canvas, const Game& game, const HudLook& look);

/// What the level is about and how to begin, while a ball waits on the paddle.
void paintServeHint(Canvas& canvas, const Game& game);

/// 12345 -> "12 345".
std::string grouped(int number);

/// Cut into lines of at most that many letters, between words.
std::vector<std::string> wrapped(std::string_view text, std::size_t letters);

} // namespace apart
