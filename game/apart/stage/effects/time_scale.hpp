// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/controls/player_settings.hpp>

namespace apart {

inline constexpr int kLargeCollapse = 6; // blocks from which on slow motion and zoom show it

/// Ratio of game time to real time. It falls when a ball nears the last block and during a large
/// collapse, and is 0 during a hit-freeze. Ticks are delayed, not changed.
class TimeScale {
public:
    /// Time scale of this frame; 1 is real time.
    double next(const Game& game, double seconds);
    /// Call after each tick.
    void tick(const Game& game, const Settings& settings);

private:
    double timeScale_ = 1;
    double slowSeconds_ = 0; // s of slow motion in this level so far, limited by kPatience
    double fallSeconds_ = 0; // s of slow motion in this collapse so far
    double slowShare_ = 1;   // 0..1, strength of slow motion
    double freezeLeft_ = 0;  // s of hit-freeze left
    double freezePause_ = 0; // s until the next hit-freeze is possible
};

} // namespace apart
