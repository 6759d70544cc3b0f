// SPDX-License-Identifier: MIT
#include "collide/round.hpp"

#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

RoundAxis nearestToCenter(const ConvexShape& polygon, Vec2 center) {
    const std::size_t n = polygon.vertices.size();
    RoundAxis axis{{}, -std::numeric_limits<Real>::infinity(), 0};
    for (std::size_t i = 0; i < n; ++i) {
        const Real distance = dot(polygon.normals[i], center - polygon.vertices[i]);
        if (distance > axis.distance) {
            axis = {polygon.normals[i], distance, i};
        }
    }
    if (axis.distance <= 0 && !polygon.isLine()) {
        return axis;
    }
    const std::size_t first = axis.feature;
    const std::size_t second = (first + 1) % n;
    const Vec2 edge = polygon.vertices[second] - polygon.vertices[first];
    for (const std::size_t end : {first, second}) {
        const Vec2 arm = center - polygon.vertices[end];
        const Real along = end == first ? dot(arm, edge) : -dot(arm, edge);
        if (along < 0) {
            const Real distance = length(arm);
            return {arm / distance, distance, n + end};
        }
    }
    return axis;
}

} // namespace KODO_PRECISION
} // namespace kodo
