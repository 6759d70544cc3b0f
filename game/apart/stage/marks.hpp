// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas.hpp>
#include <kodo/math/transform.hpp>

#include <string_view>
#include <vector>

namespace apart {

/// The sign of a power, one for each; `size` is half its height (m).
void paintMark(Canvas& canvas, Power power, const kodo::Transform& place, Real size, Color color);

struct MoodStyle {
    Real size = 0; // m, about half its height
    Color fill{};
    Color rim{};
    Real width = Real(0.05); // m, of the rim
};

/// What a sign stands on tells the mood of its power by its shape: a disc is good, a square on its
/// corner is mixed, a triangle on its point is bad.
void paintMood(Canvas& canvas, Mood mood, Vec2 middle, const MoodStyle& style);

/// What a power does, in a few words.
std::string_view wordsOf(Power power);

/// The powers that a level holds, each once, in their order.
std::vector<Power> powersOf(const Level& level);

} // namespace apart
