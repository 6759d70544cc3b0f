// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/run.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace apart {

/// A day as a seed, 20261126 for 26 November 2026 (UTC). The daily run of a day is the endless run
/// of this seed, with the same serves for everyone.
using Day = std::uint32_t;

/// "2026-11-26".
std::string dayText(Day day);
/// "Daily run 2026-11-26".
std::string dailyName(Day day);
/// How a daily run ended.
struct DailyResult {
    Day day = 0;
    std::int32_t score = 0;  // of all levels
    std::size_t levels = 0;  // of which the last one was lost
    std::uint32_t ticks = 0; // of all levels
};
/// For others, in one line: "aPart, daily run 2026-11-26: 31250 points, level 3, 1:42".
std::string dailyLine(const DailyResult& result);
/// Key of its scores: "daily-2026-11-26".
std::string dailyKey(Day day);
/// The day of such a key.
std::optional<Day> dayOf(std::string_view key);

/// Seed of the game on a level of the daily run, from number 1.
inline std::uint32_t dailySeed(Day day, std::uint32_t number) {
    return day + number;
}
/// True if the run is one of this day: from its first level, with its seeds.
bool isDaily(const ReplayRun& run, Day day);
/// The day of a run, if it is one.
std::optional<Day> dailyOf(const ReplayRun& run);

} // namespace apart
