// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/text_file.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

enum class Medal : std::uint8_t { None, Bronze, Silver, Gold };
inline constexpr std::array<std::string_view, 4> kMedalNames = {"none", "bronze", "silver", "gold"};

/// What a game of a level must reach for medals and for the honours that depend on the level.
struct MedalMarks {
    std::string level;
    std::uint64_t digest = 0;             // of the level that they were measured on
    std::array<std::int32_t, 3> scores{}; // for bronze, silver, gold; rising
    std::int32_t fewHits = 0;             // won with at most so many hits of the paddle, serves
                                          // included; 0: none
    std::int32_t oneFall = 0;             // blocks of one collapse; 0: none

    friend bool operator==(const MedalMarks&, const MedalMarks&) = default;
};

// Shares of the measured games that a score must reach for bronze, silver and gold. The games are
// those of the bots of all skills, so half of them are played badly.
inline constexpr std::array<double, 3> kMedalShares = {0.5, 0.75, 0.95};
inline constexpr std::int32_t kMedalStep = 50; // marks are multiples of it

// Share of the won games that need as few hits, and share of all games without as large a collapse.
inline constexpr double kFewHitsShare = 0.1;
inline constexpr double kOneFallShare = 0.9;
inline constexpr std::int32_t kLeastOneFall = 5; // blocks; levels with smaller collapses have none

// Games of the absent player, which needs no skill, for each game of a skill.
inline constexpr std::uint32_t kAbsentGames = 4;

/// Measures the marks of a level: bots of each skill play `seeds` games, with seeds 1, 2, ..., of
/// at most `mostTicks`. A mark is the quantile of their scores, rounded up. Silver and gold are
/// above the best of kAbsentGames * `seeds` games of the absent player.
MedalMarks measureMedals(const Level& level, std::uint32_t seeds, std::uint32_t mostTicks);

/// The quantiles of some scores at kMedalShares, rounded up. At least one score.
std::array<std::int32_t, 3> marksOf(const std::vector<std::int32_t>& scores);

/// The marks, with silver and gold raised above a score, and gold above silver.
std::array<std::int32_t, 3> raisedAbove(std::array<std::int32_t, 3> marks, std::int32_t score);

/// The medal of a score; None if there are no marks for this level.
Medal medalOf(std::int32_t score, const std::string& level, std::span<const MedalMarks> marks);
/// Score of the next better medal; 0 if there is none.
std::int32_t nextMark(std::int32_t score, const std::string& level,
                      std::span<const MedalMarks> marks);
/// True if the marks were measured on exactly this level.
bool measuredOn(const MedalMarks& marks, const Level& level);

/// The marks of a level; nullptr: there are none.
const MedalMarks* marksFor(const std::string& level, std::span<const MedalMarks> marks);

/// The table as text; tools/medals writes it to assets/medals.toml.
std::string toText(std::span<const MedalMarks> marks);
/// Fails if the table was measured with another version of the rules.
Read<std::vector<MedalMarks>> parseMedals(std::string_view text, const std::string& file);
Read<std::vector<MedalMarks>> readMedals(const std::filesystem::path& path);

} // namespace apart
