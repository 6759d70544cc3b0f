// SPDX-License-Identifier: MIT
#include <kodo/collide/sat.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {

std::size_t supportVertex(const Convex& convex, Vec2 direction, std::size_t start) {
    const std::size_t n = convex.vertices.size();
    std::size_t best = start;
    Real height = dot(direction, convex.vertices[best]);
    const auto climb = [&](std::size_t stride) {
        bool moved = false;
        for (std::size_t next = (best + stride) % n; next != start; next = (best + stride) % n) {
            const Real h = dot(direction, convex.vertices[next]);
            if (!(h > height)) {
                break;
            }
            best = next;
            height = h;
            moved = true;
        }
        return moved;
    };
    if (!climb(1)) {
        climb(n - 1);
    }
    return best;
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
