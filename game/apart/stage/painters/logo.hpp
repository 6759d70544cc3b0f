// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>

namespace apart {

/// Paints the name of the game in stones of the game's stuffs. One letter after another cracks,
/// comes apart and closes again. `middle` is the middle of the base line, `height` that of the
/// capital (m), `seconds` the time of the animation.
void paintLogo(Canvas& canvas, Vec2 middle, Real height, double seconds);

} // namespace apart
