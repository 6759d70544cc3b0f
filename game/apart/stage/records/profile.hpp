// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/controls/bindings.hpp>
#include <apart/stage/controls/player_settings.hpp>
#include <apart/stage/records/play_totals.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace apart {

/// The best results of the player in one level. Won honours persist across games.
struct Best {
    std::int32_t score = 0;
    bool cleared = false;
    bool unhurt = false; // cleared without losing the last ball in play
    bool chain = false;  // reached a combo or a collapse of kMostCombo
    // Highest score that a lower one has replaced, because its replay did not give it.
    std::int32_t unproved = 0;
    // Honours whose numbers depend on the level, see MedalMarks.
    bool fewHits = false;
    bool oneFall = false;
    bool kept = false;      // won, and Level::keep stands
    std::uint32_t ways = 0; // bits, see WayWatch::ways(): in some won game

    friend bool operator==(Best, Best) = default;
};

/// Key of the best endless run in Profile::best. No level has this name.
inline constexpr const char* kEndlessKey = "endless";

/// Score of a line that cannot be read, until its replay gives the true one. No game has it.
inline constexpr std::int32_t kUnreadScore = 1;

/// Player data that persists between runs of the program.
struct Profile {
    Settings settings{};
    Mode mode = Mode::Standard; // last choice
    bool muted = false;
    Bindings bindings{};
    /// Indexed by Mode, then by level name: scores of different modes are never compared.
    std::array<std::map<std::string, Best>, kModeNames.size()> best{};
    TotalsByTheme totals{};
    /// All levels up to this one are open: games without a map had offered them. Empty: none.
    std::string reached{};
    bool mapped = true; // false: a game without a map has saved this last

    /// The settings, without sound while muted.
    Settings audible() const {
        Settings heard = settings;
        heard.sound = muted ? 0 : settings.sound;
        heard.music = muted ? 0 : settings.music;
        return heard;
    }
    Best bestOf(Mode of, const std::string& level) const {
        const auto& bests = best[static_cast<std::size_t>(of)];
        const auto found = bests.find(level);
        return found == bests.end() ? Best{} : found->second;
    }
    /// Merges a result. True if its score beats an existing one.
    bool enter(Mode in, const std::string& level, Best game);
    /// Merges a result that another running game has saved, except a score that was replaced here.
    void adopt(Mode in, const std::string& level, Best other);
    /// Replaces a score by the one that its replay gives, or by 0. Best::unproved keeps a higher
    /// one.
    void correct(Mode in, const std::string& level, std::int32_t score);

    friend bool operator==(const Profile&, const Profile&) = default;
};

} // namespace apart
