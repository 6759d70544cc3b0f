// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/controls/bindings.hpp>
#include <kodo/math.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace apart {

/// A pressed key or button. Its effect depends on the screen.
enum class Command : std::uint8_t {
    Launch,  // space: serve; in menus equal to Confirm
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

/// What acts on a paddle.
struct PaddleSignals {
    bool leftHeld = false;
    bool rightHeld = false;
    bool pullHeld = false;  // a key, or the left button of a captured mouse
    bool pushHeld = false;  // a key, or the right button of a captured mouse
    bool serveHeld = false; // a key, a button, or the left one of a captured mouse
    kodo::Real stick = 0;   // -1..1, of a gamepad; 0 within its dead zone
    kodo::Real moved = 0;   // m to the right, by a captured mouse
};

/// Input of one of two players at one screen. The mouse is that of the first one.
struct SeatSignals : PaddleSignals {
    bool serves = false; // the serve was pressed
};
inline constexpr std::size_t kSeats = 2;

/// Input of the player since the previous poll.
struct Signals : PaddleSignals {
    std::array<SeatSignals, kSeats> seats{}; // the same keys and gamepads, of two players
    std::optional<kodo::Vec2> pointer{};     // m; new position of a free mouse, if it moved
    bool clicked = false;                    // at `pointerNow`; also for a captured mouse
    kodo::Vec2 pointerNow{};                 // m
    bool dragging = false;                   // the left button of a free mouse is held
    bool shiftHeld = false;
    std::vector<Command> commands{}; // in order of pressing
    std::vector<Press> presses{};    // the same keys and buttons, whatever they mean
    int keyHeld = kNoKey;            // the one that was pressed last, while it is held
    bool anyKey = false;             // any key was pressed, even an unassigned one
    bool focusLost = false;
    bool closed = false; // by the window's close button
};

/// Source of the player's input.
class Controls {
public:
    virtual ~Controls() = default;
    /// Input since the previous call.
    virtual Signals poll() = 0;
    /// While captured, the mouse reports displacements instead of positions.
    virtual void capture(bool on) = 0;
};

} // namespace apart
