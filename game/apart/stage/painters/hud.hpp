// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/bindings.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// An honour of a level beside the ways down, and whether the game has it so far.
struct HudHonour {
    std::string name;
    bool kept = false;
};

/// Contents of the side panel that are not part of the game.
struct HudLook {
    std::string place;            // number of the level, or the endless row
    std::int32_t scoreBefore = 0; // of the previous endless levels
    std::int32_t best = 0;        // score to beat; 0: none
    std::string medal{};          // the next one, and its score; empty: none
    std::uint32_t ticks = 0;      // since the start, up to the end of the game
    std::vector<HudHonour> honours{};
    Bindings keys{};
    std::uint32_t ways = 0; // bits, of the largest fall so far, see WayWatch
    bool muted = false;
    bool takenOver = false; // from a replay
    std::string pilot{};    // label of the player in control; empty: the human player
    std::string foot{};     // last line of the panel; empty: the key that pauses
};

void paintHud(Canvas& canvas, const Game& game, const HudLook& look);

/// Level hint and serve instructions, shown while a ball rides on the paddle.
void paintServeHint(Canvas& canvas, const Game& game, const Bindings& keys);

/// A bar that is filled from the left, 0..1.
void paintBar(Canvas& canvas, const Aabb& where, Real share, Color color);

/// The balls in a row that begins at a point: the one in play first and larger, then those in
/// reserve, closer to each other where there are many. `room`: m, of the row; `step`: m, between
/// two of few.
void paintLives(Canvas& canvas, const Game& game, Vec2 from, Real room, Real step);

/// A question to the player, if there is one; `bottom`: lower edge, m.
void paintQuestion(Canvas& canvas, std::string_view question, Real bottom);

/// The prize that a game pays, or would pay now: none once it is lost.
inline std::int32_t payable(const Game& game) {
    return game.result() == Result::Lost ? 0 : game.counts().prize();
}

/// 12345 -> "12 345".
std::string grouped(int number);

/// 1, "block" -> "1 block"; 2 -> "2 blocks".
std::string countText(std::int64_t count, std::string_view what);

/// Breaks a text between words into lines of at most `letters` letters.
std::vector<std::string> wrapped(std::string_view text, std::size_t letters);

/// Breaks a text into at most `lines` lines: of `letters` letters, or of as many as needed, up to
/// `most`. The end of a longer text is cut.
std::vector<std::string> wrappedInto(std::size_t lines, std::string_view text, std::size_t letters,
                                     std::size_t most = 10000);

/// The text with at most `most` letters; "..." stands for the end of a longer one.
std::string shortened(std::string_view text, std::size_t most);

/// Height of the letters (m) at which each of some lines fits into a width, so that all are of one
/// size; `height` at most.
Real evenHeight(const Canvas& canvas, const std::vector<std::string>& lines, Real height,
                Real width);

/// Letters of the usual size that fit in a line at the current size of texts.
std::size_t fitting(const Canvas& canvas, std::size_t letters);

} // namespace apart
