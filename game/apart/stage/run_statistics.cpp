// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/run_statistics.hpp>

#include <algorithm>

namespace apart {

void RunStatistics::hear(const Game& game) {
    for (const Event& event : game.events()) {
        if (const auto* broke = std::get_if<Broke>(&event)) {
            bestCombo = std::max(bestCombo, broke->combo);
            ++broken;
        }
        lifeLost = lifeLost || std::holds_alternative<LifeLost>(event);
    }
    if (game.result() == Result::Playing) {
        ticks = game.ticks();
    }
}

Best RunStatistics::bestOf(const Game& game) const {
    const bool cleared = game.result() == Result::Won;
    return {game.score(), cleared, cleared && !lifeLost, bestCombo >= kMostCombo};
}

} // namespace apart
