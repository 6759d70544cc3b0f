// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas/canvas.hpp>

namespace apart {

/// Enlargement of the field about a point that stays in place.
struct Closeup {
    Vec2 focus;     // m
    Real scale = 1; // 1: none
};

/// Turns the picture towards a large collapse, and back when it ends.
class CollapseCamera {
public:
    /// Call once per frame. `share` 0..1 is the strength of the effect.
    void advance(const Game& game, double seconds, float share);
    /// The closeup of this frame. Paddle and balls always stay in the picture, and nothing outside
    /// the field comes into it.
    Closeup closeup(const Game& game) const;

private:
    Vec2 focus_;
    Real scale_ = 1;
};

/// The part of the field that a closeup shows (m).
Aabb shownBy(const Closeup& closeup);

} // namespace apart
