// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace apart {

// Changes of the text of scripted replays. Comments and the order of lines stay.

/// A collapse after the first serve. Ticks are those after which the state shows it; 0: never.
struct Collapsing {
    std::uint32_t seed = 0;
    int target = 0; // 1/1000 m, of the paddle
    std::int32_t blocks = 0;
    std::uint32_t hitTick = 0; // of the first block
    std::string stuff{};       // of that block
    double hitX = 0;           // m
    std::uint32_t fallTick = 0;
    std::uint32_t largestTick = 0;
    std::int32_t largest = 0;
    std::int32_t besideLeft = 0; // the same with the paddle half a ball to the left
    std::int32_t besideRight = 0;
};

/// Which block a collapse must begin with. From a comment of the replay:
///
///   # first hit: glass
///   # first hit: left of -9
struct FirstHit {
    std::string stuff{}; // empty: any
    std::optional<double> leftOf{};

    bool allows(const Collapsing& collapse) const {
        return (stuff.empty() || stuff == collapse.stuff) && (!leftOf || collapse.hitX <= *leftOf);
    }
};
FirstHit firstHitOf(const std::string& text);

/// The text with seed, target and expectations of the collapse. It expects three quarters of the
/// blocks, half a second later.
std::string withCollapse(const std::string& text, const Collapsing& collapse);

/// Moves all targets (1/1000 m).
void moveTargets(Replay& replay, int shift);

/// Number of runs of equal targets.
std::size_t targetGroups(const Replay& replay);
/// Moves the targets of each run by its own shift (1/1000 m).
void moveGroups(Replay& replay, const std::vector<int>& shifts);
/// The text with another seed, and the targets moved likewise.
std::string withTargets(const std::string& text, std::uint32_t seed,
                        const std::vector<int>& shifts);

/// The first 8000 attempts keep the seed; then it changes every hundred.
constexpr std::uint32_t seedOfAttempt(std::uint32_t seed, std::uint32_t attempt) {
    return attempt < 8000 ? seed : 1 + (attempt - 8000) / 100;
}

} // namespace apart
