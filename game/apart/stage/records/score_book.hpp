// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/run.hpp>
#include <apart/stage/records/profile.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace apart {

/// State of the best score of a level. The profile is a text file, so a score counts only once its
/// replay has been played and has given the same score.
enum class Proof : std::uint8_t {
    None,    // there is no score
    Waiting, // not checked yet
    Proved,  // its replay gives it
    Older,   // its replay is of other rules or of another version of the level
    Missing, // it has no replay, or one that does not give it
};

inline constexpr const char* kOlderLevel = "older level"; // Standing::note, if it is that

struct Standing {
    Proof proof = Proof::None;
    std::int32_t score = 0; // of the replay if proved, else of the profile
    std::string note{};     // few words for the player, unless proved: "rules 21"
    bool cleared = false;   // by the replay, once a check has proved the score
};

/// Source of the recorded best games.
struct ScoreStore {
    /// The best game of a level, or why there is none, in few words.
    std::function<std::variant<ReplayRun, std::string>(Mode, const std::string& level)> load{};
    LevelFinder levelOf{};
};

/// Checks best scores by their replays, in slices between frames. A check lasts for one run of the
/// program: nothing of it is stored, so nothing of it can be typed in.
class ScoreBook {
public:
    using Key = std::pair<Mode, std::string>;
    /// A score whose check has just ended.
    struct Finding {
        Key key;
        Standing standing;
    };

    explicit ScoreBook(ScoreStore store = {}) : store_(std::move(store)) {}

    /// Checks the score of a level next, or after all others. Does nothing if it is known.
    void checkFirst(const Key& key, std::int32_t score);
    void checkLast(const Key& key, std::int32_t score);
    /// Checks a score next, again even if it is known.
    void recheck(const Key& key, std::int32_t score);
    /// From now on this is the level of its name. Scores of it are checked again: those of another
    /// content become scores of an older level.
    void setLevel(std::shared_ptr<const Level> level);
    /// A game that was just played has this score: it needs no check. Its replay is stored next.
    void prove(const Key& key, std::int32_t score, const ReplayRun& run);
    /// True if the stored replay is not the one that was checked or proved last: another running
    /// game has stored it, or the profile has lost its score.
    bool isReplaced(const Key& key) const;

    /// Goes on with the first check, by about so many ticks of its game. Without `loads`, it waits
    /// where an endless level must be made, which takes as long as some frames.
    std::optional<Finding> advance(std::uint32_t ticks, bool loads = true);
    bool busy() const { return !checks_.empty(); }
    Standing standingOf(const Key& key, std::int32_t score) const;

private:
    struct Check {
        Key key;
        std::int32_t score = 0;
        std::optional<RunCheck> run{};
    };
    bool isChecked(const Key& key, std::int32_t score) const;
    LevelFinder finder() const;
    std::optional<Finding> begin(Check& check);
    Finding settle(Standing standing);

    ScoreStore store_;
    std::shared_ptr<const Level> level_; // of setLevel(); it replaces that of the store
    std::vector<Check> checks_;          // the first one is in progress
    std::map<Key, Standing> known_;
    std::map<Key, std::uint64_t> digests_; // of the replays that were checked or proved last
};

} // namespace apart
