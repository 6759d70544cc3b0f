// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/theme.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace apart {

/// What a block is made of. It decides how the block breaks and how it looks and sounds.
enum class Stuff : std::uint8_t { Glass, Wood, Brick, Stone, Steel };
inline constexpr std::array<std::string_view, 5> kStuffNames = {"glass", "wood", "brick", "stone",
                                                                "steel"};

/// What a block lets go when it breaks.
enum class Power : std::uint8_t { None, Weld, Launch, Split };
inline constexpr std::array<std::string_view, 4> kPowerNames = {"none", "weld", "launch", "split"};

/// Into what pieces a block breaks.
enum class Pattern : std::uint8_t { Halves, Slats, Bricks, Shatter };
inline constexpr std::array<std::string_view, 4> kPatternNames = {"halves", "slats", "bricks",
                                                                  "shatter"};

/// By Stuff; of a block whose kind says nothing else.
inline constexpr std::array<Pattern, 5> kUsualPattern = {
    Pattern::Shatter, Pattern::Slats, Pattern::Bricks, Pattern::Halves, Pattern::Halves};

/// One kind of block, as the legend of a level describes it. Steel never breaks.
struct BlockKind {
    char letter = '?';
    Stuff stuff = Stuff::Brick;
    Power power = Power::None;
    Pattern pattern = Pattern::Bricks;
    std::int32_t strength = 0; // 1/1000 N s

    bool breakable() const { return stuff != Stuff::Steel; }
    friend bool operator==(const BlockKind&, const BlockKind&) = default;
};

/// One cell of the grid that holds a block. Row 0 is the highest, column 0 the leftmost.
struct Cell {
    std::uint8_t row = 0;
    std::uint8_t column = 0;
    std::uint8_t kind = 0; // index into Level::kinds

    friend bool operator==(const Cell&, const Cell&) = default;
};

inline constexpr int kColumns = 15;
inline constexpr int kMostRows = 15;

/// A level as the rules need it: numbers are whole, so that every machine reads the same.
struct Level {
    std::string name;               // of the file, without .toml
    std::string title;              // shown to the player
    std::string idea;               // one sentence: what is special about its physics
    Theme theme = Theme::Daybreak;
    std::int32_t place = 9999;      // in the order of levels
    std::int32_t ballSpeed = 12000; // 1/1000 m/s, when all blocks stand
    std::int32_t lives = 3;
    std::vector<BlockKind> kinds;
    std::vector<Cell> cells; // row by row, left to right

    friend bool operator==(const Level&, const Level&) = default;
};

/// Equal for levels that play alike; title, idea and comments of the file do not count.
std::uint64_t digestOf(const Level& level);

} // namespace apart
