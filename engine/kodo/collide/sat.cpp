// SPDX-License-Identifier: MIT
#include <kodo/collide/sat.hpp>

#include <array>

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

namespace {

/// The vertices of b as seen from a, for as many as fit; more are climbed over instead.
class SeenVertices {
public:
    static constexpr std::size_t kMost = 8;

    SeenVertices(const Convex& b, const Transform& ab) : count_(b.vertices.size()) {
        for (std::size_t i = 0; i < count_; ++i) {
            seen_[i] = ab * b.vertices[i];
        }
    }
    FaceAxis below(const Convex& a, std::size_t face) const {
        const Vec2 normal = a.normals[face];
        std::size_t support = 0;
        Real lowest = dot(normal, seen_[0]);
        for (std::size_t i = 1; i < count_; ++i) {
            const Real height = dot(normal, seen_[i]);
            support = height < lowest ? i : support;
            lowest = height < lowest ? height : lowest;
        }
        return {face, support, lowest - dot(normal, a.vertices[face])};
    }

private:
    std::array<Vec2, kMost> seen_;
    std::size_t count_;
};

/// Calls below(face) for the face that looks most directly at b first, which settles it for most
/// pairs that are apart, then for all.
template <typename Below>
FaceAxis scanFaces(const Convex& a, Vec2 towardsB, Real margin, Below below) {
    std::size_t facing = 0;
    Real most = dot(a.normals[0], towardsB);
    for (std::size_t i = 1; i < a.normals.size(); ++i) {
        const Real along = dot(a.normals[i], towardsB);
        facing = along > most ? i : facing;
        most = along > most ? along : most;
    }
    FaceAxis best = below(facing);
    if (best.separation > margin) {
        return best;
    }
    best = below(0);
    for (std::size_t i = 1; i < a.normals.size() && !(best.separation > margin); ++i) {
        const FaceAxis axis = below(i);
        if (axis.separation > best.separation) {
            best = axis;
        }
    }
    return best;
}

} // namespace

FaceAxis leastPenetratingFace(const Convex& a, const Convex& b, const Transform& ab, Real margin) {
    const Vec2 towardsB = ab * b.middle - a.middle;
    if (b.vertices.size() <= SeenVertices::kMost) {
        const SeenVertices vertices(b, ab);
        return scanFaces(a, towardsB, margin,
                         [&](std::size_t face) { return vertices.below(a, face); });
    }
    std::size_t support = 0;
    return scanFaces(a, towardsB, margin, [&](std::size_t face) -> FaceAxis {
        support = supportVertex(b, unrotate(ab.rotation, -a.normals[face]), support);
        const Vec2 deepest = ab * b.vertices[support];
        return {face, support, dot(a.normals[face], deepest - a.vertices[face])};
    });
}

} // namespace kodo::inline KODO_PRECISION
