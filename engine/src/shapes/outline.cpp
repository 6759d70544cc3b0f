// SPDX-License-Identifier: MIT
#include "shapes/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

struct Edge {
    Vec2 from;
    Vec2 to;
    Aabb bounds() const { return unite(Aabb{from, from}, Aabb{to, to}); }
};

/// True if two edges have a point in common: the ends of each are not on one side of the other.
bool meet(const Edge& e, const Edge& f) {
    const auto side = [](const Edge& edge, Vec2 p) {
        return cross(edge.to - edge.from, p - edge.from);
    };
    const auto apart = [](Real a, Real b) { return (a > 0 && b > 0) || (a < 0 && b < 0); };
    return overlap(e.bounds(), f.bounds()) && !apart(side(e, f.from), side(e, f.to)) &&
           !apart(side(f, e.from), side(f, e.to));
}

/// True if an edge goes back along the one before it.
bool foldsBack(const Edge& e, const Edge& next) {
    const Vec2 way = e.to - e.from;
    const Vec2 after = next.to - next.from;
    return cross(way, after) == 0 && dot(way, after) < 0;
}

} // namespace

bool isFlat(Vec2 before, Vec2 corner, Vec2 after) {
    if (dot(corner - before, after - corner) < 0) {
        return false;
    }
    const Real size = std::max(length(corner - before), length(after - corner));
    const Real height = std::abs(cross(corner - before, after - corner));
    return !(height > 2 * kFlatness * size * std::max(size, length(after - before)));
}

void dropFlatCorners(std::vector<Vec2>& corners) {
    for (std::size_t i = 0; corners.size() >= 3 && i < corners.size();) {
        const std::size_t n = corners.size();
        if (isFlat(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n])) {
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
            i = i > 0 ? i - 1 : 0; // the previous corner has a new neighbour
        } else {
            ++i;
        }
    }
}

Real areaWithin(std::span<const Vec2> points) {
    Real twice = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        twice += cross(points[i] - points[0], points[i + 1] - points[0]);
    }
    return twice / 2;
}

std::optional<EdgePair> edgesThatMeet(std::span<const Vec2> points) {
    const std::size_t n = points.size();
    const auto edge = [&](std::size_t i) { return Edge{points[i], points[(i + 1) % n]}; };
    const auto left = [&](std::size_t i) { return edge(i).bounds().lower.x; };
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { // total order
        return std::pair(left(i), i) < std::pair(left(k), k);
    });
    std::optional<EdgePair> found;
    for (std::size_t i = 0; i < n; ++i) {
        const Edge e = edge(order[i]);
        for (std::size_t k = i + 1; k < n && left(order[k]) <= e.bounds().upper.x; ++k) {
            const auto [first, second] = std::minmax(order[i], order[k]);
            const bool next = second == first + 1;
            const bool last = second == first + n - 1; // the first edge follows on the last one
            const bool bad = next   ? foldsBack(edge(first), edge(second))
                             : last ? foldsBack(edge(second), edge(first))
                                    : meet(edge(first), edge(second));
            if (bad &&
                (!found || std::tie(second, first) < std::tie(found->second, found->first))) {
                found = EdgePair{first, second};
            }
        }
    }
    return found;
}

} // namespace KODO_PRECISION
} // namespace kodo
