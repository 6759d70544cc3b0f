// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/input.hpp>
#include <apart/stage/controls/controls.hpp>

#include <optional>

namespace apart {

/// Maps held keys and mouse displacements to the input of each tick. Mouse displacements move a
/// target position of the paddle. Equal displacements move it equally, and a replay holds only the
/// target.
class InputMapper {
public:
    /// Call once per frame; the state applies from the next tick. Without a target, mouse
    /// displacements count from `paddleX` (m). `speed` is the ratio of target displacement to mouse
    /// displacement. While the serve is held, all of it turns the serve instead.
    void take(const PaddleSignals& signals, kodo::Real paddleX, kodo::Real speed);
    /// Launches at the next tick. A ball that rides (`serve`: its heading) waits until the button
    /// is released. That button pulls only after a release.
    void launch(const PaddleSignals& signals, std::optional<kodo::Vec2> serve);
    /// True while the serve is held.
    bool aims() const { return angle_.has_value(); }
    /// Input of one more tick.
    Input next();
    /// Clears all input, for instance when the screen changes.
    void letGo() { *this = {}; }

private:
    int held_ = 0;         // -1 left, 1 right
    int speed_ = 0;        // 0..127, while a key is held
    kodo::Real stick_ = 0; // -1..1
    Force force_ = Force::None;
    bool launch_ = false; // at the next tick
    bool pullSpent_ = false;
    std::optional<kodo::Real> target_; // m; valid until a key is pressed
    std::optional<kodo::Real> angle_;  // rad, from the vertical to the right; while aiming
};

} // namespace apart
