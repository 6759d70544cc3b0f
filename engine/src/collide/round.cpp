// SPDX-License-Identifier: MIT
#include "collide/round.hpp"

#include <cmath>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

namespace {

/// Side of a line on which a point is. A point on the line, within rounding, is in front: at the
/// normal of its second face, as for one-sided lines.
RoundAxis sideOf(const ConvexShape& line, Vec2 point) {
    const Real front = dot(line.normals[1], point - line.vertices[1]);
    const Vec2 size = point - line.vertices[0];
    const Real rounding = 8 * std::numeric_limits<Real>::epsilon() *
                          (std::abs(size.x) + std::abs(size.y) + line.boundingRadius);
    const bool behind = front < -rounding;
    return {line.normals[behind ? 0 : 1], behind ? -front : front, behind ? 0u : 1u};
}

} // namespace

RoundAxis nearestToCenter(const ConvexShape& polygon, Vec2 center) {
    const std::size_t n = polygon.vertices.size();
    RoundAxis axis{{}, -std::numeric_limits<Real>::infinity(), 0};
    for (std::size_t i = 0; i < n; ++i) {
        const Real distance = dot(polygon.normals[i], center - polygon.vertices[i]);
        if (distance > axis.distance) {
            axis = {polygon.normals[i], distance, i};
        }
    }
    if (polygon.isLine()) {
        axis = sideOf(polygon, center);
    } else if (axis.distance <= 0) {
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
