// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <cstdint>
#include <vector>

namespace apart {

/// Looks at a game after each tick for what must never be, and for how long the player waits. It
/// knows nothing of how the game keeps a ball in play, so it can find a fault in that.
class Watch {
public:
    /// Call it after each tick of one game.
    void look(const Game& game);

    std::uint64_t ticks() const { return ticks_; }
    /// Ticks that balls flew without touching anything, or being pulled at, all balls added up.
    std::uint64_t freeTicks() const { return freeTicks_; }
    /// How often a ball was slower than half its speed for half a second.
    std::uint32_t halts() const { return halts_; }
    /// Ticks that balls were outside the field other than below, all balls added up, and bodies
    /// that were no longer sound.
    std::uint32_t escapes() const { return escapes_; }
    /// How often a ball turned although it touched nothing and no field of force was at work.
    std::uint32_t bends() const { return bends_; }
    /// Ticks in play, in a row, in which no block took harm.
    std::uint32_t longestWait() const { return longestWait_; }
    bool clean() const { return halts_ == 0 && escapes_ == 0 && bends_ == 0; }

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
    std::uint64_t ticks_ = 0;
    std::uint64_t freeTicks_ = 0;
    std::uint32_t halts_ = 0;
    std::uint32_t escapes_ = 0;
    std::uint32_t bends_ = 0;
    std::uint32_t wait_ = 0;
    std::uint32_t longestWait_ = 0;
};

} // namespace apart
