// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/controls/controls.hpp>

#include <array>

namespace apart {

/// State of a gamepad. Shares of axes are -1..1, to the right and downwards.
struct Pad {
    float stickX = 0;
    float stickY = 0;
    float padX = 0; // of the directional pad
    float padY = 0;
    std::array<float, 2> triggers{}; // left and right, 1: pulled; more than half acts as a shoulder
    std::uint32_t held = 0; // a bit for each button: A B X Y, two shoulders, back, start, others

    /// Of two gamepads: all buttons, and the farther way of each axis.
    Pad joined(const Pad& other) const;
};

/// Keys, and buttons of a gamepad, with what they mean to the player; the same in every kind of
/// window. Keys are indices into kKeyNames.
class HeldKeys {
public:
    /// Keys and buttons of the player; the current ones until the next call.
    void setBindings(const Bindings& bindings) { bindings_ = bindings; }
    const Bindings& bindings() const { return bindings_; }
    /// In a game the bound keys precede those with a fixed meaning, in menus the other way round.
    void setInGame(bool inGame) { inGame_ = inGame; }

    void press(int key, Signals& signals);
    void release(int key);
    void releaseAll() { held_ = {}; }
    /// The gamepads of two players, once a frame. In menus, and for one player, they are as one.
    /// Buttons that were not held before are pressed. A tilt moves a menu once.
    void take(const std::array<Pad, kSeats>& pads, Signals& signals);
    /// Adds the keys that are held, and the left and the right button of the mouse.
    void addHeld(const std::array<bool, 2>& buttons, Signals& signals) const;

private:
    bool holds(Act act, std::size_t column) const;
    void addColumn(std::size_t column, PaddleSignals& signals) const;
    void addPad(const Pad& pad, PaddleSignals& signals) const;
    void give(Press press, std::optional<Command> fixed, Signals& signals) const;
    void pressButtons(std::uint32_t held, Signals& signals);
    void tilt(const Pad& pad, Signals& signals);

    Bindings bindings_;
    std::array<bool, kKeyNames.size()> held_{};
    int latest_ = kNoKey; // the key that was pressed last
    bool inGame_ = false;
    std::array<int, 2> tilt_{};            // -1, 0 or 1 along x and y, of the gamepad
    std::uint32_t buttonsHeld_ = 0;        // of the gamepad
    std::array<bool, kSeats> serveHeld_{}; // by the gamepad of a player
};

} // namespace apart
