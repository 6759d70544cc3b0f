// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/medals.hpp>
#include <apart/stage/records/profile.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

using LevelList = std::vector<std::shared_ptr<const Level>>;

/// How the levels open, one after another.
///
/// - Two levels of a theme are open at once. Each further one asks for one more medal of the theme.
/// - The boss of a theme asks for kMedalsForTwo medals for every two of the other levels.
/// - A theme opens once the boss of the one before it is won.
///
/// Silver counts as two medals, gold as three. What was played once stays open.
struct Campaign {
    /// Names of the levels that are bosses. A theme without one is open, as is the one after it.
    std::span<const std::string_view> bosses{};
    std::size_t own = static_cast<std::size_t>(-1); // index of the first level of the player
    bool open = false;                              // all levels
};
inline constexpr int kMedalsForTwo = 3;

/// The building or machine of each theme that bots win least often.
inline constexpr std::array<std::string_view, kThemeNames.size()> kBosses = {
    "funnel", "tower", "see_saw", "capsize", "bell", "mobile", "apart"};

/// Puts the boss of each theme behind the other levels of it.
void putBossesLast(LevelList& levels);

/// A level on the map, with what it asks for.
struct Stop {
    bool boss = false;
    int medals = 0;                       // missing ones of its theme
    std::shared_ptr<const Level> after{}; // the boss that must be won first

    bool open() const { return medals == 0 && !after; }
    /// What opens it, as a sentence; empty if it is open.
    std::string asks() const;
};

/// The stops of all levels. Scores count as the profile has them, of any mode, even before their
/// replays are checked.
std::vector<Stop> stopsOf(const LevelList& levels, const Campaign& campaign, const Profile& profile,
                          std::span<const MedalMarks> marks);

/// Medals of a level: 0 to 3. One without marks gives one if it is won.
int medalsOf(const Level& level, const Profile& profile, std::span<const MedalMarks> marks);
int mostMedalsOf(const Level& level, std::span<const MedalMarks> marks);
bool isWon(const Level& level, const Profile& profile);
bool isPlayed(const Level& level, const Profile& profile); // there is a result, of any mode

/// The level after the furthest one with a result: up to it, all were offered by games without a
/// map. Empty if there is no result.
std::string reachedBy(const LevelList& levels, const Profile& profile);

/// Index of the first open level that is not cleared; if there is none, of the first open one with
/// the fewest medals.
std::size_t nextToPlay(const LevelList& levels, const std::vector<Stop>& stops,
                       const Profile& profile, std::span<const MedalMarks> marks);

} // namespace apart
