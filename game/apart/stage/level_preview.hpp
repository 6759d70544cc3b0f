// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas.hpp>

namespace apart {

/// Paints all blocks, obstructions, wells and ropes of a level into a rectangle.
void paintPreview(Canvas& canvas, const Level& level, const Aabb& box);

} // namespace apart
