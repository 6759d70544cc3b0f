// SPDX-License-Identifier: MIT
#include <apart/core/difficulty.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace apart {

namespace {

/// Ranks from 1; equal values have the mean of their ranks.
std::vector<double> ranksOf(std::span<const double> values) {
    std::vector<double> ranks;
    for (const double value : values) {
        const auto smaller = std::count_if(values.begin(), values.end(),
                                           [&](double other) { return other < value; });
        const auto equal = std::count(values.begin(), values.end(), value);
        ranks.push_back(static_cast<double>(smaller) + static_cast<double>(equal + 1) / 2);
    }
    return ranks;
}

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

double SkillGames::secondsToWin() const {
    return won > 0 ? seconds * games / won : seconds * (games + 1);
}

double LevelDifficulty::ease() const {
    double sum = 0;
    for (const SkillGames& games : skills) {
        sum += games.wonShare();
    }
    return sum / static_cast<double>(skills.size());
}

LevelDifficulty difficultyOf(const Level& level, const LintOptions& options) {
    const auto gamesOf = [&](BotKind player) {
        SkillGames sum;
        for (std::uint32_t game = 0; game < options.seeds; ++game) {
            const std::uint32_t seed = options.firstSeed + game;
            const BotRun run = runBot(level, seed, options.mostTicks, player);
            ++sum.games;
            sum.won += run.result == Result::Won ? 1 : 0;
            sum.cleared += run.cleared / options.seeds;
            sum.seconds += static_cast<double>(run.ticks) / kTicksPerSecond / options.seeds;
        }
        return sum;
    };
    LevelDifficulty difficulty{.level = level.name, .theme = level.theme};
    std::transform(kSkills.begin(), kSkills.end(), difficulty.skills.begin(), gamesOf);
    difficulty.absent = gamesOf(BotKind::Absent);
    return difficulty;
}

double rankCorrelation(std::span<const double> a, std::span<const double> b) {
    if (a.empty()) {
        return 0;
    }
    const std::vector<double> ranksA = ranksOf(a);
    const std::vector<double> ranksB = ranksOf(b);
    const double meanA = meanOf(ranksA);
    const double meanB = meanOf(ranksB);
    double both = 0;
    double squareA = 0;
    double squareB = 0;
    for (std::size_t i = 0; i < ranksA.size(); ++i) {
        both += (ranksA[i] - meanA) * (ranksB[i] - meanB);
        squareA += (ranksA[i] - meanA) * (ranksA[i] - meanA);
        squareB += (ranksB[i] - meanB) * (ranksB[i] - meanB);
    }
    return squareA > 0 && squareB > 0 ? both / std::sqrt(squareA * squareB) : 0;
}

std::vector<ThemeShare> sharesByTheme(std::span<const LevelDifficulty> levels, std::size_t skill) {
    std::vector<ThemeShare> shares;
    for (std::size_t theme = 0; theme < kThemeNames.size(); ++theme) {
        ThemeShare share{.theme = static_cast<Theme>(theme)};
        int count = 0;
        for (const LevelDifficulty& level : levels) {
            if (level.theme == share.theme) {
                share.won += level.skills[skill].wonShare();
                share.cleared += level.skills[skill].cleared;
                ++count;
            }
        }
        if (count > 0) {
            share.won /= count;
            share.cleared /= count;
            shares.push_back(share);
        }
    }
    return shares;
}

} // namespace apart
