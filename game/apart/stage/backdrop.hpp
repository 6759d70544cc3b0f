// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>

namespace apart {

/// Fills everything visible: night, a glow behind the field, and the walls around it.
void paintBackdrop(Canvas& canvas);

/// Covers everything visible evenly, for what is written over the game.
void paintVeil(Canvas& canvas, Color color);

} // namespace apart
