// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>
#include <kodo/math.hpp>

#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Rot directionOf(Vec2 edge) {
    const Vec2 unit = normalize(edge);
    return {unit.x, unit.y};
}

/// Bounds of the corners in a rotated frame with its origin at corner 0.
Aabb turnedBounds(const std::vector<Vec2>& corners, Rot rotation) {
    Aabb bounds{};
    for (const Vec2 corner : corners) {
        const Vec2 p = unrotate(rotation, corner - corners[0]);
        bounds = unite(bounds, {p, p});
    }
    return bounds;
}

Box smallestBox(const std::vector<Vec2>& corners) {
    Box best;
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Rot rotation = directionOf(corners[(i + 1) % corners.size()] - corners[i]);
        const Aabb bounds = turnedBounds(corners, rotation);
        const Vec2 size = bounds.extent();
        if (size.x * size.y < least) {
            least = size.x * size.y;
            best = {size.x, size.y, corners[0] + rotation * bounds.center(), rotation};
        }
    }
    return best;
}

/// Cosine of the interior angle: larger means sharper.
Real sharpness(Vec2 before, Vec2 corner, Vec2 after) {
    return dot(normalize(before - corner), normalize(after - corner));
}

} // namespace

std::variant<Box, Problem> fitBox(std::span<const Vec2> points) {
    const std::variant<Polygon, Problem> hull = convexHull(points);
    if (const auto* problem = std::get_if<Problem>(&hull)) {
        return *problem;
    }
    return smallestBox(std::get<Polygon>(hull).corners);
}

Arranged arrange(const Polygon& polygon) {
    const std::size_t n = polygon.corners.size();
    const Rot back = smallestBox(polygon.corners).rotation;
    std::size_t sharpest = 0;
    Real most = -std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
        const Real cosine = sharpness(polygon.corners[(i + n - 1) % n], polygon.corners[i],
                                      polygon.corners[(i + 1) % n]);
        if (cosine > most) {
            most = cosine;
            sharpest = i;
        }
    }
    Arranged result{{}, back};
    for (std::size_t i = 0; i < n; ++i) {
        result.polygon.corners.push_back(unrotate(back, polygon.corners[(sharpest + i) % n]));
    }
    return result;
}

} // namespace KODO_PRECISION
} // namespace kodo
