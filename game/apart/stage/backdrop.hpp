// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>
#include <apart/stage/canvas.hpp>

namespace apart {

/// Everything behind the blocks: the sky of the theme, its distance, the grid, the walls.
/// `seconds` moves what moves in the distance.
void paintBackdrop(Canvas& canvas, Theme theme, double seconds);

/// What stands far behind the field, faint enough that nothing in front is missed.
void paintDistance(Canvas& canvas, Theme theme, double seconds);

/// Dims the picture so far, so that text can be read.
void paintVeil(Canvas& canvas, Color color);

} // namespace apart
