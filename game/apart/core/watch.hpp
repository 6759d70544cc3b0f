// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <cstdint>
#include <vector>

namespace apart {

/// What was seen of a game, or of several.
struct Seen {
    std::uint64_t ticks = 0;
    std::uint64_t freeTicks = 0;   // that balls flew untouched and unpulled, all balls added up
    std::uint32_t halts = 0;       // of balls slower than half their speed for half a second
    std::uint32_t escapes = 0;     // ticks of balls outside other than below, and unsound bodies
    std::uint32_t bends = 0;       // of balls that nothing touched and no field of force pulled at
    std::uint32_t longestWait = 0; // ticks in play, in a row, in which no block took harm

    void add(const Seen& other);
    std::uint32_t faults() const { return halts + escapes + bends; }
};

/// Looks at a game after each tick for what must never be, and for how long the player waits. It
/// knows nothing of how the game keeps a ball in play, so it can find a fault in that.
class Watch {
public:
    /// Call it after each tick of one game.
    void look(const Game& game);
    const Seen& seen() const { return seen_; }

private:
    struct Track {
        kodo::BodyId body;
        kodo::Vec2 velocity; // m/s, at the end of the tick
        std::uint32_t slowTicks = 0;
    };

    void follow(const Game& game, const Ball& ball, const Track* before);
    void count(const Game& game);

    std::vector<Track> tracks_; // of the balls that fly
    std::vector<Track> next_;
    bool pulled_ = false; // by a field of force, in the last tick
    bool free_ = true;    // of any, in this tick
    std::uint32_t wait_ = 0;
    Seen seen_;
};

} // namespace apart
