// SPDX-License-Identifier: MIT
#include <kodo/geometry.hpp>

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

/// Uses twice the flatness that check() refuses, so that rounding there cannot decide otherwise.
/// The point of a needle is not flat: without it, that point would lie far outside.
bool isFlat(Vec2 before, Vec2 corner, Vec2 after) {
    if (dot(corner - before, after - corner) < 0) {
        return false;
    }
    const Real size = std::max(length(corner - before), length(after - corner));
    const Real height = cross(corner - before, after - corner);
    return !(height > 2 * kFlatness * size * std::max(size, length(after - before)));
}

void dropFlatCorners(std::vector<Vec2>& hull) {
    for (std::size_t i = 0; hull.size() >= 3 && i < hull.size();) {
        const std::size_t n = hull.size();
        if (isFlat(hull[(i + n - 1) % n], hull[i], hull[(i + 1) % n])) {
            hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
            i = i > 0 ? i - 1 : 0; // the previous corner has a new neighbour
        } else {
            ++i;
        }
    }
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
