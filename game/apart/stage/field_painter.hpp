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
};

/// All that is in the field, from back to front. Balls come last: nothing ever hides them.
void paintField(Canvas& canvas, const Moment& moment);

} // namespace apart
