// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

/// Theme of a group of levels. It selects the colours of the stage and changes no rule.
enum class Theme : std::uint8_t {
    Daybreak,    // fracture and parts
    Quarry,      // materials
    Fairground,  // bumpers, pegs, a leaping paddle
    Harbour,     // hanging blocks and wind
    Clockwork,   // motors and one-way gates
    Observatory, // gravity wells and unusual balls
    Fortress,    // bosses: one body of many blocks
};
inline constexpr std::array<std::string_view, 7> kThemeNames = {
    "daybreak", "quarry", "fairground", "harbour", "clockwork", "observatory", "fortress"};

} // namespace apart
