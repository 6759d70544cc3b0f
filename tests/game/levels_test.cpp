// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/tuning.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace {

using namespace apart;

constexpr std::uint32_t kTwoMinutes = 2 * 60 * kTicksPerSecond;

std::vector<Level> allLevels() {
    std::vector<Level> levels;
    for (const std::string& name : levelNames()) {
        levels.push_back(std::get<Level>(loadLevel(name)));
    }
    return levels;
}

TEST(Levels, AreOrderedByThemeWithEnoughInEach) {
    const std::vector<Level> levels = allLevels();
    EXPECT_GE(levels.size(), 24u);
    std::map<Theme, int> count;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        ++count[levels[i].theme];
        EXPECT_EQ(levels[i].place, static_cast<std::int32_t>(i + 1)) << levels[i].name;
        EXPECT_TRUE(i == 0 || levels[i - 1].theme <= levels[i].theme) << levels[i].name;
    }
    EXPECT_GE(count.size(), 4u);
    for (const auto& [theme, levelsOfIt] : count) {
        EXPECT_GE(levelsOfIt, 4) << kThemeNames[static_cast<std::size_t>(theme)];
    }
}

TEST(Levels, HaveUniqueTitlesAndIdeas) {
    std::set<std::string> titles;
    std::set<std::string> ideas;
    const std::vector<Level> levels = allLevels();
    for (const Level& level : levels) {
        titles.insert(level.title);
        ideas.insert(level.idea);
        EXPECT_TRUE(level.idea.ends_with('.')) << level.name;
    }
    EXPECT_EQ(titles.size(), levels.size());
    EXPECT_EQ(ideas.size(), levels.size());
}

constexpr std::uint32_t kSeeds = 6;

/// Share of the games that the clumsy bot wins.
double shareOfWins(const std::vector<Level>& levels, Theme theme) {
    double games = 0;
    double won = 0;
    for (const Level& level : levels) {
        for (std::uint32_t seed = 1; level.theme == theme && seed <= kSeeds; ++seed) {
            won += runBot(level, seed, kTwoMinutes, BotKind::Clumsy).result == Result::Won ? 1 : 0;
            ++games;
        }
    }
    return won / games;
}

// All games of the first theme, and 0.3 of the last (lint --difficulty).
TEST(Levels, GetHarder) {
    const std::vector<Level> levels = allLevels();
    const double first = shareOfWins(levels, levels.front().theme);
    const double last = shareOfWins(levels, levels.back().theme);
    EXPECT_GT(first, 2 * last);
    EXPECT_GT(levels.back().ballSpeed, levels.front().ballSpeed);
}

class EveryLevel : public testing::TestWithParam<std::string> {};

// Lint of every level: all blocks reachable, won by the bot within five minutes, no fault, cost
// within bounds. `apart-headless lint --seeds 20` plays more games.
TEST_P(EveryLevel, PassesItsCheck) {
    const LintReport report = lint(std::get<Level>(loadLevel(GetParam())));
    for (const std::string& problem : report.problems) {
        ADD_FAILURE() << problem;
    }
    EXPECT_GT(report.blocks, 0);
}

// The median of 11 seeds strays from that of 61 by up to 45 ticks, that of 31 by 15.
TEST_P(EveryLevel, IsHitWithin12TenthsOfASecondOfAServe) {
    constexpr std::uint32_t kMost = 6 * kTicksPerSecond / 5;
    const Level level = std::get<Level>(loadLevel(GetParam()));
    std::vector<std::uint32_t> ticks;
    for (std::uint32_t seed = 1; seed <= 31; ++seed) {
        ticks.push_back(runBot(level, seed, 2 * kMost).firstHit);
    }
    std::sort(ticks.begin(), ticks.end());
    EXPECT_GT(ticks.front(), 0u);
    EXPECT_LE(ticks[ticks.size() / 2], kMost) << "median of the seeds";
}

/// With sanitizers every third level; tools/determinism_matrix plays all of them.
std::vector<std::string> checkedLevels() {
    const std::vector<std::string> all = levelNames();
    std::vector<std::string> checked;
    for (std::size_t i = 0; i < all.size(); i += support::kSanitized ? 3 : 1) {
        checked.push_back(all[i]);
    }
    return checked;
}

INSTANTIATE_TEST_SUITE_P(Levels, EveryLevel, testing::ValuesIn(checkedLevels()),
                         [](const auto& level) { return level.param; });

TEST(Levels, TheSentenceAboutMissingOnesNamesTheWholeFolderAndTheVariable) {
    const std::string text = noLevelsText();
    EXPECT_NE(text.find(std::filesystem::absolute(assetsFolder() / "levels").string()),
              std::string::npos);
    EXPECT_NE(text.find("APART_ASSETS"), std::string::npos);
}

} // namespace
