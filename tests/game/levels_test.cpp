// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/tuning.hpp>
#include <support/draws.hpp>

#include <gtest/gtest.h>

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

constexpr std::uint32_t kSeeds = support::kSanitized ? 1 : 6;

/// Ticks per life of a simulated keyboard player with slow reactions and occasional misses.
double ticksPerLife(const std::vector<Level>& levels, Theme theme) {
    double ticks = 0;
    double lives = 0;
    for (const Level& level : levels) {
        for (std::uint32_t seed = 1; level.theme == theme && seed <= kSeeds; ++seed) {
            const BotRun run = runBot(level, seed, kTwoMinutes, BotKind::Clumsy);
            ticks += run.ticks;
            lives += run.livesLost;
        }
    }
    return ticks / lives;
}

// 29 s per life at first and 20 s at last, over 170 games. The share over these 60 games deviates
// by a tenth.
TEST(Levels, GetHarder) {
    const std::vector<Level> levels = allLevels();
    const double first = ticksPerLife(levels, levels.front().theme);
    const double last = ticksPerLife(levels, levels.back().theme);
    EXPECT_GT(first, 1.3 * last);
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

INSTANTIATE_TEST_SUITE_P(Levels, EveryLevel, testing::ValuesIn(levelNames()),
                         [](const auto& level) { return level.param; });

} // namespace
