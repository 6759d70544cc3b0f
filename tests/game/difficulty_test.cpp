// SPDX-License-Identifier: MIT
#include <apart/core/difficulty.hpp>

#include <array>

#include "game_access.hpp"

namespace {

using namespace apart;

TEST(Difficulty, RankCorrelationOfKnownLists) {
    const std::array<double, 4> rising = {1, 2, 5, 9};
    const std::array<double, 4> falling = {0.9, 0.5, 0.2, 0.1};
    const std::array<double, 4> tied = {3, 3, 3, 3};
    EXPECT_DOUBLE_EQ(rankCorrelation(rising, rising), 1);
    EXPECT_DOUBLE_EQ(rankCorrelation(rising, falling), -1);
    EXPECT_DOUBLE_EQ(rankCorrelation(rising, tied), 0);
    const std::array<double, 5> a = {1, 2, 3, 4, 5};
    const std::array<double, 5> b = {2, 1, 4, 3, 5}; // 1 - 6 * 4 / (5 * 24)
    EXPECT_DOUBLE_EQ(rankCorrelation(a, b), 0.8);
}

// Each skill of the scale clears at least as much of a wall as the one below it, within a tenth.
// Six games of two minutes: with two games of one, one ball lost early weighs a tenth.
TEST(Difficulty, SkillsRise) {
    const Level level = levelOf("bbbbbbbbbbbbbbb\nbbbbbbbbbbbbbbb\nbbbbbbbbbbbbbbb\n", 15000);
    const LevelDifficulty found = difficultyOf(level, {.seeds = 6, .mostTicks = 7200});
    for (std::size_t i = 1; i < kSkills.size(); ++i) {
        EXPECT_GT(found.skills[i].cleared, found.skills[i - 1].cleared - 0.1) << i;
    }
    EXPECT_GT(found.skills.back().cleared, found.skills.front().cleared + 0.2);
}

// A row of glass above a paddle that never moves: the ball comes back to it, or three are lost.
TEST(Difficulty, ThePlayerWhoNeverMovesIsPlayedButIsNoSkill) {
    const Level level = levelOf("bbbbbbbbbbbbbbb\nbbbbbbbbbbbbbbb\nbbbbbbbbbbbbbbb\n", 15000);
    const LevelDifficulty found = difficultyOf(level, {.seeds = 2, .mostTicks = 3600});
    EXPECT_EQ(found.absent.games, 2u);
    EXPECT_EQ(found.absent.won, 0u);
    EXPECT_GT(found.absent.cleared, 0);
    EXPECT_LT(found.absent.cleared, found.skills.back().cleared);
    Game game(level, 1);
    const kodo::Vec2 place = game.world()[game.paddle()].position();
    for (int i = 0; i < 600; ++i) {
        game.tick(bot(game, BotKind::Absent));
    }
    EXPECT_EQ(game.world()[game.paddle()].position().x, place.x);
    EXPECT_FALSE(game.serving() && game.lives() == level.lives) << "it serves";
}

// What all skills clear with seeds 3 and 4 is not what they clear with 1 and 2.
TEST(Difficulty, TheFirstSeedChoosesTheGames) {
    const Level level = levelOf("bbbbbbbbbbbbbbb\nbbbbbbbbbbbbbbb\n", 15000);
    const auto clearedFrom = [&](const LintOptions& options) {
        std::vector<double> cleared;
        for (const SkillGames& games : difficultyOf(level, options).skills) {
            cleared.push_back(games.cleared);
        }
        return cleared;
    };
    const auto first = clearedFrom({.seeds = 2, .mostTicks = 1200});
    EXPECT_EQ(clearedFrom({.seeds = 2, .firstSeed = 1, .mostTicks = 1200}), first);
    const auto later = clearedFrom({.seeds = 2, .firstSeed = 3, .mostTicks = 1200});
    EXPECT_EQ(clearedFrom({.seeds = 2, .firstSeed = 3, .mostTicks = 1200}), later);
    EXPECT_NE(later, first);
}

TEST(Difficulty, SharesByThemeLeaveOutThemesWithoutALevel) {
    std::vector<LevelDifficulty> levels(3);
    levels[0].skills[0] = {.games = 4, .won = 4, .cleared = 1};
    levels[1].skills[0] = {.games = 4, .won = 2, .cleared = 0.5};
    levels[2].theme = Theme::Fortress;
    const std::vector<ThemeShare> shares = sharesByTheme(levels, 0);
    ASSERT_EQ(shares.size(), 2u);
    EXPECT_DOUBLE_EQ(shares[0].won, 0.75);
    EXPECT_DOUBLE_EQ(shares[0].cleared, 0.75);
    EXPECT_EQ(shares[1].theme, Theme::Fortress);
}

TEST(Difficulty, TimeUntilAWinCountsTheLostGamesToo) {
    EXPECT_DOUBLE_EQ((SkillGames{.games = 4, .won = 2, .seconds = 30}.secondsToWin()), 60);
    EXPECT_DOUBLE_EQ((SkillGames{.games = 4, .won = 4, .seconds = 30}.secondsToWin()), 30);
    EXPECT_DOUBLE_EQ((SkillGames{.games = 4, .won = 0, .seconds = 30}.secondsToWin()), 150);
}

} // namespace
