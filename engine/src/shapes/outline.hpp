// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>

#include <span>

namespace kodo {
inline namespace KODO_PRECISION {

/// Area (m^2) within a closed outline; < 0 if its points go clockwise.
Real areaWithin(std::span<const Vec2> points);

} // namespace KODO_PRECISION
} // namespace kodo
