// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas.hpp>
#include <kodo/math/transform.hpp>

namespace apart {

/// The sign of a power: a plus for what welds, an arrow for what launches, three balls for what
/// splits. `size` is half its height (m).
void paintMark(Canvas& canvas, Power power, const kodo::Transform& place, Real size, Color color);

} // namespace apart
