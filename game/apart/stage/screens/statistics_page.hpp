// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/records/play_totals.hpp>

#include <string>

namespace apart {

/// Paints the player's totals, a row a theme and one of all themes.
void paintStatistics(Canvas& canvas, const TotalsByTheme& totals);

/// 59 -> "0:59", 3600 -> "1:00:00".
std::string durationText(std::int32_t seconds);

} // namespace apart
