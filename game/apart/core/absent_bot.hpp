// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

namespace apart {

/// Without a move of the paddle. Of 24 seeds in a row each has other aims or another force.
Input absentBot(const Game& game);

} // namespace apart
