// SPDX-License-Identifier: MIT
#include <apart/core/endless.hpp>
#include <apart/core/text_file.hpp>
#include <apart/stage/daily.hpp>

#include <fmt/format.h>

namespace apart {

namespace {

constexpr std::string_view kPrefix = "daily-";

} // namespace

std::string dayText(Day day) {
    return fmt::format("{:04}-{:02}-{:02}", day / 10000, day / 100 % 100, day % 100);
}

std::string dailyName(Day day) {
    return "Daily run " + dayText(day);
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
    return static_cast<Day>(*day);
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
