// SPDX-License-Identifier: MIT
#include <kodo/shapes/convex.hpp>
#include <kodo/shapes/mass.hpp>

#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

std::vector<Vec2> cornersOf(const Circle& circle) {
    return {circle.center};
}

std::vector<Vec2> cornersOf(const Box& box) {
    const Real x = box.width / 2;
    const Real y = box.height / 2;
    std::vector<Vec2> corners{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    for (Vec2& corner : corners) {
        corner = box.center + box.rotation * corner;
    }
    return corners;
}

std::vector<Vec2> cornersOf(const Polygon& polygon) {
    return polygon.corners;
}

void finish(Convex& convex) {
    const std::size_t n = convex.vertices.size();
    for (const Vec2 vertex : convex.vertices) {
        convex.reach = std::max(convex.reach, length(vertex) + convex.radius);
    }
    convex.inside = convex.radius;
    if (n == 1) {
        return;
    }
    const Vec2 center = massOf(std::span<const Vec2>(convex.vertices), Real(1)).center;
    Real nearest = std::numeric_limits<Real>::max();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 edge = convex.vertices[(i + 1) % n] - convex.vertices[i];
        const Vec2 normal = normalize(Vec2{edge.y, -edge.x});
        convex.normals.push_back(normal);
        nearest = std::min(nearest, dot(normal, convex.vertices[i] - center));
    }
    convex.inside += nearest;
}

} // namespace

Convex convexOf(const Primitive& primitive, Vec2 origin) {
    Convex convex;
    convex.vertices = std::visit([](const auto& kind) { return cornersOf(kind); }, primitive);
    for (Vec2& vertex : convex.vertices) {
        vertex -= origin;
    }
    if (const auto* circle = std::get_if<Circle>(&primitive)) {
        convex.radius = circle->radius;
    }
    finish(convex);
    return convex;
}

Aabb boundsOf(const Convex& convex, const Transform& t) {
    const Vec2 first = t * convex.vertices[0];
    Aabb box{first, first};
    for (std::size_t i = 1; i < convex.vertices.size(); ++i) {
        const Vec2 p = t * convex.vertices[i];
        box = unite(box, {p, p});
    }
    return box.grown(convex.radius);
}

bool contains(const Convex& convex, const Transform& t, Vec2 point) {
    const Vec2 p = toLocal(t, point);
    if (convex.isRound()) {
        return lengthSquared(p - convex.vertices[0]) <= convex.radius * convex.radius;
    }
    for (std::size_t i = 0; i < convex.normals.size(); ++i) {
        if (dot(convex.normals[i], p - convex.vertices[i]) > convex.radius) {
            return false;
        }
    }
    return true;
}

} // namespace kodo::inline KODO_PRECISION
