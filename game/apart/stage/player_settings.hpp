// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace apart {

/// Settings of the player, in percent; 0 turns an effect off. No effect influences the simulation.
struct Settings {
    int particles = 100;
    int trail = 100;
    int squash = 100; // deformation of balls, paddle and blocks after impacts
    int shake = 60;
    int flash = 60;
    int freeze = 60; // duration of the hit-freeze after a strong impact
    int sound = 80;
    int mouse = 100; // ratio of paddle displacement to mouse displacement
    int ghost = 40;  // opacity of the best game, which runs beside the current one
    int speed = 100; // of the game's time relative to real time; the ticks stay the same

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Description of one setting, for menus and the profile file.
struct Dial {
    std::string_view key; // in the profile file
    std::string_view label;
    int Settings::*value;
    int least = 0;
    int most = 100;
};
inline constexpr std::array<Dial, 10> kDials = {
    Dial{"sound", "Sound", &Settings::sound},
    Dial{"mouse", "Speed of the mouse", &Settings::mouse, 20, 300},
    Dial{"speed", "Speed of the game", &Settings::speed, 50, 100},
    Dial{"ghost", "Ghost (best game)", &Settings::ghost},
    Dial{"particles", "Particles", &Settings::particles},
    Dial{"trail", "Trail of the ball", &Settings::trail},
    Dial{"squash", "Squash and stretch", &Settings::squash},
    Dial{"shake", "Shake", &Settings::shake},
    Dial{"flash", "Flashes", &Settings::flash},
    Dial{"freeze", "Hit-freeze", &Settings::freeze},
};

/// Converts percent to a share: 100 becomes 1.
constexpr float share(int percent) {
    return static_cast<float>(percent) / 100.0f;
}

} // namespace apart
