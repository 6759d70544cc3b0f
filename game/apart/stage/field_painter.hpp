// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas.hpp>
#include <apart/stage/juice.hpp>
#include <apart/stage/pose_blend.hpp>

namespace apart {

/// The game at one moment between two ticks.
struct Moment {
    const Game& game;
    const Juice& juice;
    const PoseBlend& poses;
    Real share = 1; // 0 at the tick before, 1 at the last one

    kodo::Transform placeOf(kodo::BodyId body) const {
        return poses.placement(game.world()[body], share);
    }
    /// Ticks since the game began, with their fraction; what only moves on the screen goes by it.
    Real time() const { return static_cast<Real>(game.ticks() % 1000000) + share; }
};

/// All that is in the field, from back to front. Balls come last: nothing ever hides them.
void paintField(Canvas& canvas, const Moment& moment);

// Its layers.
void paintForces(Canvas& canvas, const Moment& moment); // wind, wells, the paddle's field
void paintObstructions(Canvas& canvas, const Moment& moment);
void paintParts(Canvas& canvas, const Moment& moment);
void paintPaddle(Canvas& canvas, const Moment& moment);
void paintBalls(Canvas& canvas, const Moment& moment);

} // namespace apart
