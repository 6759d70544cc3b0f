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
    Gaps quiet{};                // longest, and sum over all games
    Gaps uncleared{};            // likewise
    std::uint64_t afterFall = 0; // ticks after the largest fall
    std::uint32_t firstHit = 0;  // ticks; median of the games

    double share(std::uint64_t part) const { // 0..1, of the time of all games
        return ticks == 0 ? 0 : static_cast<double>(part) / static_cast<double>(ticks);
    }
};

void add(Gaps& sum, const Gaps& gaps) {
    sum.longest = std::max(sum.longest, gaps.longest);
    sum.ticks += gaps.ticks;
}

Summary summaryOf(const LintReport& report) {
    Summary sum;
    std::vector<std::uint32_t> firstHits;
    for (const BotRun& run : report.runs) {
        sum.won += run.result == Result::Won ? 1 : 0;
        sum.ticks += run.ticks;
        sum.livesLost += run.livesLost;
        sum.longestWait = std::max(sum.longestWait, run.longestWait);
        sum.mostBodies = std::max(sum.mostBodies, run.mostBodies);
        add(sum.quiet, run.quiet);
        add(sum.uncleared, run.uncleared);
        sum.afterFall += run.largestFallTick > 0 ? run.ticks - run.largestFallTick : 0;
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
               "{:>6} {:>8} {:>6} {:>6} {:>6}\n",
               "level", "blocks", "reached", "waits s, <=", "clears s, <=", "bot wins",
               "in s, mean", "lost", "waited s", "bodies", "work/tick", "quiet %", "gap s",
               "unclr %", "gap s", "after%", "hit s");
}

void printRow(const LintReport& report) {
    const Summary sum = summaryOf(report);
    fmt::print(
        "{:<20} {:>6} {:>7} {:>12.0f} {:>13.0f} {:>9} {:>10.1f} {:>6} {:>10.1f} {:>7} "
        "{:>10} {:>8.1f} {:>6.1f} {:>8.1f} {:>6.1f} {:>6.0f} {:>6.2f}{}\n",
        report.level, report.blocks, report.blocks - static_cast<int>(report.outOfReach.size()),
        seconds(report.waitBound), seconds(report.clearBound),
        fmt::format("{} of {}", sum.won, report.runs.size()), meanSeconds(sum, report),
        sum.livesLost, seconds(sum.longestWait), sum.mostBodies, report.workPerTick,
        100 * sum.share(sum.quiet.ticks), seconds(sum.quiet.longest),
        100 * sum.share(sum.uncleared.ticks), seconds(sum.uncleared.longest),
        100 * sum.share(sum.afterFall), seconds(sum.firstHit), report.passed() ? "" : "  FAILED");
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
        R"("longestGapTicks": {}, "unclearedShare": {:.4f}, "longestUnclearedTicks": {}, )"
        R"("afterFallShare": {:.4f}, "firstHitTicks": {}, "problems": [{}], "warnings": [{}]}})",
        report.level, report.passed(), report.blocks, report.outOfReach.size(), report.waitBound,
        report.clearBound, report.runs.size(), sum.won,
        report.runs.empty() ? 0 : sum.ticks / report.runs.size(), sum.livesLost, sum.longestWait,
        sum.mostBodies, report.workPerTick, sum.share(sum.quiet.ticks), sum.quiet.longest,
        sum.share(sum.uncleared.ticks), sum.uncleared.longest, sum.share(sum.afterFall),
        sum.firstHit, listOf(report.problems), listOf(report.warnings));
}

/// The mean and the highest of a value of the levels.
class Extreme {
public:
    void add(double value, const std::string& level) {
        sum_ += value;
        ++levels_;
        if (value >= worst_) {
            worst_ = value;
            level_ = level;
        }
    }
    double mean() const { return sum_ / std::max(levels_, 1); }
    std::string worst(std::string_view unit) const {
        return fmt::format("{:.1f} {} ({})", worst_, unit, level_);
    }

private:
    double sum_ = 0;
    int levels_ = 0;
    double worst_ = 0;
    std::string level_ = "none";
};

/// Pace over all levels.
class Pace {
public:
    void add(const LintReport& report, bool building) {
        const Summary sum = summaryOf(report);
        quiet_.add(100 * sum.share(sum.quiet.ticks), report.level);
        gap_.add(seconds(sum.quiet.longest), report.level);
        uncleared_.add(100 * sum.share(sum.uncleared.ticks), report.level);
        unclearedGap_.add(seconds(sum.uncleared.longest), report.level);
        firstHit_.add(seconds(sum.firstHit), report.level);
        if (building) {
            afterFall_.add(100 * sum.share(sum.afterFall), report.level);
        }
    }
    void print() const {
        constexpr auto kLeast = kQuietGap / kTicksPerSecond;
        fmt::print("Time in gaps over {} s without a crack, break, fall or catch: {:.1f} % as mean "
                   "of the levels, {} at worst; longest gap {}.\n",
                   kLeast, quiet_.mean(), quiet_.worst("%"), gap_.worst("s"));
        fmt::print("Time in gaps over {} s without a cleared block: {:.1f} % as mean, {} at worst; "
                   "longest gap {}.\n",
                   kLeast, uncleared_.mean(), uncleared_.worst("%"), unclearedGap_.worst("s"));
        fmt::print("Time after the largest fall, of levels with a building: {:.1f} % as mean, {} "
                   "at worst.\n",
                   afterFall_.mean(), afterFall_.worst("%"));
        fmt::print("From serve to first hit of a block, median of the games: {} at most.\n",
                   firstHit_.worst("s"));
    }

private:
    Extreme quiet_;
    Extreme gap_;
    Extreme uncleared_;
    Extreme unclearedGap_;
    Extreme afterFall_;
    Extreme firstHit_;
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
        pace.add(report, isBuilding(level));
        if (command.json) {
            json += (json.empty() ? "" : ",\n ") + asJson(report);
        } else {
            printRow(report);
        }
        for (const std::string& warning : report.warnings) {
            complain(fmt::format("{}: warning: {}.", report.level, warning));
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
            complain(fmt::format("{}: {}.", report.level, problem));
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
