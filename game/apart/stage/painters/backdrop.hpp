// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>
#include <apart/stage/canvas/canvas.hpp>

namespace apart {

/// Paints everything behind the blocks: sky, distant scenery, grid and walls of the theme.
/// `seconds` is the time of the scenery's animation.
void paintBackdrop(Canvas& canvas, Theme theme, double seconds);

/// Paints the scenery far behind the field, faint enough to leave the foreground legible.
void paintDistance(Canvas& canvas, Theme theme, double seconds);

/// Paints the sky right of the field, behind the panel: it covers what a closeup shows there.
void paintPanelBack(Canvas& canvas, Theme theme);

/// Dims the picture painted so far to keep text legible.
void paintVeil(Canvas& canvas, Color color);

} // namespace apart
