// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/stage/controls.hpp>

#include <optional>

namespace apart {

/// Maps held keys and mouse displacements to the input of each tick. Mouse displacements move a
/// target position of the paddle. Equal displacements move it equally, and a replay holds only the
/// target.
class InputMapper {
public:
    /// Call once per frame; the state applies from the next tick. Without a target, mouse
    /// displacements count from `paddleX` (m). `speed` is the ratio of target displacement to mouse
    /// displacement.
    void take(const Signals& signals, kodo::Real paddleX, kodo::Real speed);
    /// Launches at the next tick. The launching button pulls only after a release.
    void launch() { launch_ = pullSpent_ = true; }
    /// Input of one more tick.
    Input next();
    /// Clears all input, for instance when the screen changes.
    void letGo() { *this = {}; }

private:
    int held_ = 0;         // -1 left, 1 right
    int speed_ = 0;        // 0..127, while a key is held
    kodo::Real stick_ = 0; // -1..1
    Force force_ = Force::None;
    bool launch_ = false;
    bool pullSpent_ = false;
    std::optional<kodo::Real> target_; // m; valid until a key is pressed
};

} // namespace apart
