// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/convex_shape.hpp>
#include <support/every_kind.hpp>
#include <support/random_shapes.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

namespace support {

/// Every primitive that collides with another. A platform is a one-sided segment. A round box or
/// polygon has a radius, and a capsule may be a segment with one.
enum class AnyKind {
    Point,
    Circle,
    Box,
    Polygon,
    Segment,
    Plane,
    Capsule,
    RoundBox,
    RoundPolygon,
    Platform
};

/// Primitives with a mutual signed distance: all but the one-sided ones.
inline constexpr AnyKind kTwoSidedKinds[] = {
    AnyKind::Point, AnyKind::Circle,  AnyKind::Box,      AnyKind::Polygon,     AnyKind::Segment,
    AnyKind::Plane, AnyKind::Capsule, AnyKind::RoundBox, AnyKind::RoundPolygon};
inline constexpr AnyKind kEveryKind[] = {
    AnyKind::Point, AnyKind::Circle,  AnyKind::Box,      AnyKind::Polygon,      AnyKind::Segment,
    AnyKind::Plane, AnyKind::Capsule, AnyKind::RoundBox, AnyKind::RoundPolygon, AnyKind::Platform};

// A new primitive does not compile until it has an overload here, and its kind is listed above.
constexpr AnyKind kindOf(std::type_identity<kodo::Circle>) {
    return AnyKind::Circle;
}
constexpr AnyKind kindOf(std::type_identity<kodo::Box>) {
    return AnyKind::Box;
}
constexpr AnyKind kindOf(std::type_identity<kodo::Polygon>) {
    return AnyKind::Polygon;
}
constexpr AnyKind kindOf(std::type_identity<kodo::Point>) {
    return AnyKind::Point;
}
constexpr AnyKind kindOf(std::type_identity<kodo::Segment>) {
    return AnyKind::Segment;
}
constexpr AnyKind kindOf(std::type_identity<kodo::Plane>) {
    return AnyKind::Plane;
}
constexpr AnyKind kindOf(std::type_identity<kodo::Capsule>) {
    return AnyKind::Capsule;
}
template <typename... Primitives>
consteval bool meetsEvery(std::type_identity<std::variant<Primitives...>>) {
    return ((std::ranges::find(kEveryKind, kindOf(std::type_identity<Primitives>{})) !=
             std::end(kEveryKind)) &&
            ...);
}
static_assert(meetsEvery(std::type_identity<kodo::Primitive>{}));

inline const char* nameOf(AnyKind kind) {
    constexpr const char* kNames[] = {"point", "circle",  "box",       "polygon",       "segment",
                                      "plane", "capsule", "round_box", "round_polygon", "platform"};
    return kNames[static_cast<std::size_t>(kind)];
}

/// Radii (m) from far below the core's size to above it.
inline kodo::Real randomRadius(RandomNumbers& random) {
    return std::pow(kodo::Real(10), random.between(-3, 0.2));
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
    case AnyKind::Capsule: {
        kodo::Segment segment = randomSegment(random);
        segment.radius = randomRadius(random);
        if (random.below(2) == 0) {
            return segment;
        }
        return kodo::Capsule{segment.from, segment.to, segment.radius};
    }
    case AnyKind::RoundBox: {
        auto box = std::get<kodo::Box>(randomPrimitive(random, Kind::Box));
        box.radius = randomRadius(random);
        return box;
    }
    case AnyKind::RoundPolygon: {
        kodo::Polygon polygon = randomPolygon(random, 3 + random.below(18));
        polygon.radius = randomRadius(random);
        return polygon;
    }
    case AnyKind::Polygon:
        break;
    }
    return randomPolygon(random, 3 + random.below(18));
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
    return std::visit(
        Each{[](kodo::Circle circle) -> kodo::Primitive {
                 circle.center = mirrored(circle.center);
                 return circle;
             },
             [](kodo::Box box) -> kodo::Primitive {
                 box.center = mirrored(box.center);
                 box.rotation = box.rotation.inverse();
                 return box;
             },
             [&](kodo::Polygon polygon) -> kodo::Primitive {
                 std::ranges::transform(polygon.corners, polygon.corners.begin(), flip);
                 std::ranges::reverse(polygon.corners);
                 return polygon;
             },
             [](kodo::Point point) -> kodo::Primitive {
                 return kodo::Point{mirrored(point.position)};
             },
             [&](const kodo::Segment& segment) -> kodo::Primitive {
                 kodo::Segment result = mapped(segment, flip);
                 std::swap(result.from, result.to);
                 return result;
             },
             [](kodo::Plane plane) -> kodo::Primitive {
                 return kodo::Plane{mirrored(plane.normal), plane.offset};
             },
             [](kodo::Capsule capsule) -> kodo::Primitive { // as for a segment
                 return kodo::Capsule{mirrored(capsule.to), mirrored(capsule.from), capsule.radius};
             }},
        primitive);
}

inline kodo::Primitive scaled(const kodo::Primitive& primitive, kodo::Real s) {
    const auto grow = [s](kodo::Vec2 v) { return s * v; };
    return std::visit(
        Each{[&](const kodo::Circle& circle) -> kodo::Primitive {
                 return kodo::Circle{s * circle.radius, s * circle.center};
             },
             [&](const kodo::Box& box) -> kodo::Primitive {
                 return kodo::Box{s * box.width, s * box.height, s * box.center, box.rotation,
                                  s * box.radius};
             },
             [&](kodo::Polygon polygon) -> kodo::Primitive {
                 std::ranges::transform(polygon.corners, polygon.corners.begin(), grow);
                 polygon.radius *= s;
                 return polygon;
             },
             [&](const kodo::Point& point) -> kodo::Primitive {
                 return kodo::Point{s * point.position};
             },
             [&](const kodo::Segment& segment) -> kodo::Primitive {
                 kodo::Segment result = mapped(segment, grow);
                 result.radius *= s;
                 return result;
             },
             [&](const kodo::Plane& plane) -> kodo::Primitive {
                 return kodo::Plane{plane.normal, s * plane.offset};
             },
             [&](const kodo::Capsule& capsule) -> kodo::Primitive {
                 return kodo::Capsule{s * capsule.from, s * capsule.to, s * capsule.radius};
             }},
        primitive);
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
