// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>
#include <apart/stage/fanfare.hpp>
#include <apart/stage/play.hpp>
#include <apart/stage/run_statistics.hpp>
#include <apart/stage/time_scale.hpp>

#include <memory>
#include <optional>

namespace apart {

/// The game on screen, with its time, record and statistics.
class Session {
public:
    /// Starts a game; `recorded`: record() gives its replay.
    void begin(std::unique_ptr<Play> play, bool recorded);
    void setSettings(const Settings& settings) { play_->setSettings(settings); }

    /// Adds a frame (s). After a stall, time beyond a limit is dropped instead of caught up.
    void elapse(double seconds, const Settings& settings);
    /// True if a tick is due; takes its time.
    bool takeTick();
    /// One tick. No input: the pilot has finished.
    void tick(const std::optional<Input>& input, const Settings& settings, Speaker& speaker);
    void endFanfare() { fanfare_.stop(); }

    const Play& play() const { return *play_; }
    const Game& game() const { return play_->game(); }
    const RunStatistics& statistics() const { return statistics_; }
    /// Replay of the game so far, or of all of it after its end; nullopt: not recorded.
    std::optional<Replay> record() const;
    int endTicks() const { return endTicks_; } // since the end of the game
    bool overdue() const;                      // the end has been shown long enough
    /// Time since the last tick, as a share of a tick, 0..1.
    Real share() const;

private:
    std::unique_ptr<Play> play_;
    std::optional<Recorder> recorder_;
    std::optional<Replay> record_; // after the end
    RunStatistics statistics_;
    TimeScale timeScale_;
    Fanfare fanfare_;
    double owed_ = 0; // s of game time to be simulated
    int endTicks_ = 0;
};

} // namespace apart
