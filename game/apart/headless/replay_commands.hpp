// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/run.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace apart {

/// The replays of a file. Throws Refusal.
ReplayRun readRun(const std::string& file);
/// A replay of a file with its level, ready to be played. `level`: the file of the level; empty:
/// the one of its name, see loadLevelOf(). Throws Refusal.
Playback openReplay(const std::string& file, const Replay& replay, const std::string& level = "");
/// Returns the tick at which the game was won or lost.
std::optional<std::uint32_t> playToEnd(Playback& playback);

/// The commands `replay` and `verify`.
struct PlayCommand {
    std::string file;
    std::string level; // see openReplay()
    bool json = false;
    bool link = false;
};

struct TraceCommand {
    std::string file;
    std::string level;                 // see openReplay()
    std::uint32_t from = 0;            // ticks
    std::optional<std::uint32_t> to{}; // the end unless given
    std::vector<std::string> fields;   // whose values are printed when they change
};

/// Prints a line with the units, then what happened in a replay, an event a line: tick, name of the
/// event, its numbers. In a run of several levels, a line with the name of each comes first. Throws
/// Refusal if `from` is after `to`. Returns 0.
int runTrace(const TraceCommand& command);

/// Plays handwritten replays and replaces their hash lines. Returns 0.
int runHash(const std::vector<std::string>& files);

} // namespace apart
