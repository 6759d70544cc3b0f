// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas/canvas.hpp>

namespace apart {

/// Paints all that is in a level into a rectangle: blocks with their powers, obstructions, joints,
/// wells, wind, and a paddle or ball that differs from the usual one.
void paintPreview(Canvas& canvas, const Level& level, const Aabb& box);

} // namespace apart
