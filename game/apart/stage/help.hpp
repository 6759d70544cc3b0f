// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/bindings.hpp>
#include <apart/stage/canvas.hpp>

namespace apart {

/// The page that explains the game.
void paintHelp(Canvas& canvas, const Bindings& keys);

} // namespace apart
