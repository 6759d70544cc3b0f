// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

/// What a group of levels is about. It changes no rule; the stage gives each its colours.
enum class Theme : std::uint8_t {
    Daybreak,    // how blocks come apart, and what they let go
    Quarry,      // what blocks are made of
    Fairground,  // what bounces: bumpers, pegs, a paddle that leaps
    Harbour,     // what hangs and what blows
    Clockwork,   // what turns, and what lets pass one way only
    Observatory, // what draws, and balls that do not fly or bounce like a ball
    Fortress,    // what is one body of many blocks
};
inline constexpr std::array<std::string_view, 7> kThemeNames = {
    "daybreak", "quarry", "fairground", "harbour", "clockwork", "observatory", "fortress"};

} // namespace apart
