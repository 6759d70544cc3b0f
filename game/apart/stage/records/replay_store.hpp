// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/records/campaign.hpp>
#include <apart/stage/records/profile_file.hpp>
#include <apart/stage/records/score_book.hpp>
#include <apart/stage/records/theatre.hpp>

#include <filesystem>
#include <string>

namespace apart {

/// Reason why no level of the player can have this name; "" if one can.
std::string ownNameProblem(const std::string& name);
/// True if scores and replays of this level can be kept: a replay can hold its name.
bool isRecorded(const Level& level);

/// File of the best game of a level, or of the best run of a key.
std::filesystem::path bestFile(const std::filesystem::path& folder, Mode mode,
                               const std::string& level);

/// Writes a game to last.replay in the player's folder or, if `best` names its level, to best/. A
/// best game that cannot be compared with the new one is renamed: one that is damaged (.broken), of
/// other rules (.rules-N), or of another version of the level (.older-level). Returns an error
/// sentence or "".
std::string keepReplay(const std::filesystem::path& folder, const ReplayRun& run,
                       const std::string& best);

/// The recorded best games in the player's folder, on these levels.
ScoreStore scoresIn(const std::filesystem::path& folder, const LevelList& levels);

/// Of a profile that is missing or damaged: the scores that it lacks and that have a replay in
/// best/ are marked as unread, so that Records takes them from there. The notice says so.
void restoreScores(LoadedProfile& loaded, const std::filesystem::path& profile);

/// The entry of a replay in the list, without `load`. Its title is that of the level, or the name
/// of the file if it cannot be read.
ShowEntry entryOf(const std::filesystem::path& file, const LevelList& levels);

/// The replays in the player's folder: the last game, then the best ones, the latest first; at most
/// kMostReplays.
std::vector<std::filesystem::path> replayFiles(const std::filesystem::path& folder);

} // namespace apart
