// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/stage/controls.hpp>

namespace apart {

/// Makes the input of each tick from what the player holds and moves.
class Hands {
public:
    /// Once a frame. What was pressed waits for the next tick.
    void take(const Signals& signals);
    void launch() { launch_ = true; }
    /// The input of one more tick.
    Input next();
    /// Forgets everything held, as when another screen comes up.
    void letGo() { *this = {}; }

private:
    int held_ = 0;  // -1 left, 1 right
    int speed_ = 0; // 0..127, while a key is held
    bool launch_ = false;
    std::optional<std::int16_t> target_; // 1/1000 m; the mouse rules until a key is pressed
};

} // namespace apart
