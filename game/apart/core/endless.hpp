// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace apart {

/// Name of a generated level, written endless:SEED:NUMBER. The same name gives the same level on
/// every machine, so a replay stores only the name.
struct EndlessName {
    std::uint32_t seed = 1;
    std::uint32_t number = 1; // from 1; the difficulty rises with it

    std::string text() const;
    friend bool operator==(const EndlessName&, const EndlessName&) = default;
};

inline constexpr std::uint32_t kMostEndless = 999999; // the highest number

/// Parses endless:SEED:NUMBER, endless:SEED or endless; missing values are 1.
std::optional<EndlessName> parseEndless(std::string_view name);

/// Generates the level. Every block can be reached, and a good player can win. Even numbers are
/// walls. Odd ones are buildings: candidates are made until one servesHit(), stands() and
/// isSolvable(), see endless_building.hpp; a wall, if none of the first is. They depend on
/// kRulesVersion.
Level endlessLevel(const EndlessName& name);

/// Adds a kind of block with the usual pattern and strength of its stuff to a generated level.
/// Returns its index in Level::kinds.
std::uint8_t addUsualKind(Level& level, char letter, Stuff stuff, Power power, Support support);

} // namespace apart
