// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

#include <vector>

namespace apart {

/// True if a wind or a well bends the paths of balls.
bool isBent(const Game& game);

/// A ball alone between the walls, under the force fields of a game.
class LoneFlight {
public:
    static constexpr kodo::Real kStep = kodo::Real(1) / 60; // s

    /// `heading`: unit; `velocity` in m/s.
    LoneFlight(const Game& game, kodo::Vec2 place, kodo::Vec2 heading, kodo::Vec2 velocity);
    void step();
    kodo::Vec2 place() const { return world_[ball_].position(); }

private:
    kodo::World world_;
    kodo::BodyId ball_;
    kodo::Vec2 heading_;
    kodo::Real speed_; // m/s; held by the servo
};

/// Path (m) of the centre of the riding ball, once served, to its first touch: its ends, and points
/// between them where forces bend it. In Mode::Assisted a straight path goes on for
/// kAssistedBounces. Empty if no ball rides. What moves counts as standing still.
std::vector<kodo::Vec2> servePath(const Game& game);

} // namespace apart
