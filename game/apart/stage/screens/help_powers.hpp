// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>

namespace apart {

/// Paints the page of the help that explains the powers: picture, name and effect of each.
void paintPowersPage(Canvas& canvas);

} // namespace apart
