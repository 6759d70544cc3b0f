// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/shape.hpp>
#include <support/random_shapes.hpp>

#include <algorithm>

namespace support {

/// Every primitive that collides with another. A platform is a one-sided segment; a cell is a
/// one-sided segment with neighbours, as in a heightmap.
enum class AnyKind { Point, Circle, Box, Polygon, Segment, Plane, Platform };

/// Primitives with a mutual signed distance: all but the one-sided ones.
inline constexpr AnyKind kTwoSidedKinds[] = {AnyKind::Point,   AnyKind::Circle,  AnyKind::Box,
                                             AnyKind::Polygon, AnyKind::Segment, AnyKind::Plane};
inline constexpr AnyKind kEveryKind[] = {AnyKind::Point,   AnyKind::Circle,  AnyKind::Box,
                                         AnyKind::Polygon, AnyKind::Segment, AnyKind::Plane,
                                         AnyKind::Platform};

inline const char* nameOf(AnyKind kind) {
    constexpr const char* kNames[] = {"point",   "circle", "box",     "polygon",
                                      "segment", "plane",  "platform"};
    return kNames[static_cast<std::size_t>(kind)];
}

inline kodo::Segment randomSegment(RandomNumbers& random) {
    const kodo::Vec2 from = random.point(1.5);
    kodo::Segment segment{from, {}};
    do {
        segment.to = random.point(1.5);
    } while (lengthSquared(segment.to - from) < kodo::Real(0.04));
    return segment;
}

/// A primitive of about 1 m at or near its own origin. Polygons have 3 to 20 corners.
inline kodo::Primitive randomPrimitive(RandomNumbers& random, AnyKind kind) {
    switch (kind) {
    case AnyKind::Point:
        return kodo::Point{random.point(0.5)};
    case AnyKind::Circle:
        return randomPrimitive(random, Kind::Circle);
    case AnyKind::Box:
        return randomPrimitive(random, Kind::Box);
    case AnyKind::Segment:
        return randomSegment(random);
    case AnyKind::Plane: {
        const kodo::Rot normal = random.rotation();
        return kodo::Plane{normal.xAxis(), random.between(-0.5, 0.5)};
    }
    case AnyKind::Platform: {
        kodo::Segment segment = randomSegment(random);
        segment.oneSided = true;
        return segment;
    }
    default:
        return randomPolygon(random, 3 + random.below(18));
    }
}

inline kodo::Vec2 mirrored(kodo::Vec2 v) {
    return {-v.x, v.y};
}

inline kodo::Transform mirrored(const kodo::Transform& t) {
    return {mirrored(t.position), t.rotation.inverse()};
}

/// Applies a conformal map of the plane to all points.
template <typename Map>
kodo::Segment mapped(kodo::Segment segment, Map map) {
    segment.from = map(segment.from);
    segment.to = map(segment.to);
    return segment;
}

/// Mirrors a primitive. The order of corners is reversed to keep the orientation.
inline kodo::Primitive mirrored(const kodo::Primitive& primitive) {
    const auto flip = [](kodo::Vec2 v) { return mirrored(v); };
    if (const auto* circle = std::get_if<kodo::Circle>(&primitive)) {
        return kodo::Circle{circle->radius, mirrored(circle->center)};
    }
    if (const auto* box = std::get_if<kodo::Box>(&primitive)) {
        return kodo::Box{box->width, box->height, mirrored(box->center), box->rotation.inverse()};
    }
    if (const auto* point = std::get_if<kodo::Point>(&primitive)) {
        return kodo::Point{mirrored(point->position)};
    }
    if (const auto* plane = std::get_if<kodo::Plane>(&primitive)) {
        return kodo::Plane{mirrored(plane->normal), plane->offset};
    }
    if (const auto* segment = std::get_if<kodo::Segment>(&primitive)) {
        kodo::Segment result = mapped(*segment, flip);
        std::swap(result.from, result.to);
        return result;
    }
    kodo::Polygon polygon = std::get<kodo::Polygon>(primitive);
    std::transform(polygon.corners.begin(), polygon.corners.end(), polygon.corners.begin(), flip);
    std::reverse(polygon.corners.begin(), polygon.corners.end());
    return polygon;
}

inline kodo::Primitive scaled(const kodo::Primitive& primitive, kodo::Real s) {
    const auto grow = [s](kodo::Vec2 v) { return s * v; };
    if (const auto* circle = std::get_if<kodo::Circle>(&primitive)) {
        return kodo::Circle{s * circle->radius, s * circle->center};
    }
    if (const auto* box = std::get_if<kodo::Box>(&primitive)) {
        return kodo::Box{s * box->width, s * box->height, s * box->center, box->rotation};
    }
    if (const auto* point = std::get_if<kodo::Point>(&primitive)) {
        return kodo::Point{s * point->position};
    }
    if (const auto* plane = std::get_if<kodo::Plane>(&primitive)) {
        return kodo::Plane{plane->normal, s * plane->offset};
    }
    if (const auto* segment = std::get_if<kodo::Segment>(&primitive)) {
        return mapped(*segment, grow);
    }
    kodo::Polygon polygon = std::get<kodo::Polygon>(primitive);
    std::transform(polygon.corners.begin(), polygon.corners.end(), polygon.corners.begin(), grow);
    return polygon;
}

/// A box or polygon with at most kFew corners, the number stored inline, at or near its own origin.
inline kodo::ConvexShape randomFewCorners(RandomNumbers& random) {
    for (;;) {
        const AnyKind kind = random.below(2) == 0 ? AnyKind::Box : AnyKind::Polygon;
        const kodo::ConvexShape convex = convexShapeOf(randomPrimitive(random, kind), {});
        if (convex.vertices.size() <= kodo::ConvexShape::kFew) {
            return convex;
        }
    }
}

} // namespace support
