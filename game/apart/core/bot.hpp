// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

namespace apart {

/// Where and when a ball that flies down will reach the height of the dome, bouncing off the side
/// walls alone.
struct Arrival {
    kodo::Real x = 0;       // m
    kodo::Real seconds = 0; // from now
};

std::optional<Arrival> arrivalOf(const Game& game, const Ball& ball);

/// A good player: a function of the game as it is. It meets the ball that comes first, with the
/// spot of the dome that sends it to a block, catches parts when there is time, and serves at once.
Input bot(const Game& game);

} // namespace apart
