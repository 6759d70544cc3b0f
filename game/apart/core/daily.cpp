// SPDX-License-Identifier: MIT
#include <apart/core/daily.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/text_file.hpp>
#include <apart/core/tuning.hpp>

#include <array>

namespace apart {

namespace {

constexpr std::string_view kPrefix = "daily-";

/// False for the 30th of February, for instance.
bool isOfCalendar(Day date) {
    constexpr std::array<Day, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const Day year = date / 10000;
    const Day month = date / 100 % 100;
    const Day day = date % 100;
    if (year == 0 || month == 0 || month > kDays.size()) {
        return false;
    }
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return day > 0 && day <= kDays[month - 1] + (month == 2 && leap ? 1 : 0);
}

} // namespace

std::string dayText(Day day) {
    std::string digits = std::to_string(day);
    digits.insert(0, digits.size() < 8 ? 8 - digits.size() : 0, '0');
    return digits.insert(digits.size() - 2, "-").insert(digits.size() - 5, "-");
}

std::string dailyName(Day day) {
    return "Daily run " + dayText(day);
}

std::string dailyLine(const DailyResult& result) {
    const std::uint32_t seconds = result.ticks / kTicksPerSecond;
    const std::string rest = std::to_string(seconds % 60);
    return "aPart, daily run " + dayText(result.day) + ": " + std::to_string(result.score) +
           " points, level " + std::to_string(result.levels) + ", " + std::to_string(seconds / 60) +
           (rest.size() < 2 ? ":0" : ":") + rest;
}

std::string dailyKey(Day day) {
    return std::string(kPrefix) + dayText(day);
}

std::optional<Day> dayOf(std::string_view key) {
    if (!key.starts_with(kPrefix) || key.size() != kPrefix.size() + 10) {
        return std::nullopt;
    }
    std::string digits(key.substr(kPrefix.size()));
    std::erase(digits, '-');
    const std::optional<std::int64_t> day = toNumber(digits);
    if (digits.size() != 8 || !day || *day < 0 || dailyKey(static_cast<Day>(*day)) != key) {
        return std::nullopt;
    }
    const auto date = static_cast<Day>(*day);
    return isOfCalendar(date) ? std::optional(date) : std::nullopt;
}

bool isDaily(const ReplayRun& run, Day day) {
    for (std::uint32_t i = 0; i < run.size(); ++i) {
        const std::optional<EndlessName> level = parseEndless(run[i].level);
        if (level != EndlessName{day, i + 1} || run[i].seed != dailySeed(day, i + 1)) {
            return false;
        }
    }
    return !run.empty();
}

std::optional<Day> dailyOf(const ReplayRun& run) {
    const std::optional<EndlessName> first =
        run.empty() ? std::nullopt : parseEndless(run[0].level);
    return first && isDaily(run, first->seed) ? std::optional(first->seed) : std::nullopt;
}

} // namespace apart
