// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/canvas/color.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Colours of the game that are the same for all players. Colour is never the only cue: stuffs also
/// have a grain, powers a symbol.
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
// By Turf: of its depth, and of its upper edge.
inline constexpr std::array<Color, 4> kSoil = {
    {{74, 58, 48}, {70, 72, 84}, {112, 92, 62}, {84, 60, 42}}};
inline constexpr std::array<Color, 4> kTurf = {
    {{104, 150, 74}, {138, 142, 156}, {206, 180, 124}, {160, 118, 78}}};
inline constexpr Color kWater{44, 120, 176};
inline constexpr Color kFoam{196, 232, 246}; // surface and drops of water
inline constexpr Color kBall{255, 248, 232};
inline constexpr Color kPaddle{84, 214, 206};

} // namespace apart::palette

namespace apart {

/// Colour vision of the player.
enum class Vision : std::uint8_t { Usual, Deuteranopia, Protanopia, Tritanopia };
inline constexpr std::size_t kVisions = 4;

/// Colours of stuffs and powers, chosen for one kind of colour vision.
struct Palette {
    std::array<Color, kStuffNames.size()> stuff;
    std::array<Color, kPowerNames.size()> power;

    constexpr Color of(Stuff which) const { return stuff[static_cast<std::size_t>(which)]; }
    constexpr Color of(Power which) const { return power[static_cast<std::size_t>(which)]; }
};

const Palette& paletteOf(Vision vision);
/// The palette of Settings::colors; values out of range mean Vision::Usual.
const Palette& paletteOf(int vision);

} // namespace apart
