// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
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
    int slow = 100;  // slow motion during a collapse and at the last block
    int zoom = 60;   // of the picture towards a collapse
    int sound = 80;
    int music = 60;
    int mouse = 100;    // ratio of paddle displacement to mouse displacement
    int ghost = 40;     // opacity of the best game, which runs beside the current one
    int text = 100;     // size of texts
    int colors = 0;     // a Vision
    int calm = 0;       // 1: reduced flashing
    int openLevels = 0; // 1: all levels of the map are open
    int speed = 100;    // of the game's time relative to real time; the ticks stay the same

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Description of one setting, for menus and the profile file.
struct Dial {
    std::string_view key; // in the profile file
    std::string_view label;
    int Settings::*value;
    int least = 0;
    int most = 100;
    int page = 0;                                 // of the options
    std::span<const std::string_view> words = {}; // of the values from 0 on, instead of percent
};
inline constexpr std::array<std::string_view, 4> kDialPages = {"Sound and speed", "Effects",
                                                               "Legibility", "Levels"};
inline constexpr std::array<std::string_view, 2> kOffOn = {"off", "on"};
inline constexpr std::array<std::string_view, 4> kColorWords = {"usual", "deuteranopia",
                                                                "protanopia", "tritanopia"};
inline constexpr std::array<Dial, 17> kDials = {
    Dial{"sound", "Sound", &Settings::sound},
    Dial{"music", "Music", &Settings::music},
    Dial{"mouse", "Speed of the mouse", &Settings::mouse, 20, 300},
    Dial{"speed", "Speed of the game", &Settings::speed, 50, 100},
    Dial{"ghost", "Ghost (best game)", &Settings::ghost},
    Dial{"particles", "Particles", &Settings::particles, 0, 100, 1},
    Dial{"trail", "Trail of the ball", &Settings::trail, 0, 100, 1},
    Dial{"squash", "Squash and stretch", &Settings::squash, 0, 100, 1},
    Dial{"flash", "Flashes", &Settings::flash, 0, 100, 1},
    Dial{"freeze", "Hit-freeze", &Settings::freeze, 0, 100, 1},
    Dial{"shake", "Shake", &Settings::shake, 0, 100, 1},
    Dial{"slow-motion", "Slow motion", &Settings::slow, 0, 100, 1},
    Dial{"zoom", "Zoom to a collapse", &Settings::zoom, 0, 100, 1},
    Dial{"text", "Size of texts", &Settings::text, 100, 140, 2},
    Dial{"colors", "Colours", &Settings::colors, 0, 3, 2, kColorWords},
    Dial{"reduced-flashing", "Reduced flashing", &Settings::calm, 0, 1, 2, kOffOn},
    Dial{"open-levels", "All levels open", &Settings::openLevels, 0, 1, 3, kOffOn},
};

/// Converts percent to a share: 100 becomes 1.
constexpr float share(int percent) {
    return static_cast<float>(percent) / 100.0f;
}

} // namespace apart
