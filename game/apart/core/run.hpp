// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// The replays of an endless run, level by level. Its file holds them one after the other; a file
/// with one replay is a run of one level.
using ReplayRun = std::vector<Replay>;

/// A file of several replays is refused unless they are consecutive endless levels of one seed, one
/// mode and one version of the rules.
Read<ReplayRun> parseRun(std::string_view text, const std::string& file);
/// The path may also be a link, see replay_link.hpp; its file may be packed.
Read<ReplayRun> readRunFile(const std::filesystem::path& path);
std::string toText(const ReplayRun& run);

/// The level of a replay, or the reason why it cannot be played, as a sentence.
using LevelOrReason = std::variant<std::shared_ptr<const Level>, std::string>;
using LevelFinder = std::function<LevelOrReason(const Replay&)>;

/// Plays a run in slices, to learn its score.
class RunCheck {
public:
    RunCheck(ReplayRun run, LevelFinder levelOf);

    /// Plays at most so many ticks.
    void advance(std::uint32_t ticks);
    bool done() const { return done_; }
    /// True if the next advance() makes an endless level, which takes long.
    bool loads() const;
    double share() const; // 0..1, of all ticks
    /// Sum of the scores. nullopt before the end, and if the run is no proof: a level cannot be
    /// loaded, a hash differs, or a level before the last one is not won.
    std::optional<std::int32_t> score() const;
    bool won() const { return won_; } // the last level, once score() is given

private:
    void open();
    void close();

    ReplayRun run_;
    LevelFinder levelOf_;
    std::size_t next_ = 0; // index in run_ of the replay after the current one
    std::optional<Playback> playback_;
    std::uint64_t ticks_ = 0;
    std::uint64_t allTicks_ = 0;
    std::int32_t score_ = 0;
    bool done_ = false;
    bool failed_ = false;
    bool won_ = false;
};

} // namespace apart
