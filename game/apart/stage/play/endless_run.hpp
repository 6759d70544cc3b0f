// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/daily.hpp>
#include <apart/core/game.hpp>
#include <apart/core/run.hpp>
#include <apart/stage/records/profile.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace apart {

/// An endless or daily run up to its current level; or none.
struct EndlessRun {
    std::uint32_t number = 0; // of the current level; 0: none
    std::int32_t score = 0;   // of the previous levels
    ReplayRun before{};       // their replays
    Day day = 0;              // of a daily run; 0: it is none
    std::uint32_t seed = 0;   // of the levels of a run that is not daily

    /// Key of the scores of a game: of the run, or else of its level.
    std::string keyOf(const Game& game) const {
        return day > 0 ? dailyKey(day) : number > 0 ? kEndlessKey : game.level().name;
    }
    /// The run with its current level.
    ReplayRun with(std::optional<Replay> last) const {
        ReplayRun run = before;
        if (last) {
            run.push_back(std::move(*last));
        }
        return run;
    }
};

} // namespace apart
