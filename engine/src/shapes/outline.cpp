// SPDX-License-Identifier: MIT
#include "shapes/outline.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

Real areaWithin(std::span<const Vec2> points) {
    Real twice = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        twice += cross(points[i] - points[0], points[i + 1] - points[0]);
    }
    return twice / 2;
}

} // namespace KODO_PRECISION
} // namespace kodo
