// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/tuning.hpp>
#include <apart/headless/lint_command.hpp>
#include <apart/headless/refusal.hpp>
#include <apart/headless/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace apart {

namespace {

/// Totals of the bot's games on a level.
struct Summary {
    std::uint32_t won = 0;
    std::uint64_t ticks = 0;
    std::int32_t livesLost = 0;
    std::uint32_t longestWait = 0;
    std::size_t mostBodies = 0;
    std::uint32_t longestGap = 0;
    std::uint64_t quietTicks = 0;
    std::uint32_t firstHit = 0; // ticks; median of the games

    double quietShare() const { // 0..1, of the time of all games
        return ticks == 0 ? 0 : static_cast<double>(quietTicks) / static_cast<double>(ticks);
    }
};

Summary summaryOf(const LintReport& report) {
    Summary sum;
    std::vector<std::uint32_t> firstHits;
    for (const BotRun& run : report.runs) {
        sum.won += run.result == Result::Won ? 1 : 0;
        sum.ticks += run.ticks;
        sum.livesLost += run.livesLost;
        sum.longestWait = std::max(sum.longestWait, run.longestWait);
        sum.mostBodies = std::max(sum.mostBodies, run.mostBodies);
        sum.longestGap = std::max(sum.longestGap, run.longestGap);
        sum.quietTicks += run.quietTicks;
        firstHits.push_back(run.firstHit);
    }
    if (!firstHits.empty()) {
        std::sort(firstHits.begin(), firstHits.end());
        sum.firstHit = firstHits[firstHits.size() / 2];
    }
    return sum;
}

double seconds(std::uint64_t ticks) {
    return static_cast<double>(ticks) / kTicksPerSecond;
}

double meanSeconds(const Summary& sum, const LintReport& report) {
    return report.runs.empty() ? 0 : seconds(sum.ticks) / static_cast<double>(report.runs.size());
}

void printHead() {
    fmt::print("{:<20} {:>6} {:>7} {:>12} {:>13} {:>9} {:>10} {:>6} {:>10} {:>7} {:>10} {:>8} "
               "{:>6} {:>6}\n",
               "level", "blocks", "reached", "waits s, <=", "clears s, <=", "bot wins",
               "in s, mean", "lost", "waited s", "bodies", "work/tick", "quiet %", "gap s",
               "hit s");
}

void printRow(const LintReport& report) {
    const Summary sum = summaryOf(report);
    fmt::print("{:<20} {:>6} {:>7} {:>12.0f} {:>13.0f} {:>9} {:>10.1f} {:>6} {:>10.1f} {:>7} "
               "{:>10} {:>8.1f} {:>6.1f} {:>6.2f}{}\n",
               report.level, report.blocks,
               report.blocks - static_cast<int>(report.outOfReach.size()),
               seconds(report.waitBound), seconds(report.clearBound),
               fmt::format("{} of {}", sum.won, report.runs.size()), meanSeconds(sum, report),
               sum.livesLost, seconds(sum.longestWait), sum.mostBodies, report.workPerTick,
               100 * sum.quietShare(), seconds(sum.longestGap), seconds(sum.firstHit),
               report.passed() ? "" : "  FAILED");
}

std::string asJson(const LintReport& report) {
    const Summary sum = summaryOf(report);
    // The sentences contain no character that JSON must escape.
    const auto listOf = [](const std::vector<std::string>& sentences) {
        std::string list;
        for (const std::string& sentence : sentences) {
            list += fmt::format(R"({}"{}")", list.empty() ? "" : ", ", sentence);
        }
        return list;
    };
    return fmt::format(
        R"({{"level": "{}", "passed": {}, "blocks": {}, "outOfReach": {}, "waitBoundTicks": {}, )"
        R"("clearBoundTicks": {}, "games": {}, "won": {}, "meanTicks": {}, "livesLost": {}, )"
        R"("longestWaitTicks": {}, "mostBodies": {}, "workPerTick": {}, "quietShare": {:.4f}, )"
        R"("longestGapTicks": {}, "firstHitTicks": {}, "problems": [{}], "warnings": [{}]}})",
        report.level, report.passed(), report.blocks, report.outOfReach.size(), report.waitBound,
        report.clearBound, report.runs.size(), sum.won,
        report.runs.empty() ? 0 : sum.ticks / report.runs.size(), sum.livesLost, sum.longestWait,
        sum.mostBodies, report.workPerTick, sum.quietShare(), sum.longestGap, sum.firstHit,
        listOf(report.problems), listOf(report.warnings));
}

/// Pace over all levels: the mean share of quiet time, the worst level, the longest gap, and the
/// longest median time from the serve to the first hit.
class Pace {
public:
    void add(const LintReport& report) {
        const Summary sum = summaryOf(report);
        total_ += sum.quietShare();
        ++levels_;
        if (sum.quietShare() >= worst_) {
            worst_ = sum.quietShare();
            worstLevel_ = report.level;
        }
        if (sum.longestGap >= longestGap_) {
            longestGap_ = sum.longestGap;
            longestLevel_ = report.level;
        }
        if (sum.firstHit >= firstHit_) {
            firstHit_ = sum.firstHit;
            firstHitLevel_ = report.level;
        }
    }
    void print() const {
        fmt::print("Time in gaps over {} s without a crack, break, fall or catch: {:.1f} % as mean "
                   "of the levels, {:.1f} % at worst ({}); longest gap {:.1f} s ({}).\n",
                   kQuietGap / kTicksPerSecond, 100 * total_ / std::max(levels_, 1), 100 * worst_,
                   worstLevel_, seconds(longestGap_), longestLevel_);
        fmt::print("From serve to first hit of a block, median of the games: {:.2f} s at most "
                   "({}).\n",
                   seconds(firstHit_), firstHitLevel_);
    }

private:
    double total_ = 0;
    double worst_ = 0;
    int levels_ = 0;
    std::uint32_t longestGap_ = 0;
    std::string worstLevel_;
    std::string longestLevel_;
    std::uint32_t firstHit_ = 0;
    std::string firstHitLevel_;
};

} // namespace

int runLint(const LintCommand& command) {
    const std::vector<std::string> names =
        command.levels.empty() ? namesOfLevels() : command.levels;
    std::vector<Level> levels; // all are read before the first is played
    for (const std::string& name : names) {
        levels.push_back(valueOrRefuse(loadLevel(name)));
    }
    std::vector<LintReport> failed;
    std::string json;
    Pace pace;
    if (!command.json) {
        printHead();
    }
    for (const Level& level : levels) {
        LintReport report = lint(level, command.options);
        pace.add(report);
        if (command.json) {
            json += (json.empty() ? "" : ",\n ") + asJson(report);
        } else {
            printRow(report);
        }
        for (const std::string& warning : report.warnings) {
            fmt::print(stderr, "{}: warning: {}.\n", report.level, warning);
        }
        if (!report.passed()) {
            failed.push_back(std::move(report));
        }
    }
    if (command.json) {
        fmt::print("{{\"passed\": {}, \"levels\": [\n {}]}}\n", failed.empty(), json);
    }
    for (const LintReport& report : failed) {
        for (const std::string& problem : report.problems) {
            fmt::print(stderr, "{}: {}.\n", report.level, problem);
        }
    }
    if (!command.json) {
        pace.print();
    }
    if (!command.json && failed.empty()) {
        fmt::print("All {} levels pass.\n", levels.size());
    }
    return failed.empty() ? 0 : 1;
}

} // namespace apart
