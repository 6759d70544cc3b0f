// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/replay.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/pose_blend.hpp>

#include <memory>

namespace apart {

/// The player's best game of a level, played again beside the current one, tick by tick. Only its
/// paddle and balls are shown. It is a Game of its own: nothing of it reaches the current game.
class Ghost {
public:
    Ghost(Replay replay, std::shared_ptr<const Level> level);

    void tick();
    bool done() const { return playback_.done(); }
    const Game& game() const { return playback_.game(); }
    /// Paints its paddle and balls with this opacity (0..1), between the previous tick (share 0)
    /// and the latest one (share 1). Nothing after its end.
    void draw(Canvas& canvas, Real share, float opacity) const;

private:
    Playback playback_;
    PoseBlend poses_;
};

} // namespace apart
