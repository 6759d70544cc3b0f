// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>
#include <apart/stage/canvas/canvas.hpp>

namespace apart {

/// Paints the land of a theme on the map: a ridge with what stands on it, down behind the one
/// of the band below. `open`: in its colours, else dim.
void paintLand(Canvas& canvas, Theme theme, const Aabb& band, bool open, double seconds);

// Signs of a closed level, and of a boss. `size`: m, half of the width.
void paintLock(Canvas& canvas, Vec2 middle, Real size, Color color);
void paintCrown(Canvas& canvas, Vec2 foot, Real size, Color color);

} // namespace apart
