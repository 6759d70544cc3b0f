// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <kodo/kodo.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace apart {

/// A part of a level that can be taken by the mouse.
struct LevelPart {
    enum class Of : std::uint8_t { Water, Obstruction, Cell, Block, Well, Link };
    Of of = Of::Block;
    std::size_t index = 0; // into the vector of the level that has it

    friend auto operator<=>(const LevelPart&, const LevelPart&) = default;
};
using LevelParts = std::vector<LevelPart>;

/// A way of 1/1000 m.
struct EditStep {
    std::int32_t x = 0;
    std::int32_t y = 0;
    friend bool operator==(const EditStep&, const EditStep&) = default;
};

/// The part at a place (m): joints before blocks before the rest, later ones first.
std::optional<LevelPart> partAt(const Level& level, kodo::Vec2 place);
/// The parts whose middles are in a rectangle (m).
LevelParts partsIn(const Level& level, const kodo::Aabb& box);
/// The same parts after a document has put cells and obstructions in the order of the file.
LevelParts followed(LevelParts parts, const Level& before, const Level& after);
/// The free blocks at a place (m), the latest first; indices into Level::freeBlocks.
std::vector<std::int32_t> blocksAt(const Level& level, kodo::Vec2 place);
std::optional<std::size_t> blockAt(const Level& level, kodo::Vec2 place); // the latest one
/// m, in the field.
kodo::Aabb boundsOf(const Level& level, LevelPart part);

/// The gaps between a part and the nearest ones beside, below and above it (1/1000 m).
struct Gaps {
    static constexpr std::int32_t kFree = 1000000;
    std::int32_t left = kFree;
    std::int32_t right = kFree;
    std::int32_t below = kFree;
    std::int32_t above = kFree;
};
Gaps gapsBeside(const Level& level, LevelPart part);

/// The way that brings a part with these bounds (m) into contact with what is beside it, flush with
/// it, or to the middle of the field, if one of them is within kSnapReach; else to multiples of
/// kSnapGrid. `own`: parts that move with it.
EditStep snapped(const Level& level, const kodo::Aabb& bounds, std::span<const LevelPart> own,
                 EditStep step);
inline constexpr std::int32_t kSnapReach = 250; // 1/1000 m
inline constexpr std::int32_t kSnapGrid = 50;

} // namespace apart
