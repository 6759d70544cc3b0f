// SPDX-License-Identifier: MIT
#include <kodo/collide/sat.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {

Climb climbToSupport(const Convex& convex, Vec2 direction, std::size_t start) {
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
    // Whether it went up decides the way, so that no vertex is looked at twice.
    while (rises(climb.vertex == last ? 0 : climb.vertex + 1)) {
    }
    if (climb.vertex == start) {
        while (rises(climb.vertex == 0 ? last : climb.vertex - 1)) {
        }
    }
    return climb;
}

FaceAxis leastPenetratingFace(const Convex& a, const Convex& b, const Transform& ab, Real margin) {
    FaceAxis best{0, 0, -std::numeric_limits<Real>::infinity()};
    std::size_t support = 0;
    for (std::size_t i = 0; i < a.normals.size(); ++i) {
        support = supportVertex(b, unrotate(ab.rotation, -a.normals[i]), support);
        const Vec2 deepest = ab * b.vertices[support];
        const Real separation = dot(a.normals[i], deepest - a.vertices[i]);
        if (separation > best.separation) {
            best = {i, support, separation};
        }
        if (best.separation > margin) {
            break;
        }
    }
    return best;
}

} // namespace kodo::inline KODO_PRECISION
