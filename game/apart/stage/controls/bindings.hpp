// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace apart {

/// What the player does in a game by a key or a button of the gamepad.
enum class Act : std::uint8_t { Left, Right, Pull, Push, Serve, Pause, Restart, Mute };
inline constexpr std::size_t kActs = 8;
inline constexpr std::array<std::string_view, kActs> kActNames = {
    "left", "right", "pull", "push", "serve", "pause", "restart", "mute"};

/// Names of the keys, in the profile file and on the screen. A key is an index into them, in the
/// order of sf::Keyboard::Key.
inline constexpr std::array<std::string_view, 101> kKeyNames = {
    "A",           "B",         "C",           "D",        "E",          "F",
    "G",           "H",         "I",           "J",        "K",          "L",
    "M",           "N",         "O",           "P",        "Q",          "R",
    "S",           "T",         "U",           "V",        "W",          "X",
    "Y",           "Z",         "0",           "1",        "2",          "3",
    "4",           "5",         "6",           "7",        "8",          "9",
    "escape",      "left ctrl", "left shift",  "left alt", "left super", "right ctrl",
    "right shift", "right alt", "right super", "menu",     "[",          "]",
    "semicolon",   "comma",     "period",      "quote",    "slash",      "backslash",
    "tilde",       "equal",     "hyphen",      "space",    "enter",      "backspace",
    "tab",         "page up",   "page down",   "end",      "home",       "insert",
    "delete",      "add",       "subtract",    "multiply", "divide",     "left",
    "right",       "up",        "down",        "pad 0",    "pad 1",      "pad 2",
    "pad 3",       "pad 4",     "pad 5",       "pad 6",    "pad 7",      "pad 8",
    "pad 9",       "F1",        "F2",          "F3",       "F4",         "F5",
    "F6",          "F7",        "F8",          "F9",       "F10",        "F11",
    "F12",         "F13",       "F14",         "F15",      "pause"};
inline constexpr int kNoKey = -1;
inline constexpr int kMostButtons =
    32; // of a gamepad, numbered from 0; without a name shown from 1

/// The key of a name; nullopt: there is none.
std::optional<int> keyNamed(std::string_view name);
std::string keyText(int key);       // "-" for kNoKey
std::string buttonText(int button); // "button A", "left shoulder", "button 9"

/// A pressed key or button.
struct Press {
    bool pad = false; // a button of the gamepad
    int code = kNoKey;
    friend bool operator==(Press, Press) = default;
};

/// The keys and buttons of the player. No key and no button has two acts.
struct Bindings {
    static constexpr std::size_t kColumns = 3; // two keys and a button
    static constexpr std::size_t kPadColumn = 2;
    using Row = std::array<int, kColumns>; // kNoKey: none

    std::array<Row, kActs> rows;
    bool fingers = false; // on a touch screen: prompts name fingers. No part of a profile

    Bindings();
    /// The act of a key or a button.
    std::optional<Act> actOf(Press press) const;
    int at(Act act, std::size_t column) const {
        return rows[static_cast<std::size_t>(act)][column];
    }
    std::string text(Act act, std::size_t column) const;
    /// The keys of an act for a prompt: "left or A"; the button if it has no key.
    std::string prompt(Act act) const;

    std::string firstKey(Act act) const; // the same, one key only
    /// Keys and the mouse: "left button, down or S"; on a touch screen "a second finger".
    std::string anyPrompt(Act act) const;

    /// Binds a key or a button, or none. Returns why it is refused, as a sentence, or "".
    std::string bind(Act act, std::size_t column, int code);

    friend bool operator==(const Bindings& a, const Bindings& b) { return a.rows == b.rows; }
};

/// Of two players at one screen, each has a column of keys: the first one the second column (A and
/// D unless bound otherwise), whose keys lie at the left.
inline constexpr std::array<std::size_t, 2> kColumnOfSeat = {1, 0};

/// True for keys that always have their meaning, and cannot be bound: escape, enter, F3, F11.
bool isReserved(int key);
/// True if the act can have a button: a stick moves the paddle.
bool hasButton(Act act);

} // namespace apart
