// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/color.hpp>

#include <array>
#include <cstddef>

/// Colours of the game. Colour is never the only cue: stuffs also have a grain, powers a symbol.
namespace apart::palette {

inline constexpr Color kNight{7, 8, 15}; // corners of the picture
inline constexpr Color kInk{8, 10, 20};  // outlines
inline constexpr Color kText{226, 232, 245};
inline constexpr Color kQuiet{140, 150, 178}; // less important text
inline constexpr Color kAccent{255, 204, 92}; // highlights
inline constexpr Color kDanger{255, 84, 92};
inline constexpr Color kBumper{255, 128, 170};
inline constexpr Color kMachine{156, 168, 196}; // motors, pins, gates
inline constexpr Color kGround{92, 104, 92};
inline constexpr Color kBall{255, 248, 232};
inline constexpr Color kPaddle{84, 214, 206};

inline constexpr std::array<Color, 5> kStuff = {
    Color{120, 220, 248, 205}, // glass
    Color{206, 150, 92},       // wood
    Color{212, 94, 76},        // brick
    Color{150, 158, 176},      // stone
    Color{84, 96, 120},        // steel
};
inline constexpr std::array<Color, kPowerNames.size()> kPower = {
    Color{226, 232, 245}, // none
    Color{118, 226, 130}, // weld
    Color{255, 170, 62},  // launch
    Color{198, 146, 255}, // split
    Color{188, 204, 226}, // heavy
    Color{255, 112, 128}, // lopsided
    Color{255, 146, 170}, // egg
    Color{214, 178, 128}, // rough
    Color{255, 96, 196},  // magnet
    Color{250, 224, 90},  // spring
    Color{120, 208, 255}, // wings
    Color{150, 140, 255}, // well
    Color{150, 226, 214}, // wind
};

constexpr Color of(Stuff stuff) {
    return kStuff[static_cast<std::size_t>(stuff)];
}
constexpr Color of(Power power) {
    return kPower[static_cast<std::size_t>(power)];
}

} // namespace apart::palette
