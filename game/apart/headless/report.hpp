// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace apart {

/// Result of a run, printed as a sentence or as one JSON object.
struct Report {
    std::string level;
    std::uint32_t seed = 0;
    std::uint32_t ticks = 0;
    Result result = Result::Playing;
    std::int32_t score = 0;
    std::int32_t lives = 0;
    std::int32_t blocksLeft = 0;
    std::uint64_t stateHash = 0;
    // Only of a replay.
    std::optional<std::size_t> expectationsFailed{};
    std::optional<std::size_t> hashesChecked{};
    std::optional<std::uint32_t> firstDifference{}; // tick
    std::optional<std::uint32_t> ended{};           // tick at which the game was won or lost
};

Report reportOf(const Game& game);

/// Prints lines on stderr, printable.
void complain(const std::string& lines);

std::string asJson(const Report& report);
std::string asSentence(const Report& report);

/// Progress line on stderr, overwritten in place ten times a second at most. Silent unless stderr
/// is a terminal.
class Progress {
public:
    Progress();
    /// Silent also if `beside` is a terminal (STDOUT_FILENO): its lines would be mixed up.
    explicit Progress(int beside);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(const Game& game, std::uint32_t end);
    void show(const std::string& line);
    /// Removes the line; must be called before other output.
    void clear();

private:
    bool terminal_ = false;
    bool shown_ = false;
    std::chrono::steady_clock::time_point next_{}; // earliest time of the next line of a game
};

} // namespace apart
