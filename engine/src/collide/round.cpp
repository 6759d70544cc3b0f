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

/// nearestToCenter() without the radius of the shape.
RoundAxis nearestOfCore(const ConvexShape& shape, Vec2 center) {
    const std::size_t n = shape.vertices.size();
    if (n == 1) {
        const Vec2 arm = center - shape.vertices[0];
        const Real distance = length(arm);
        return {distance > 0 ? arm / distance : Vec2{0, 1}, distance, 0};
    }
    RoundAxis axis{{}, -std::numeric_limits<Real>::infinity(), 0};
    for (std::size_t i = 0; i < n; ++i) {
        const Real distance = dot(shape.normals[i], center - shape.vertices[i]);
        if (distance > axis.distance) {
            axis = {shape.normals[i], distance, i};
        }
    }
    if (n == 2) {
        axis = sideOf(shape, center);
    } else if (axis.distance <= 0) {
        return axis;
    }
    const std::size_t first = axis.feature;
    const std::size_t second = (first + 1) % n;
    const Vec2 edge = shape.vertices[second] - shape.vertices[first];
    for (const std::size_t end : {first, second}) {
        const Vec2 arm = center - shape.vertices[end];
        const Real along = end == first ? dot(arm, edge) : -dot(arm, edge);
        if (along < 0) {
            const Real distance = length(arm);
            return {arm / distance, distance, n + end};
        }
    }
    return axis;
}

} // namespace

RoundAxis nearestToCenter(const ConvexShape& shape, Vec2 center) {
    RoundAxis axis = nearestOfCore(shape, center);
    axis.distance -= shape.radius;
    return axis;
}

} // namespace KODO_PRECISION
} // namespace kodo
