// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

/// Sums over all games of the player in the levels of one theme.
struct PlayTotals {
    std::int32_t games = 0; // ended, or left after some seconds
    std::int32_t won = 0;
    std::int32_t seconds = 0; // of game time
    std::int32_t broken = 0;  // blocks hit to pieces
    std::int32_t fallen = 0;  // blocks that fell from their place or out of the field
    // The highest of one game.
    std::int32_t largestFall = 0; // blocks of one collapse
    std::int32_t bestCombo = 0;

    friend bool operator==(const PlayTotals&, const PlayTotals&) = default;
};

/// Description of one number of PlayTotals, for the profile file and the statistics page.
struct TotalField {
    std::string_view key; // in the profile file
    std::string_view label;
    std::int32_t PlayTotals::*value;
    bool sum = true; // else a maximum
};
inline constexpr std::array<TotalField, 7> kTotalFields = {
    TotalField{"games", "games", &PlayTotals::games},
    TotalField{"won", "won", &PlayTotals::won},
    TotalField{"seconds", "time", &PlayTotals::seconds},
    TotalField{"broken", "broken", &PlayTotals::broken},
    TotalField{"fallen", "fallen", &PlayTotals::fallen},
    TotalField{"largest-fall", "largest fall", &PlayTotals::largestFall, false},
    TotalField{"best-combo", "best combo", &PlayTotals::bestCombo, false},
};
inline constexpr std::int32_t kMostTotal = 2000000000; // sums stay at it

/// Adds other games.
inline void add(PlayTotals& totals, const PlayTotals& games) {
    for (const TotalField& field : kTotalFields) {
        std::int32_t& value = totals.*field.value;
        const std::int32_t more = games.*field.value;
        value = !field.sum                  ? std::max(value, more)
                : more > kMostTotal - value ? kMostTotal
                                            : value + more;
    }
}

using TotalsByTheme = std::array<PlayTotals, kThemeNames.size()>;

} // namespace apart
