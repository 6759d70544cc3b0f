// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/stage/controls.hpp>

namespace apart {

/// Makes the input of each tick from what the player holds and moves. The mouse moves a target for
/// the paddle, so that the same way of the mouse is the same way of the paddle wherever both are,
/// and a replay does not depend on the mouse.
class Hands {
public:
    /// Once a frame; what was pressed waits for the next tick. The first way of the mouse counts
    /// from the paddle's place (m), and `speed` is how far the target goes for it: 1 as far.
    void take(const Signals& signals, kodo::Real paddleX, kodo::Real speed);
    /// The button that launched does not pull until it has been let go.
    void launch() { launch_ = pullSpent_ = true; }
    /// The input of one more tick.
    Input next();
    /// Forgets everything held, as when another screen comes up.
    void letGo() { *this = {}; }

private:
    int held_ = 0;  // -1 left, 1 right
    int speed_ = 0; // 0..127, while a key is held
    Force force_ = Force::None;
    bool launch_ = false;
    bool pullSpent_ = false;
    std::optional<kodo::Real> target_; // m; the mouse rules until a key is pressed
};

} // namespace apart
