// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/bot.hpp>
#include <apart/core/game.hpp>

#include <cstdint>
#include <optional>

namespace apart {

/// Plays a game with one kind of bot. The planner tries each serve, with each return of it, on
/// copies of the game, takes the one with the best outlook, and keeps it until the ball is met. The
/// other kinds need the current state alone.
class Player {
public:
    explicit Player(BotKind kind = BotKind::Good) : kind_(kind) {}

    /// Input of the next tick. One Player plays one game.
    Input next(const Game& game);

private:
    BotKind kind_;
    std::optional<kodo::Real> offset_{}; // m, of the planned return from the paddle's middle
    std::uint32_t hitTick_ = 0;          // Counts::hitTick when it was planned
};

} // namespace apart
