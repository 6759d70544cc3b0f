// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/player_settings.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace apart {

/// The best that the player has done in a level. What is won once stays, game after game.
struct Best {
    std::int32_t score = 0;
    bool cleared = false;
    bool unhurt = false; // cleared without losing the last ball in play
    bool chain = false;  // had a combo of kMostCombo

    friend bool operator==(Best, Best) = default;
};

/// What is kept of a player between two runs of the program.
struct Profile {
    Settings settings{};
    Mode mode = Mode::Standard; // as chosen last
    /// By Mode and by name of the level: scores of the two never meet.
    std::array<std::map<std::string, Best>, kModeNames.size()> best{};

    Best bestOf(Mode of, const std::string& level) const {
        const auto& bests = best[static_cast<std::size_t>(of)];
        const auto found = bests.find(level);
        return found == bests.end() ? Best{} : found->second;
    }
    /// True when the score beats one that was there already.
    bool enter(Mode in, const std::string& level, Best game);

    friend bool operator==(const Profile&, const Profile&) = default;
};

} // namespace apart
