// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <cstdint>
#include <vector>

namespace apart {

/// Observations of one or several games.
struct Observations {
    std::uint64_t ticks = 0;
    std::uint64_t freeTicks = 0;   // ball ticks without contact or force field
    std::uint32_t halts = 0;       // balls below half the target speed for half a second
    std::uint32_t escapes = 0;     // ticks of balls outside (except below) and of frozen bodies
    std::uint32_t bends = 0;       // bent paths without contact or force field
    std::uint32_t longestWait = 0; // most successive ticks in play without damage to a block

    void add(const Observations& other);
    std::uint32_t faults() const { return halts + escapes + bends; }
};

/// Checks invariants of a game after each tick and measures how long the player waits. It is
/// independent of the governor, so it detects faults of the governor.
class GameObserver {
public:
    /// Must be called after each tick of one game.
    void observe(const Game& game);
    const Observations& observations() const { return observations_; }

private:
    struct Track {
        kodo::BodyId body;
        kodo::Vec2 velocity; // m/s, at the end of the tick
        std::uint32_t slowTicks = 0;
    };

    void follow(const Game& game, const Ball& ball, const Track* before);
    void count(const Game& game);

    std::vector<Track> tracks_; // of the balls in flight
    std::vector<Track> next_;
    bool pulled_ = false; // a force field acted in the last tick
    bool free_ = true;    // no force field acts in this tick
    std::uint32_t wait_ = 0;
    Observations observations_;
};

} // namespace apart
