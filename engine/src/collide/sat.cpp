// SPDX-License-Identifier: MIT
#include "collide/sat.hpp"

#include "math/lanes.hpp"

#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {

Climb climbToSupport(const ConvexShape& convex, Vec2 direction, std::size_t start) {
    const Vec2* vertices = convex.vertices.data();
    const std::size_t last = convex.vertices.size() - 1;
    Climb climb{start, 0};
    Real height = dot(direction, vertices[start]);
    const auto rises = [&](std::size_t next) {
        const Real h = dot(direction, vertices[next]);
        ++climb.steps;
        if (!(h > height)) {
            return false;
        }
        height = h;
        climb.vertex = next;
        return true;
    };
    // A rise at the first step decides the direction, so no vertex is compared twice.
    while (rises(climb.vertex == last ? 0 : climb.vertex + 1)) {
    }
    if (climb.vertex == start) {
        while (rises(climb.vertex == 0 ? last : climb.vertex - 1)) {
        }
    }
    return climb;
}

namespace {

/// Separation of b along each face of a: kLanes faces at a time.
FaceAxis scanFew(const ConvexShape& a, const ConvexShape& b, const Transform& ab, Real margin) {
    FaceAxis best{0, -std::numeric_limits<Real>::infinity()};
    const std::size_t faces = a.normals.size();
    for (std::size_t first = 0; first < faces && !(best.separation > margin); first += kLanes) {
        const Couple normal = loadPairs(&a.normals[first].x);
        const Couple on = loadPairs(&a.vertices[first].x);
        Lanes lowest = all(std::numeric_limits<Real>::infinity());
        for (const Vec2 vertex : b.vertices) {
            const Vec2 seen = ab * vertex;
            lowest = smaller(normal.x * all(seen.x) + normal.y * all(seen.y), lowest);
        }
        const Lanes above = lowest - (normal.x * on.x + normal.y * on.y);
        for (std::size_t i = 0; i < kLanes && first + i < faces; ++i) {
            if (above[i] > best.separation) {
                best = {first + i, above[i]};
            }
        }
    }
    return best;
}

} // namespace

FaceAxis leastPenetratingFace(const ConvexShape& a, const ConvexShape& b, const Transform& ab,
                              Real margin) {
    if (a.normals.size() <= ConvexShape::kFew) {
        return scanFew(a, b, ab, margin);
    }
    FaceAxis best{0, -std::numeric_limits<Real>::infinity()};
    std::size_t support = 0;
    for (std::size_t i = 0; i < a.normals.size() && !(best.separation > margin); ++i) {
        support = supportVertex(b, unrotate(ab.rotation, -a.normals[i]), support);
        const Vec2 deepest = ab * b.vertices[support];
        const Real above = dot(a.normals[i], deepest - a.vertices[i]);
        if (above > best.separation) {
            best = {i, above};
        }
    }
    return best;
}

} // namespace KODO_PRECISION
} // namespace kodo
