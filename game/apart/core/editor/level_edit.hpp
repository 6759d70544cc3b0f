// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/editor/level_parts.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace apart {

// Changes of a level, each as a function from a level to another one.

/// Ends of joints move with their blocks. What is in the grid moves from cell to cell.
Level moved(Level level, std::span<const LevelPart> parts, EditStep step);
/// Joints of removed blocks are removed too.
Level without(Level level, LevelParts parts);
/// Adds mirror images about the middle of the field of blocks, ledges, ground, and joints
/// between them.
Level withMirrorImages(Level level, std::span<const LevelPart> parts);
/// Turns each block or ledge about its middle by 1/1000 degree, counter-clockwise.
Level turned(Level level, std::span<const LevelPart> parts, std::int32_t by);
/// Exchanges left and right of the shapes of blocks, and of ground that has an outline.
Level flipped(Level level, std::span<const LevelPart> parts);

/// A kind of block with the usual strength and pattern of its stuff.
BlockKind standingKind(Stuff stuff, Support support = Support::Standing);
/// A kind equal to `kind` but for its letter is used again; else it gets a free letter.
Level withBlock(Level level, const BlockKind& kind, FreeBlock block);
/// `place`: m, of its middle; `width`: 1/1000 m.
Level withLedge(Level level, kodo::Vec2 place, std::int32_t width);
/// A rope from a place to another one (m), at the blocks that are there or at the field; nullopt:
/// neither end is at a block that moves. Ends go to the middles of blocks that are near and onto
/// the grid, unless `free`.
std::optional<Level> withRope(Level level, kodo::Vec2 from, kodo::Vec2 to, bool free = false);
/// A pin at a place (m), through the latest two blocks there, or one and the field. If two blocks
/// are chosen, it joins these, wherever they are.
std::optional<Level> withPin(Level level, kodo::Vec2 place, std::span<const LevelPart> chosen = {},
                             bool free = false);

} // namespace apart
