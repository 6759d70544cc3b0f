// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/generator.hpp>
#include <apart/core/level.hpp>

#include <cstdint>

namespace apart {

/// Adds towers of storeys on ledges to a level without blocks: rows of bricks, and pillars that
/// carry beams. Sets its idea. `hardness` 0..24 gives more storeys and stronger stuffs.
void addBuildings(Level& level, Generator& chance, std::uint32_t hardness);

/// True if nothing moves by 1 cm before all blocks of the building sleep, within kSettleTicks. What
/// sleeps does not move until it is touched.
bool stands(const Level& level);
inline constexpr std::uint32_t kSettleTicks = 960; // 8 s

/// True if the first thing on the path of the first serve is a block, for three seeds of four at
/// least.
bool servesHit(const Level& level);

/// True if the good bot wins within kSolveTicks, and a collapse of at least kLeastFall blocks is
/// among it.
bool isSolvable(const Level& level);
inline constexpr std::uint32_t kSolveTicks = 10800; // 90 s
inline constexpr std::int32_t kLeastFall = 5;

} // namespace apart
