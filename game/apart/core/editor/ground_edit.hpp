// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/editor/level_parts.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace apart {

// Changes of ground that has an outline. `ground`: index into Level::obstructions.

inline constexpr std::int32_t kLowestCorner = 3000; // 1/1000 m, of ground in a level file

/// What the mouse takes of an outline: a corner, or the middle of the edge that begins there.
struct GroundGrip {
    std::size_t corner = 0;
    bool edge = false;
    friend bool operator==(const GroundGrip&, const GroundGrip&) = default;
};

bool hasOutline(const Level& level, LevelPart part);
kodo::Vec2 gripPlace(const ObstructionDef& ground, GroundGrip grip); // m
/// The nearest grip at a place (m); corners before middles of edges.
std::optional<GroundGrip> gripAt(const ObstructionDef& ground, kodo::Vec2 place);
/// Where a corner goes that the mouse puts at a place (m): into contact with what is beside it or
/// onto the grid, unless `free`. `own`: the ground that has it.
GroundPoint cornerAt(const Level& level, kodo::Vec2 place, bool free,
                     std::span<const LevelPart> own = {});

/// Corners in either direction; the level has them counter-clockwise.
Level withGround(Level level, std::vector<GroundPoint> corners, Turf turf);
/// Moves a corner, or adds one within an edge.
Level withCorner(Level level, std::size_t ground, GroundGrip grip, GroundPoint to);
Level withoutCorner(Level level, std::size_t ground, std::size_t corner);
Level withTurf(Level level, std::span<const LevelPart> parts, Turf turf);
/// The mirror image of a ledge or of ground about the middle of the field.
ObstructionDef mirrorImage(ObstructionDef def);
/// The same about the middle of an outline.
ObstructionDef flippedGround(const ObstructionDef& ground);

} // namespace apart
