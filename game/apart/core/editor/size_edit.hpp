// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/editor/level_parts.hpp>

#include <span>

namespace apart {

// Changes of sizes, each as a function from a level to another one.

/// Adds so much to widths and heights about the middles, to 100 mm at least. A round one takes
/// both for its diameter; a voussoir keeps its size.
FreeBlock resized(FreeBlock block, EditStep by);
Level resized(Level level, std::span<const LevelPart> parts, EditStep by);
/// The same for one part that is upright, with its edges in mind: one in contact with another part
/// stays there, and a growing one goes no further than to contact.
Level resizedToContact(const Level& level, LevelPart part, EditStep by);

} // namespace apart
