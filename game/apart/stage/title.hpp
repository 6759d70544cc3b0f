// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas.hpp>

namespace apart {

/// The name of the game, with pieces that fly off it.
void paintTitle(Canvas& canvas, double seconds);

} // namespace apart
