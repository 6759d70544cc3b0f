// SPDX-License-Identifier: MIT
#include <kodo_c/c_values.hpp>

#include <type_traits>
#include <variant>

namespace kodo_c {
namespace {

constexpr std::int32_t kShapeKinds = std::variant_size_v<kodo::Shape>;

static_assert(std::is_same_v<std::variant_alternative_t<KODO_CIRCLE, kodo::Shape>, kodo::Circle>);
static_assert(std::is_same_v<std::variant_alternative_t<KODO_BOX, kodo::Shape>, kodo::Box>);
static_assert(std::is_same_v<std::variant_alternative_t<KODO_POLYGON, kodo::Shape>, kodo::Polygon>);
static_assert(
    std::is_same_v<std::variant_alternative_t<KODO_COMPOUND, kodo::Shape>, kodo::Compound>);
static_assert(std::is_same_v<std::variant_alternative_t<KODO_POINT, kodo::Shape>, kodo::Point>);
static_assert(std::is_same_v<std::variant_alternative_t<KODO_SEGMENT, kodo::Shape>, kodo::Segment>);
static_assert(std::is_same_v<std::variant_alternative_t<KODO_PLANE, kodo::Shape>, kodo::Plane>);
static_assert(
    std::is_same_v<std::variant_alternative_t<KODO_HEIGHTMAP, kodo::Shape>, kodo::Heightmap>);
static_assert(std::is_same_v<std::variant_alternative_t<KODO_CHAIN, kodo::Shape>, kodo::Chain>);
static_assert(std::is_same_v<std::variant_alternative_t<KODO_CAPSULE, kodo::Shape>, kodo::Capsule>);
static_assert(kShapeKinds == KODO_CAPSULE + 1);

kodo::Compound compoundFromC(const kodo_Compound& compound) {
    kodo::Compound made;
    for (const kodo_Shape& part :
         itemsOf(compound.parts, compound.partCount, "shape.compound.parts")) {
        made.parts.push_back(primitiveFromC(part, "shape.compound.parts"));
    }
    return made;
}

kodo::Heightmap heightmapFromC(const kodo_Heightmap& map) {
    const auto heights = itemsOf(map.heights, map.heightCount, "shape.heightmap.heights");
    return {fromC(map.origin), map.spacing, {heights.begin(), heights.end()}};
}

kodo::Chain chainFromC(const kodo_Chain& chain) {
    return {listFromC(itemsOf(chain.points, chain.pointCount, "shape.chain.points")), chain.closed,
            chain.oneSided,
            listFromC(itemsOf(chain.materials, chain.materialCount, "shape.chain.materials"))};
}

struct ToC {
    kodo_Shape operator()(const kodo::Circle& circle) const {
        const auto& [radius, center] = circle;
        kodo_Shape shape = kodo_circle(radius);
        shape.circle.center = toC(center);
        return shape;
    }
    kodo_Shape operator()(const kodo::Box& box) const {
        const auto& [width, height, center, rotation, radius] = box;
        kodo_Shape shape = kodo_shapeOfKind(KODO_BOX);
        shape.box = {width, height, toC(center), toC(rotation), radius};
        return shape;
    }
    kodo_Shape operator()(const kodo::Polygon& polygon) const {
        const auto& [corners, radius] = polygon;
        kodo_Shape shape = kodo_polygon(nullptr, corners.size());
        shape.polygon.radius = radius;
        return shape;
    }
    kodo_Shape operator()(const kodo::Point& point) const {
        const auto& [position] = point;
        return kodo_point(toC(position));
    }
    kodo_Shape operator()(const kodo::Segment& segment) const {
        const auto& [from, to, oneSided, radius] = segment;
        kodo_Shape shape = kodo_shapeOfKind(KODO_SEGMENT);
        shape.segment = {toC(from), toC(to), oneSided, radius};
        return shape;
    }
    kodo_Shape operator()(const kodo::Plane& plane) const {
        const auto& [normal, offset] = plane;
        return kodo_plane(toC(normal), offset);
    }
    kodo_Shape operator()(const kodo::Capsule& capsule) const {
        const auto& [from, to, radius] = capsule;
        return kodo_capsule(toC(from), toC(to), radius);
    }
};

} // namespace

kodo::Primitive primitiveFromC(const kodo_Shape& shape, const char* field) {
    switch (shape.kind) {
    case KODO_CIRCLE:
        return kodo::Circle{shape.circle.radius, fromC(shape.circle.center)};
    case KODO_BOX:
        return kodo::Box{shape.box.width, shape.box.height, fromC(shape.box.center),
                         fromC(shape.box.rotation), shape.box.radius};
    case KODO_POLYGON:
        return kodo::Polygon{listFromC(itemsOf(shape.polygon.corners, shape.polygon.cornerCount,
                                               "shape.polygon.corners")),
                             shape.polygon.radius};
    case KODO_POINT:
        return kodo::Point{fromC(shape.point.position)};
    case KODO_SEGMENT:
        return kodo::Segment{fromC(shape.segment.from), fromC(shape.segment.to),
                             shape.segment.oneSided, shape.segment.radius};
    case KODO_PLANE:
        return kodo::Plane{fromC(shape.plane.normal), shape.plane.offset};
    case KODO_CAPSULE:
        return kodo::Capsule{fromC(shape.capsule.from), fromC(shape.capsule.to),
                             shape.capsule.radius};
    default:
        requireKind(shape.kind, kShapeKinds, "shape.kind");
        refuse(field, "must be convex, not a compound, heightmap or chain");
    }
}

kodo::Shape fromC(const kodo_Shape& shape) {
    switch (shape.kind) {
    case KODO_COMPOUND:
        return compoundFromC(shape.compound);
    case KODO_HEIGHTMAP:
        return heightmapFromC(shape.heightmap);
    case KODO_CHAIN:
        return chainFromC(shape.chain);
    default:
        return kodo::shapeOf(primitiveFromC(shape, "shape"));
    }
}

kodo_Shape toC(const kodo::Primitive& primitive) {
    return std::visit(ToC{}, primitive);
}

} // namespace kodo_c
