// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/body.hpp>

#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// Links the segments among the parts of a body that share an end point; see BasicSegment. Each
/// stores its own neighbours, computed by the same operations: both segments at a vertex agree bit
/// by bit on which of them owns a direction. Sets `before`, `after` and the valleys.
void linkLines(std::span<Part> parts);

} // namespace KODO_PRECISION
} // namespace kodo
