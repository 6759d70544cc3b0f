// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/vec2.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace apart {

/// A key or button that was pressed. What it does depends on the screen.
enum class Command : std::uint8_t {
    Launch,  // space or click: serve; in menus the same as Confirm
    Confirm, // enter
    Back,    // escape
    Pause,
    Restart,
    Next, // next level
    Up,
    Down,
    Left,
    Right,
    Mute,
};

/// What the player did since the last look.
struct Signals {
    bool leftHeld = false;
    bool rightHeld = false;
    std::optional<kodo::Vec2> pointer{}; // m; where the mouse has moved to, if it has
    bool clicked = false;                // at `pointerNow`
    kodo::Vec2 pointerNow{};             // m
    std::vector<Command> commands{};     // in the order of pressing
    bool focusLost = false;
    bool closed = false; // the window's own button
};

/// Where the player's wishes come from.
class Controls {
public:
    virtual ~Controls() = default;
    /// Forgets what it told before.
    virtual Signals poll() = 0;
};

} // namespace apart
