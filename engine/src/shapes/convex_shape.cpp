// SPDX-License-Identifier: MIT
#include <kodo/convex_shape.hpp>
#include <kodo/measure.hpp>

#include <cmath>
#include <limits>
#include <span>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

void setVertices(ConvexShape& convex, const std::vector<Vec2>& vertices, Vec2 origin) {
    convex.vertices = ConvexShape::Points(vertices);
    for (Vec2& vertex : convex.vertices) {
        vertex -= origin;
    }
    const std::size_t n = convex.vertices.size();
    for (std::size_t i = 0; n > 1 && i < n; ++i) {
        const Vec2 edge = convex.vertices[(i + 1) % n] - convex.vertices[i];
        convex.normals.push_back(normalize(Vec2{edge.y, -edge.x}));
    }
}

void build(ConvexShape& convex, const Circle& circle, Vec2 origin) {
    convex.kind = ConvexKind::Round;
    convex.radius = circle.radius;
    convex.coreRadius = circle.radius;
    setVertices(convex, {circle.center}, origin);
    convex.middle = convex.vertices[0];
}

void build(ConvexShape& convex, const Point& point, Vec2 origin) {
    build(convex, Circle{0, point.position}, origin);
}

void build(ConvexShape& convex, const Capsule& capsule, Vec2 origin) {
    if (!(lengthSquared(capsule.to - capsule.from) > 0)) {
        build(convex, Circle{capsule.radius, capsule.from}, origin);
        return;
    }
    convex.kind = ConvexKind::Polygonal;
    convex.radius = capsule.radius;
    convex.coreRadius = capsule.radius;
    setVertices(convex, {capsule.from, capsule.to}, origin);
    convex.middle = Real(0.5) * (convex.vertices[0] + convex.vertices[1]);
}

void build(ConvexShape& convex, const Polygon& polygon, Vec2 origin) {
    convex.kind = ConvexKind::Polygonal;
    convex.radius = polygon.radius;
    setVertices(convex, polygon.corners, origin);
    convex.middle = massOf(std::span<const Vec2>(convex.vertices), Real(1)).center;
    convex.coreRadius = std::numeric_limits<Real>::max();
    for (std::size_t i = 0; i < convex.normals.size(); ++i) {
        const Real height = dot(convex.normals[i], convex.vertices[i] - convex.middle);
        convex.coreRadius = std::min(convex.coreRadius, height);
    }
    convex.coreRadius += convex.radius;
}

void build(ConvexShape& convex, const Box& box, Vec2 origin) {
    build(convex, polygonOf(box), origin);
}

void build(ConvexShape& convex, const Segment& segment, Vec2 origin) {
    if (segment.radius > 0) {
        build(convex, Capsule{segment.from, segment.to, segment.radius}, origin);
        return;
    }
    convex.kind = ConvexKind::Line;
    convex.oneSided = segment.oneSided;
    setVertices(convex, {segment.from, segment.to}, origin);
    convex.middle = Real(0.5) * (convex.vertices[0] + convex.vertices[1]);
}

void build(ConvexShape& convex, const Plane& plane, Vec2 origin) {
    convex.kind = ConvexKind::HalfPlane;
    const Vec2 normal = normalize(plane.normal);
    setVertices(convex, {plane.offset * normal}, origin);
    convex.normals.push_back(normal);
    convex.middle = convex.vertices[0];
    convex.coreRadius = kPlaneExtent;
}

/// Highest point of a half-plane below a line whose normal points upwards (across > 0), within
/// kPlaneExtent of the origin to both sides.
Real highest(Real along, Real across, Real offset) {
    return std::min((offset + std::abs(along) * kPlaneExtent) / across, kPlaneExtent);
}

Aabb boundsOfPlane(Vec2 normal, Real offset) {
    Aabb box{{-kPlaneExtent, -kPlaneExtent}, {kPlaneExtent, kPlaneExtent}};
    if (normal.y > 0) {
        box.upper.y = highest(normal.x, normal.y, offset);
    } else if (normal.y < 0) {
        box.lower.y = -highest(normal.x, -normal.y, offset);
    }
    if (normal.x > 0) {
        box.upper.x = highest(normal.y, normal.x, offset);
    } else if (normal.x < 0) {
        box.lower.x = -highest(normal.y, -normal.x, offset);
    }
    return box;
}

} // namespace

ConvexShape convexShapeOf(const Primitive& primitive, Vec2 origin) {
    ConvexShape convex;
    std::visit([&](const auto& kind) { build(convex, kind, origin); }, primitive);
    for (const Vec2 vertex : convex.vertices) {
        convex.boundingRadius = std::max(convex.boundingRadius, length(vertex) + convex.radius);
    }
    if (convex.isPlane()) {
        convex.boundingRadius = kPlaneExtent;
    }
    return convex;
}

Aabb boundsOfAngular(const ConvexShape& convex, const Transform& t) {
    const Vec2 first = t * convex.vertices[0];
    if (convex.isPlane()) {
        const Vec2 normal = t.rotation * convex.normals[0];
        return boundsOfPlane(normal, dot(normal, first));
    }
    Aabb box{first, first};
    for (std::size_t i = 1; i < convex.vertices.size(); ++i) {
        const Vec2 p = t * convex.vertices[i];
        box = unite(box, {p, p});
    }
    return box.grown(convex.radius);
}

bool contains(const ConvexShape& convex, const Transform& t, Vec2 point) {
    const Vec2 p = toLocal(t, point);
    if (convex.isRound()) {
        return lengthSquared(p - convex.vertices[0]) <= convex.radius * convex.radius;
    }
    if (convex.isLine()) {
        return contains(Segment{convex.vertices[0], convex.vertices[1]}, p);
    }
    const std::span<const Vec2> corners(convex.vertices);
    bool inCore = corners.size() != 2;
    for (std::size_t i = 0; inCore && i < corners.size(); ++i) {
        inCore = !(dot(convex.normals[i], p - corners[i]) > 0);
    }
    return inCore || (convex.radius > 0 && contains(corners, convex.radius, p));
}

} // namespace KODO_PRECISION
} // namespace kodo
