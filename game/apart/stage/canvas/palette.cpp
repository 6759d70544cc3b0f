// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/palette.hpp>

namespace apart {

namespace {

/// By Vision. Order: glass, wood, brick, stone, steel; powers as in kPowerNames. The sets for
/// deficient vision are the colours nearest to the usual ones with a distance (CIE76, as seen with
/// that vision) of 25 between any two stuffs and 15 between any two powers.
constexpr std::array<Palette, kVisions> kPalettes = {{
    {{Color{120, 220, 248, 205}, {206, 150, 92}, {212, 94, 76}, {150, 158, 176}, {84, 96, 120}},
     {Color{226, 232, 245},
      {118, 226, 130},
      {255, 170, 62},
      {198, 146, 255},
      {188, 204, 226},
      {255, 112, 128},
      {255, 146, 170},
      {214, 178, 128},
      {255, 96, 196},
      {250, 224, 90},
      {120, 208, 255},
      {150, 140, 255},
      {150, 226, 214}}},
    {{Color{120, 224, 254, 205}, {224, 163, 100}, {181, 69, 55}, {158, 158, 170}, {87, 96, 120}},
     {Color{226, 232, 245},
      {135, 255, 173},
      {240, 155, 42},
      {172, 118, 214},
      {181, 202, 227},
      {243, 98, 121},
      {255, 149, 173},
      {213, 178, 122},
      {236, 76, 175},
      {250, 224, 89},
      {96, 207, 255},
      {154, 141, 255},
      {168, 237, 222}}},
    {{Color{124, 225, 254, 205}, {220, 161, 97}, {211, 93, 77}, {150, 154, 168}, {77, 90, 116}},
     {Color{226, 232, 245},
      {109, 218, 121},
      {255, 170, 59},
      {207, 152, 255},
      {208, 205, 190},
      {254, 109, 124},
      {255, 147, 173},
      {211, 177, 124},
      {255, 94, 195},
      {251, 221, 83},
      {118, 206, 255},
      {145, 126, 246},
      {152, 244, 243}}},
    {{Color{121, 221, 251, 205}, {206, 150, 92}, {212, 94, 76}, {152, 161, 178}, {82, 95, 117}},
     {Color{226, 232, 245},
      {105, 246, 146},
      {255, 173, 60},
      {202, 147, 255},
      {193, 212, 239},
      {244, 88, 103},
      {239, 131, 160},
      {205, 171, 119},
      {255, 89, 192},
      {251, 228, 97},
      {114, 202, 252},
      {145, 137, 253},
      {155, 225, 210}}},
}};

} // namespace

const Palette& paletteOf(Vision vision) {
    return kPalettes[static_cast<std::size_t>(vision)];
}

const Palette& paletteOf(int vision) {
    const bool known = vision >= 0 && vision < static_cast<int>(kVisions);
    return kPalettes[known ? static_cast<std::size_t>(vision) : 0];
}

} // namespace apart
