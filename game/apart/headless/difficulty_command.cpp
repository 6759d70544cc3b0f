// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/difficulty.hpp>
#include <apart/headless/lint_command.hpp>
#include <apart/headless/refusal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace apart {

namespace {

constexpr std::size_t kClumsy = 0; // indices into kSkills
constexpr std::size_t kGood = 3;
constexpr std::size_t kFirstLevels = 3; // which Clumsy must win at least kFirstShare of the time
constexpr double kFirstShare = 0.8;
constexpr double kLeastCorrelation = 0.8; // of Clumsy's share with the order of themes

void printSkillHead() {
    fmt::print("{:<16} {:<12}", "level", "theme");
    for (const BotKind skill : kSkills) {
        fmt::print(" {:>8}", kBotNames[static_cast<std::size_t>(skill)]);
    }
    fmt::print(" {:>8} {:>8} {:>8}\n{:<29}", "absent", "clumsy", "good", "");
    for (std::size_t i = 0; i < kSkills.size() + 1; ++i) {
        fmt::print(" {:>8}", "wins %");
    }
    fmt::print(" {:>8} {:>8}\n", "clears %", "s, mean");
}

void printSkillRow(const LevelDifficulty& level) {
    fmt::print("{:<16} {:<12}", level.level, kThemeNames[static_cast<std::size_t>(level.theme)]);
    for (const SkillGames& games : level.skills) {
        fmt::print(" {:>8.0f}", 100 * games.wonShare());
    }
    fmt::print(" {:>8.0f} {:>8.0f} {:>8.1f}\n", 100 * level.absent.wonShare(),
               100 * level.skills[kClumsy].cleared, level.skills[kGood].seconds);
    std::fflush(stdout);
}

/// Rank from 1 of the last level by a value, the highest first.
std::size_t rankOfLast(const std::vector<double>& values) {
    return 1 + static_cast<std::size_t>(std::count_if(values.begin(), values.end(),
                                                      [&](double v) { return v > values.back(); }));
}

/// Prints the sums over all levels; false if difficulty does not rise as required.
bool judge(const std::vector<LevelDifficulty>& levels) {
    std::vector<double> order;
    std::vector<double> won;
    std::vector<double> cleared;
    for (const ThemeShare& share : sharesByTheme(levels, kClumsy)) {
        order.push_back(static_cast<double>(order.size()));
        won.push_back(share.won);
        cleared.push_back(share.cleared);
        fmt::print("{:<16} clumsy wins {:>3.0f} %, clears {:>3.0f} %\n",
                   kThemeNames[static_cast<std::size_t>(share.theme)], 100 * share.won,
                   100 * share.cleared);
    }
    const double rise = rankCorrelation(order, won);
    fmt::print("Rank correlation of the clumsy bot's share with the order of themes: {:.2f} of "
               "wins, {:.2f} of blocks.\n",
               rise, rankCorrelation(order, cleared));
    std::vector<double> place;
    std::vector<double> ease;
    std::vector<double> hardness;
    std::vector<double> seconds;
    for (const LevelDifficulty& level : levels) {
        place.push_back(static_cast<double>(place.size()));
        ease.push_back(level.ease());
        hardness.push_back(1 - level.ease());
        seconds.push_back(level.skills[kGood].seconds);
    }
    fmt::print("Rank correlation of all skills' share of wins with the order of levels: {:.2f}.\n",
               rankCorrelation(place, ease));
    fmt::print("The last of {} levels is number {} by difficulty and number {} by duration.\n",
               levels.size(), rankOfLast(hardness), rankOfLast(seconds));
    fmt::print("Minutes of play until each level is won once:");
    for (std::size_t skill = 0; skill < kSkills.size(); ++skill) {
        double minutes = 0;
        for (const LevelDifficulty& level : levels) {
            minutes += level.skills[skill].secondsToWin() / 60;
        }
        const auto bot = static_cast<std::size_t>(kSkills[skill]);
        fmt::print("{} {} {:.1f}", skill > 0 ? "," : "", kBotNames[bot], minutes);
    }
    fmt::print(".\n");
    bool passed = -rise >= kLeastCorrelation || levels.size() < kFirstLevels;
    for (std::size_t i = 0; i < std::min(kFirstLevels, levels.size()); ++i) {
        passed = passed && levels[i].skills[kClumsy].wonShare() >= kFirstShare;
    }
    fmt::print("{}\n", passed ? "Difficulty rises as required." : "Difficulty is NOT as required.");
    return passed;
}

} // namespace

int runDifficulty(const LintCommand& command) {
    std::vector<LevelDifficulty> levels;
    printSkillHead();
    for (const std::string& name : command.levels.empty() ? namesOfLevels() : command.levels) {
        const Level level = valueOrRefuse(loadLevel(name));
        levels.push_back(difficultyOf(level, command.options));
        printSkillRow(levels.back());
    }
    return judge(levels) ? 0 : 1;
}

} // namespace apart
