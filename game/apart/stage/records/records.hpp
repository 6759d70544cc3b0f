// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/medals.hpp>
#include <apart/stage/records/score_book.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace apart {

/// Functions that keep the player's data. Each returns a sentence for the player on failure, else
/// an empty text. Without them nothing is kept.
struct Keeping {
    std::function<std::string(const Profile&)> save{};
    /// The profile as it is stored now, perhaps by another running game.
    std::function<std::optional<Profile>()> saved{};
    /// Saves a game of the player: if `best` is empty, as the last one, finished or not; else as
    /// the best one of this key.
    std::function<std::string(const ReplayRun&, const std::string& best)> keepReplay{};
};

/// The profile of the player, with the proofs and the replays of its scores.
class Records {
public:
    /// A finished game, or an endless run so far. Its key is the name of the level, or kEndlessKey.
    struct Result {
        ScoreBook::Key key;
        Best best;
        ReplayRun run;
    };

    Records(Profile profile, Keeping keeping, ScoreStore scores, std::vector<std::string> notices)
        : profile_(std::move(profile)),
          keeping_(std::move(keeping)),
          scores_(std::move(scores)),
          book_(scores_),
          notices_(std::move(notices)) {}

    Profile& profile() { return profile_; }
    const Profile& profile() const { return profile_; }
    /// What is known of a best score.
    Standing standingOf(Mode mode, const std::string& key) const;
    std::int32_t provedScore(Mode mode, const std::string& key) const; // 0: none

    /// The honours of a level. None without a score, or if its replay is missing or does not give
    /// it.
    Best honoursOf(Mode mode, const std::string& key) const;
    /// True if the honours of a mode have it.
    bool isCleared(const std::string& key) const;

    /// Checks a score next, or after all others.
    void checkFirst(Mode mode, const std::string& key);
    void checkLast(Mode mode, const std::string& key);
    /// Checks, after all others, the scores that could not be read, and those of levels that are
    /// not noted as cleared: their replays may say more.
    void checkDoubtful();
    /// The content of this level has changed: a new table of scores begins, see ScoreBook. Before
    /// that, completes the checks that results wait for, unless they take long.
    void setLevel(std::shared_ptr<const Level> level);
    /// Goes on with the checks, by about so many ticks; see ScoreBook. True if one has ended.
    bool advance(std::uint32_t ticks, bool loads = true);
    /// The replay of the best game of a level, unless it is known to be none.
    std::optional<Replay> bestGame(Mode mode, const Level& level) const;

    /// The medal of the proved score of a level.
    Medal medalOf(Mode mode, const std::string& level) const;
    void setMarks(std::vector<MedalMarks> marks) { marks_ = std::move(marks); }
    const std::vector<MedalMarks>& marks() const { return marks_; }
    /// Adds a game to the totals of its theme.
    void count(Theme theme, const PlayTotals& game);

    /// Enters a result and keeps its replay. True if it beats a proved score. One that does not
    /// beat an unchecked score waits for its check, as does one that would replace a replay which
    /// another running game has stored.
    bool enter(Result result);
    /// Keeps the replay of the last game.
    void keepLast(const ReplayRun& run);
    /// Saves the profile.
    void save();
    /// Ends the checks that decide about results, unless they take long, and saves the profile.
    void close();

    /// Sentences about what could not be kept of the last result.
    const std::vector<std::string>& lost() const { return lost_; }
    /// Adds a sentence for the player unless it is already there.
    void note(std::string sentence);
    const std::vector<std::string>& notices() const { return notices_; }

private:
    bool mend(const ScoreBook::Finding& finding);
    void settleWaiting();
    void adoptSaved(const ScoreBook::Key& key);
    bool enterBest(Result result);
    void enterHonours(const Result& result);
    void keepRun(const ReplayRun& run, const std::string& best);
    void noteLoss(const std::string& sentence);

    Profile profile_;
    Keeping keeping_;
    ScoreStore scores_;
    ScoreBook book_;
    std::vector<Result> waiting_; // for the check of the score that they may replace
    std::vector<std::string> notices_;
    std::vector<std::string> lost_;
    std::vector<MedalMarks> marks_;
};

} // namespace apart
