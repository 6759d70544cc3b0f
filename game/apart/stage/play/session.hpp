// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>
#include <apart/stage/effects/collapse_camera.hpp>
#include <apart/stage/effects/time_scale.hpp>
#include <apart/stage/painters/ghost.hpp>
#include <apart/stage/play/play.hpp>
#include <apart/stage/play/rerun.hpp>
#include <apart/stage/records/run_statistics.hpp>
#include <apart/stage/records/theatre.hpp>
#include <apart/stage/sound/fanfare.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace apart {

/// The game on screen, with its time, record and statistics.
class Session {
public:
    enum class Kind {
        Demo,  // of the bot, not recorded
        Own,   // of the player, recorded from the first tick
        Show,  // a replay: seek() goes to any tick of it
        WhatIf // of the player, from a tick of a replay on; it has no scores
    };

    void begin(std::unique_ptr<Play> play, Kind kind);
    void setSettings(const Settings& settings) { play_->setSettings(settings); }

    /// Adds a frame (s), times `pace`. After a stall, time beyond a limit is dropped.
    void elapse(double seconds, double pace, const Settings& settings);
    /// True if a tick is due; takes its time.
    bool takeTick();
    /// One tick. No input: the pilot has finished. A replay that ends before its game is over
    /// stands still from then on.
    void tick(const std::optional<Input>& input, const Settings& settings, Speaker& speaker);
    void endFanfare() { fanfare_.stop(); }

    /// Compares the states of a show with those of its recording, from now on.
    void compareWith(std::vector<HashMark> recorded) { recorded_ = std::move(recorded); }
    /// The first tick at which they differ.
    std::optional<std::uint32_t> divergedAt() const { return divergedAt_; }
    /// Goes to a tick of a show, played by its pilot.
    void seek(std::int64_t tick, const Pilot& pilot, const Settings& settings);
    /// The show becomes a game of the player.
    void takeOver();

    Kind kind() const { return kind_; }
    bool isDemo() const { return kind_ == Kind::Demo; }
    bool isShow() const { return kind_ == Kind::Show; }
    bool isWhatIf() const { return kind_ == Kind::WhatIf; }    // taken over from a replay
    std::uint32_t takenOverAt() const { return takenOverAt_; } // tick of the replay
    const Play& play() const { return *play_; }
    const Game& game() const { return play_->game(); }
    Closeup closeup() const { return camera_.closeup(game()); }
    const RunStatistics& statistics() const { return statistics_; }
    /// Replay of the game so far, or of all of it after its end; nullopt: not recorded.
    std::optional<Replay> record() const;
    /// True once for a game of the player that has been played for a while.
    bool takeUnkept();
    /// True once for a game of the player that takeUnkept() would accept, or that has ended.
    bool takeUncounted();
    /// Runs this game beside the current one, from its start.
    void setGhost(std::optional<Ghost> ghost) { ghost_ = std::move(ghost); }
    const std::optional<Ghost>& ghost() const { return ghost_; }
    /// The collapse that ended the game; nullopt: it ended otherwise.
    std::optional<Rerun> rerun() const;
    int endTicks() const { return endTicks_; } // since the end of the game
    bool overdue() const;                      // the end has been shown long enough
    /// Ticks of the game until now, or until it was over.
    std::uint32_t clock() const { return statistics_.ticks; }
    /// Time since the last tick, as a share of a tick, 0..1.
    Real share() const;

private:
    /// A state to return to.
    struct Mark {
        Play play;
        RunStatistics statistics;
        std::optional<Recorder> recorder;
    };
    void mark();
    void compare();

    Kind kind_ = Kind::Demo;
    std::uint32_t takenOverAt_ = 0;
    std::vector<HashMark> recorded_; // of a show
    std::optional<std::uint32_t> divergedAt_;
    std::unique_ptr<Play> play_;
    std::optional<Recorder> recorder_;
    std::optional<Replay> record_; // after the end
    RunStatistics statistics_;
    TimeScale timeScale_;
    CollapseCamera camera_;
    Fanfare fanfare_;
    std::vector<Mark> marks_;     // of a show: its start, then by time; else the last two
    std::uint32_t markEvery_ = 0; // ticks
    std::optional<Play> beforeFall_;
    double owed_ = 0; // s of game time to be simulated
    int endTicks_ = 0;
    bool standsStill_ = false; // a replay, at its end
    bool kept_ = false;        // takeUnkept() was true
    bool counted_ = false;     // takeUncounted() was true
    std::optional<Ghost> ghost_;
};

} // namespace apart
