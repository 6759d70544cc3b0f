// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/math/vec2.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace apart {

/// A key or button that was pressed. What it does depends on the screen.
enum class Command : std::uint8_t {
    Launch,  // space: serve; in menus the same as Confirm
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
    bool pullHeld = false;               // a key, or the left button of a captured mouse
    bool pushHeld = false;               // a key, or the right button
    kodo::Real moved = 0;                // m to the right, by a captured mouse
    std::optional<kodo::Vec2> pointer{}; // m; where the free mouse has moved to, if it has
    bool clicked = false;                // at `pointerNow`; a captured mouse clicks too
    kodo::Vec2 pointerNow{};             // m
    std::vector<Command> commands{};     // in the order of pressing
    bool anyKey = false;                 // was pressed, even one that means nothing
    bool focusLost = false;
    bool closed = false; // the window's own button
};

/// Where the player's wishes come from.
class Controls {
public:
    virtual ~Controls() = default;
    /// Forgets what it told before.
    virtual Signals poll() = 0;
    /// While captured, the mouse has no place, only ways that it goes.
    virtual void capture(bool on) = 0;
};

} // namespace apart
