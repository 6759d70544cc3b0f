// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace apart {

/// A replay and its level, ready to be played. Throws Refusal.
Playback openReplay(const std::string& file);
void playToEnd(Playback& playback);

struct TraceCommand {
    std::string file;
    std::uint32_t from = 0; // ticks
    std::uint32_t to = kLongestReplay;
    std::vector<std::string> fields; // whose values are printed when they change
};

/// Prints what happened in a replay, an event a line: tick, name of the event, its numbers. Returns
/// 0.
int runTrace(const TraceCommand& command);

/// Plays handwritten replays and replaces their hash lines. Returns 0.
int runHash(const std::vector<std::string>& files);

} // namespace apart
