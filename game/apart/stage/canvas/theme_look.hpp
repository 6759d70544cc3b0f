// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>
#include <apart/stage/canvas/color.hpp>

#include <string_view>

namespace apart {

/// Title and colours of a theme.
struct ThemeLook {
    std::string_view title;
    Color night{};   // corners of the picture
    Color dusk{};    // behind the middle of the field
    Color frame{};   // walls
    Color glow{};    // titles
    Color distant{}; // scenery far behind the field, hardly lighter than the night
};

const ThemeLook& lookOf(Theme theme);

} // namespace apart
