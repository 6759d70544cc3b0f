// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <kodo/math.hpp>

#include <string_view>
#include <vector>

namespace apart {

/// Paints the symbol of a power; `size` is half its height (m).
void paintMark(Canvas& canvas, Power power, const kodo::Transform& place, Real size, Color color);

struct MoodStyle {
    Real size = 0; // m, about half the height
    Color fill{};
    Color rim{};
    Real width = Real(0.05); // m, of the rim
};

/// Paints the background of a symbol. Its shape shows the mood of the power: disc for good, diamond
/// for mixed, inverted triangle for bad.
void paintMood(Canvas& canvas, Mood mood, Vec2 middle, const MoodStyle& style);

/// Short description of a power, for the player.
std::string_view wordsOf(Power power);

/// The distinct powers of a level, in order of the enumeration.
std::vector<Power> powersOf(const Level& level);

/// Paints a way to bring a building down: an arrow that bends down. The elegant one has a disc at
/// its turn.
void paintWay(Canvas& canvas, Vec2 middle, Real size, Color color, bool elegant);

} // namespace apart
