// SPDX-License-Identifier: MIT
#include <apart/core/text_file.hpp>
#include <apart/core/tuning.hpp>
#include <apart/headless/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace apart {

namespace {

constexpr std::uint32_t kLookEvery = 120; // ticks, between looks at the clock
constexpr std::chrono::milliseconds kShowEvery{100};

std::string clockOf(std::uint32_t ticks) {
    const std::uint32_t seconds = ticks / kTicksPerSecond;
    return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

} // namespace

Report reportOf(const Game& game) {
    return {.level = game.level().name,
            .seed = game.seed(),
            .ticks = game.ticks(),
            .result = game.result(),
            .score = game.score(),
            .lives = game.lives(),
            .blocksLeft = game.blocksLeft(),
            .stateHash = game.stateHash()};
}

std::string asJson(const Report& report) {
    // Names of levels and results contain no character that JSON must escape.
    std::string text =
        fmt::format(R"({{"level": "{}", "seed": {}, "ticks": {}, "result": "{}", "score": {}, )"
                    R"("lives": {}, "blocksLeft": {}, "stateHash": "{}")",
                    report.level, report.seed, report.ticks,
                    kResultNames[static_cast<std::size_t>(report.result)], report.score,
                    report.lives, report.blocksLeft, toHex(report.stateHash));
    if (report.ended) {
        text += fmt::format(R"(, "ended": {})", *report.ended);
    }
    if (report.expectationsFailed) {
        text += fmt::format(R"(, "expectationsFailed": {})", *report.expectationsFailed);
    }
    if (report.hashesChecked) {
        text += fmt::format(
            R"(, "hashesChecked": {}, "firstDifference": {})", *report.hashesChecked,
            report.firstDifference ? std::to_string(*report.firstDifference) : std::string("null"));
    }
    return text + "}";
}

void complain(const std::string& lines) {
    for (std::size_t at = 0; at <= lines.size();) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size());
        fmt::print(stderr, "{}\n", printable(lines.substr(at, end - at)));
        at = end + 1;
    }
}

std::string asSentence(const Report& report) {
    const std::uint32_t end = report.ended.value_or(report.ticks);
    const std::string more =
        end < report.ticks ? fmt::format(" The replay goes on to tick {}.", report.ticks) : "";
    return fmt::format(
        "{}, seed {}: {} after {} ({} ticks), score {}, lives {}, blocks left {}.{}\n"
        "State hash {}.",
        printable(report.level), report.seed, kResultNames[static_cast<std::size_t>(report.result)],
        clockOf(end), end, report.score, report.lives, report.blocksLeft, more,
        toHex(report.stateHash));
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::Progress(int beside) : terminal_(isatty(STDERR_FILENO) == 1 && isatty(beside) != 1) {}

Progress::~Progress() {
    clear();
}

void Progress::clear() {
    if (shown_) {
        fmt::print(stderr, "\r\x1b[K");
        shown_ = false;
    }
}

void Progress::show(const std::string& line) {
    if (terminal_) {
        shown_ = true;
        fmt::print(stderr, "\r\x1b[K{}", line);
        std::fflush(stderr);
    }
}

void Progress::show(const Game& game, std::uint32_t end) {
    if (!terminal_ || game.ticks() % kLookEvery != 0) {
        return;
    }
    if (const auto now = std::chrono::steady_clock::now(); now >= next_) {
        next_ = now + kShowEvery;
        show(fmt::format("{}  {} of {}  score {}  lives {}  blocks left {}", game.level().name,
                         clockOf(game.ticks()), clockOf(end), game.score(), game.lives(),
                         game.blocksLeft()));
    }
}

} // namespace apart
