// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/theme_look.hpp>

#include <array>

namespace apart {

namespace {

constexpr std::array<ThemeLook, kThemeNames.size()> kLooks = {{
    {"Daybreak", {9, 8, 20}, {70, 44, 84}, {98, 84, 128}, {255, 190, 138}, {118, 68, 92}},
    {"Quarry", {10, 9, 11}, {62, 48, 42}, {104, 90, 80}, {242, 196, 136}, {96, 74, 58}},
    {"Fairground", {10, 6, 20}, {62, 28, 80}, {112, 70, 132}, {255, 150, 214}, {110, 52, 118}},
    {"Harbour", {4, 10, 18}, {16, 56, 82}, {62, 98, 120}, {128, 220, 240}, {32, 92, 118}},
    {"Clockwork", {11, 9, 6}, {62, 50, 26}, {122, 102, 62}, {255, 214, 122}, {104, 84, 42}},
    {"Observatory", {5, 6, 18}, {28, 34, 92}, {76, 84, 142}, {168, 184, 255}, {72, 82, 160}},
    {"Fortress", {12, 6, 8}, {70, 26, 34}, {118, 74, 80}, {255, 144, 132}, {112, 46, 52}},
}};

} // namespace

const ThemeLook& lookOf(Theme theme) {
    return kLooks[static_cast<std::size_t>(theme)];
}

} // namespace apart
