// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>
#include <apart/core/level.hpp>
#include <apart/core/lint.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace apart {

/// Games of one bot on a level.
struct SkillGames {
    std::uint32_t games = 0;
    std::uint32_t won = 0;
    double cleared = 0; // 0..1, mean share of the blocks that broke or fell
    double seconds = 0; // mean duration of a game

    /// Mean play until a level is won, in seconds. The next game counts as won if none was.
    double secondsToWin() const;
    double wonShare() const { return games > 0 ? static_cast<double>(won) / games : 0; }
};

struct LevelDifficulty {
    std::string level;
    Theme theme = Theme::Daybreak;
    std::array<SkillGames, kSkills.size()> skills{}; // in the order of kSkills

    SkillGames absent{}; // of a player who never moves

    /// Mean share of won games over all skills, 0..1: 1 is an easy level.
    double ease() const;
};

/// Plays the games of `options` with each skill and with the absent player.
LevelDifficulty difficultyOf(const Level& level, const LintOptions& options);

/// Spearman's rank correlation, -1..1, with mean ranks for equal values. 0 if a list has one value
/// only. The lists are equally long.
double rankCorrelation(std::span<const double> a, std::span<const double> b);

/// Mean share of the games that `skill` won, and of the blocks that it cleared, by theme. Themes
/// without a level are left out.
struct ThemeShare {
    Theme theme = Theme::Daybreak;
    double won = 0;
    double cleared = 0;
};
std::vector<ThemeShare> sharesByTheme(std::span<const LevelDifficulty> levels, std::size_t skill);

} // namespace apart
