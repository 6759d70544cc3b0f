// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>

namespace apart {

/// The title of the game, with pieces flying off its letters.
void paintTitle(Canvas& canvas, double seconds);

} // namespace apart
