// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>

#include "shapes/outline.hpp"

#include <algorithm>
#include <string>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Appends the lower half of the hull of the sorted points first..last, without its last point
/// [Andrew79].
template <typename Iterator>
void addHalf(Iterator first, Iterator last, std::vector<Vec2>& hull) {
    const std::size_t bottom = hull.size();
    for (Iterator p = first; p != last; ++p) {
        while (hull.size() >= bottom + 2 &&
               cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0) {
            hull.pop_back();
        }
        hull.push_back(*p);
    }
    hull.pop_back();
}

} // namespace

std::variant<Polygon, Problem> convexHull(std::span<const Vec2> points) {
    std::vector<Vec2> sorted(points.begin(), points.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (const auto problem = check(Primitive(Point{sorted[i]}))) {
            return Problem{"points[" + std::to_string(i) + "]", problem->reason};
        }
    }
    std::sort(sorted.begin(), sorted.end(), // total order: equal points are identical
              [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) {
        return Problem{"points", "must contain at least 3 distinct ones, but contain " +
                                     std::to_string(sorted.size())};
    }
    Polygon polygon;
    addHalf(sorted.begin(), sorted.end(), polygon.corners);
    addHalf(sorted.rbegin(), sorted.rend(), polygon.corners);
    dropFlatCorners(polygon.corners);
    if (polygon.corners.size() < 3) {
        return Problem{"points", "lie on one line, to rounding"};
    }
    if (polygon.corners.size() > kMaxCorners) {
        return Problem{"points", "have a hull of " + std::to_string(polygon.corners.size()) +
                                     " corners; a polygon has at most " +
                                     std::to_string(kMaxCorners)};
    }
    if (check(Primitive(polygon))) {
        return Problem{"points", "are too close to one line"};
    }
    return polygon;
}

} // namespace KODO_PRECISION
} // namespace kodo
