// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/records/run_statistics.hpp>

#include <algorithm>

namespace apart {

void RunStatistics::update(const Game& game) {
    way.update(game);
    for (const Event& event : game.events()) {
        if (const auto* broke = std::get_if<Broke>(&event)) {
            bestCombo = std::max(bestCombo, broke->combo);
            points.broken += broke->points;
            broken += broke->points > 0 ? 1 : 0;
        } else if (const auto* landed = std::get_if<Landed>(&event)) {
            points.fallen += landed->points;
            ++fallen;
        } else if (std::holds_alternative<Caught>(event)) {
            points.caught += kCatchPoints;
            ++caught;
        } else if (const auto* won = std::get_if<Cleared>(&event)) {
            points.lives = won->lives;
            points.prize = won->prize;
            points.spared = won->spared;
        } else if (const auto* collapse = std::get_if<Collapsed>(&event)) {
            lastFall = collapse->blocks;
            lastFallTick = game.ticks();
        }
        lifeLost = lifeLost || std::holds_alternative<LifeLost>(event);
    }
    cleared = game.blocksAtStart() - game.blocksLeft();
    largestFall = game.collapse().largest;
    if (game.result() == Result::Playing || game.ticks() == ticks + 1) {
        keptAtEnd = game.state().keeps();
    }
    if (game.result() == Result::Playing) {
        ticks = game.ticks();
    }
}

Best RunStatistics::bestOf(const Game& game, const MedalMarks* marks) const {
    const bool won = game.result() == Result::Won;
    Best best{game.score(), won, won && !lifeLost, std::max(bestCombo, largestFall) >= kMostCombo};
    best.kept = won && keptAtEnd;
    best.ways = won ? way.ways(game.level()) : 0;
    if (marks != nullptr) {
        best.fewHits = won && marks->fewHits > 0 && game.counts().hits <= marks->fewHits;
        best.oneFall = marks->oneFall > 0 && largestFall >= marks->oneFall;
    }
    return best;
}

PlayTotals RunStatistics::totalsOf(const Game& game) const {
    PlayTotals totals;
    totals.games = 1;
    totals.won = game.result() == Result::Won ? 1 : 0;
    totals.seconds = static_cast<std::int32_t>(ticks / kTicksPerSecond);
    totals.broken = broken;
    totals.fallen = fallen;
    totals.largestFall = largestFall;
    totals.bestCombo = bestCombo;
    return totals;
}

} // namespace apart
