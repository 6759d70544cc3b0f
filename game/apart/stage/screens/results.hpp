// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/core/medals.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/records/run_statistics.hpp>

namespace apart {

/// Contents of the result screen.
struct ResultsLook {
    const Game& game;
    const RunStatistics& statistics;
    std::int32_t score = 0; // sum over an endless run, else the score of the game
    bool newBest = false;
    double seconds = 0;                  // since the screen appeared; drives the score counter
    std::span<const MedalMarks> marks{}; // empty: the game has no medals
};

void paintResults(Canvas& canvas, const ResultsLook& look);

/// The honours of a level, and which of them are won.
struct HonoursLook {
    Best best;
    const Level& level;
    const MedalMarks* marks; // nullptr: none
};

/// Paints the honours that a level and its marks offer, `step` apart. Those that are not won are
/// dim.
void paintHonours(Canvas& canvas, Vec2 place, Vec2 step, Real size, const HonoursLook& look);
/// Number of the first ones that most levels have: three; in one of too few blocks for a chain two.
std::size_t usualHonours(const Level& level);
/// Names of the honours, the usual ones first.
std::vector<std::string> honourNames(const Level& level, const MedalMarks* marks);
/// Which of these honours are won, in the same order.
std::vector<bool> honoursWon(const HonoursLook& look);

/// Paints a medal: bronze has one dot, silver two, gold three. Nothing for Medal::None.
void paintMedal(Canvas& canvas, Vec2 middle, Real size, Medal medal);

} // namespace apart
