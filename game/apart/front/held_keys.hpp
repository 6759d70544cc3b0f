// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/controls.hpp>

#include <array>

namespace apart {

/// State of a gamepad.
struct Pad {
    float stick = 0;        // -1..1, to the right
    float padX = 0;         // -1..1, of the directional pad, to the right
    float padY = 0;         // -1..1, downwards
    std::uint32_t held = 0; // a bit for each button, in the order of HeldKeys::pressButton()
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
    /// Buttons are numbered in the order A B X Y, two shoulders, back, start.
    void pressButton(unsigned button, Signals& signals) const;
    /// Sticks and held buttons, once a frame.
    void take(const Pad& pad, Signals& signals);
    /// True while a key of the act is held.
    bool holds(Act act) const;

private:
    void give(Press press, std::optional<Command> fixed, Signals& signals) const;

    Bindings bindings_;
    std::array<bool, kKeyNames.size()> held_{};
    bool inGame_ = false;
    std::array<int, 2> padTilt_{}; // -1, 0 or 1 along x and y of the directional pad
};

} // namespace apart
