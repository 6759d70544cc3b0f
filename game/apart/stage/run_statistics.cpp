// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/run_statistics.hpp>

#include <algorithm>

namespace apart {

void RunStatistics::hear(const Game& game) {
    for (const Event& event : game.events()) {
        if (const auto* broke = std::get_if<Broke>(&event)) {
            bestCombo = std::max(bestCombo, broke->combo);
        }
        lifeLost = lifeLost || std::holds_alternative<LifeLost>(event);
    }
    cleared = game.blocksAtStart() - game.blocksLeft();
    largestFall = game.collapse().largest;
    if (game.result() == Result::Playing) {
        ticks = game.ticks();
    }
}

Best RunStatistics::bestOf(const Game& game) const {
    const bool won = game.result() == Result::Won;
    return {game.score(), won, won && !lifeLost, std::max(bestCombo, largestFall) >= kMostCombo};
}

} // namespace apart
