// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace apart {

/// What the player may turn up and down, in percent. No effect touches the simulation; 0 is off.
struct Settings {
    int particles = 100;
    int trail = 100;
    int squash = 100; // of balls, paddle and blocks that are struck
    int shake = 60;
    int flash = 60;
    int freeze = 60; // the picture holds for a moment at a hard blow
    int sound = 80;
    int mouse = 100; // how far the paddle goes for the way of the mouse
    int speed = 100; // of the game's time on the screen; the ticks are the same

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// One of them, as menus and the file of settings know it.
struct Dial {
    std::string_view key; // in the file
    std::string_view label;
    int Settings::*value;
    int least = 0;
    int most = 100;
};
inline constexpr std::array<Dial, 9> kDials = {
    Dial{"sound", "Sound", &Settings::sound},
    Dial{"mouse", "Speed of the mouse", &Settings::mouse, 20, 300},
    Dial{"speed", "Speed of the game", &Settings::speed, 50, 100},
    Dial{"particles", "Particles", &Settings::particles},
    Dial{"trail", "Trail of the ball", &Settings::trail},
    Dial{"squash", "Squash and stretch", &Settings::squash},
    Dial{"shake", "Shake", &Settings::shake},
    Dial{"flash", "Flashes", &Settings::flash},
    Dial{"freeze", "Hit-freeze", &Settings::freeze},
};

/// As a share, 0..1 for 0..100.
constexpr float share(int percent) {
    return static_cast<float>(percent) / 100.0f;
}

} // namespace apart
