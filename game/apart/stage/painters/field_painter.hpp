// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/pose_blend.hpp>
#include <apart/stage/effects/juice.hpp>

namespace apart {

/// The state of the game at one time between two ticks.
struct Moment {
    const Game& game;
    const Juice& juice;
    const PoseBlend& poses;
    Real share = 1;              // 0 at the previous tick, 1 at the latest one
    Aabb shown = layout::kShown; // m, the part of the field in the picture
    bool words = true;           // points and words

    kodo::Transform placeOf(kodo::BodyId body) const {
        return poses.massFrame(game.world()[body], share);
    }
    /// Time of animations: ticks since the start of the game, with the fraction of the current
    /// tick.
    Real time() const { return static_cast<Real>(game.ticks() % 1000000) + share; }
};

/// Paints the field from back to front. Balls come last, so that nothing covers them.
void paintField(Canvas& canvas, const Moment& moment);

/// True once the blocks at a place (m) have appeared, in the first second of a level.
bool isBuilt(const Moment& moment, Vec2 place);

// Layers of the field.
void paintForces(Canvas& canvas, const Moment& moment);      // wind, wells, the paddle's field
void paintWaterBehind(Canvas& canvas, const Moment& moment); // behind what is in it
void paintWaterBefore(Canvas& canvas, const Moment& moment); // its surface, and what runs out
void paintMounts(Canvas& canvas, const Moment& moment);      // behind what they hold
void paintLinks(Canvas& canvas, const Moment& moment);       // joints
void paintObstructions(Canvas& canvas, const Moment& moment);
void paintGround(Canvas& canvas, const ObstructionDef& ground); // with an outline
void paintParts(Canvas& canvas, const Moment& moment);
void paintPaddle(Canvas& canvas, const Moment& moment);
void paintBalls(Canvas& canvas, const Moment& moment);

} // namespace apart
