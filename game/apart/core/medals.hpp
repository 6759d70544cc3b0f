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

// Bronze is reached by kBronzeShare of the games of the lazy bot, silver by kSilverShare of those
// of the lazy and of the good one at most. Gold lies above silver by kGoldOver of it, and is
// reached by kGoldShare of their games at most.
inline constexpr double kBronzeShare = 0.75;
inline constexpr double kSilverShare = 0.2;
inline constexpr double kGoldOver = 0.15;
inline constexpr double kGoldShare = 0.1;
inline constexpr std::int32_t kMedalStep = 50; // marks are multiples of it

// Share of the won games that need as few hits, and share of all games without as large a collapse.
inline constexpr double kFewHitsShare = 0.1;
inline constexpr double kOneFallShare = 0.9;
inline constexpr std::int32_t kLeastOneFall = 5; // blocks; levels with smaller collapses have none

/// Games of one bot on a level, seed by seed.
struct PlayedGames {
    std::vector<std::int32_t> scores{};
    std::vector<std::int32_t> hits{}; // of the paddle, of won games
    std::vector<std::int32_t> falls{};
    std::array<std::int32_t, kMostWays> ways{}; // won games by way
};

/// What the marks of a level are measured on.
struct MedalGames {
    PlayedGames lazy;
    PlayedGames good;
    PlayedGames absent;  // needs no skill
    PlayedGames planner; // shows that gold can be reached; on levels with a building
};

// Games of the absent player and of the planner, for `seeds` of the others.
inline constexpr std::uint32_t kAbsentGames = 4;  // times
inline constexpr std::uint32_t kPlannerShare = 4; // of them

/// Plays `seeds` games of the lazy and of the good bot, and others in proportion, with seeds 1, 2,
/// ..., of at most `mostTicks`.
MedalGames playForMedals(const Level& level, std::uint32_t seeds, std::uint32_t mostTicks);
/// Silver and gold are above the best game of the absent player too.
MedalMarks marksOf(const Level& level, const MedalGames& games);

/// Bronze, silver and gold from scores of the lazy, the good and the absent bot.
std::array<std::int32_t, 3> scoresForMedals(const std::vector<std::int32_t>& lazy,
                                            const std::vector<std::int32_t>& good,
                                            const std::vector<std::int32_t>& absent);

/// The medal that a score is worth; None if there are no marks for this level.
Medal medalOf(std::int32_t score, const std::string& level, std::span<const MedalMarks> marks);
/// The medal of a game, or of the best ones. A lost game has bronze at most.
Medal medalWon(std::int32_t score, bool won, const std::string& level,
               std::span<const MedalMarks> marks);
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
