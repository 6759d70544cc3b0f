// SPDX-License-Identifier: MIT
#include <apart/core/building.hpp>

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace apart {

using kodo::Box;
using kodo::Polygon;
using kodo::Real;
using kodo::Rot;
using kodo::Vec2;

namespace {

constexpr int kRoundCorners = 16; // of the polygon that stands for a circle

constexpr Real metres(std::int32_t thousandths) {
    return static_cast<Real>(thousandths) / 1000;
}

constexpr Real radians(std::int32_t thousandths) {
    return static_cast<Real>(thousandths) / 180000 * std::numbers::pi_v<Real>;
}

Polygon mirrored(const Polygon& polygon) {
    Polygon result;
    for (std::size_t i = polygon.corners.size(); i-- > 0;) { // in reverse, to stay ccw
        result.corners.push_back({-polygon.corners[i].x, polygon.corners[i].y});
    }
    return result;
}

/// Sector of a ring about the origin, in the middle of the upper half.
Polygon voussoir(const FreeBlock& block) {
    const Vec2 right = Rot::fromAngle(radians(-block.extra) / 2).yAxis();
    const Vec2 left{-right.x, right.y};
    const Real inner = metres(block.width);
    const Real outer = inner + metres(block.height);
    return {{inner * left, inner * right, outer * right, outer * left}};
}

kodo::Compound angled(const FreeBlock& block, Real width, Real height) {
    const Real thick = metres(block.extra);
    const Real side = block.mirrored ? -1 : 1;
    const Real rest = height - thick;
    if (block.form == Form::L) {
        return {{Box{width, thick, {0, -rest / 2}},
                 Box{thick, rest, {side * (thick - width) / 2, thick / 2}}}};
    }
    return {{Box{width, thick, {0, rest / 2}}, Box{thick, rest, {0, -thick / 2}}}};
}

kodo::Shape flatShape(const FreeBlock& block) {
    const Real x = metres(block.width) / 2;
    const Real y = metres(block.height) / 2;
    switch (block.form) {
    case Form::Wedge: {
        const Polygon wedge{{{-x, -y}, {x, -y}, {x, y}}};
        return block.mirrored ? mirrored(wedge) : wedge;
    }
    case Form::Gable:
        return Polygon{{{-x, -y}, {x, -y}, {0, y}}};
    case Form::Round:
    case Form::Wheel:
        return kodo::Circle{x};
    case Form::L:
    case Form::T:
        return angled(block, 2 * x, 2 * y);
    default:
        break;
    }
    return Box{2 * x, 2 * y};
}

Polygon roundPolygon(const kodo::Circle& circle) {
    constexpr Real kStep = 2 * std::numbers::pi_v<Real> / kRoundCorners;
    // n/2 r^2 sin(step) is the area of the polygon
    const Real radius = circle.radius * std::sqrt(kStep / Rot::fromAngle(kStep).s);
    Polygon polygon;
    for (int i = 0; i < kRoundCorners; ++i) {
        const Vec2 way = Rot::fromAngle(kStep * static_cast<Real>(i)).xAxis();
        polygon.corners.push_back(circle.center + radius * way);
    }
    return polygon;
}

Polygon boxPolygon(const Box& box) {
    const Real x = box.width / 2;
    const Real y = box.height / 2;
    Polygon polygon{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
    for (Vec2& corner : polygon.corners) {
        corner = box.center + box.rotation * corner;
    }
    return polygon;
}

kodo::JointEnds endsOf(const LinkDef& link, kodo::BodyView a, kodo::BodyView b) {
    const Vec2 from{metres(link.fromX), metres(link.fromY)};
    const Vec2 to{metres(link.toX), metres(link.toY)};
    const bool line = link.kind == LinkKind::Rope || link.kind == LinkKind::Spring;
    kodo::JointEnds ends{.a = a.id(),
                         .b = b.id(),
                         .anchorA = toLocal(a.transform(), from),
                         .anchorB = toLocal(b.transform(), line ? to : from),
                         .collide = line};
    if (link.strength > 0) {
        ends.breakForce = metres(link.strength);
    }
    return ends;
}

} // namespace

FreeBlock usualBlock(Form form) {
    constexpr std::array<std::array<std::int32_t, 3>, kFormNames.size()> kSizes = {
        {{1600, 800, 0},
         {3200, 400, 0},
         {2400, 200, 0},
         {800, 800, 0},
         {1600, 800, 0},
         {1600, 800, 0},
         {800, 800, 0},
         {1200, 1200, 0},
         {2000, 800, 30000}, // a voussoir of an arch of 2 m
         {1600, 1600, 400},
         {1600, 1600, 400}}};
    const auto& [width, height, extra] = kSizes[static_cast<std::size_t>(form)];
    return {.form = form, .width = width, .height = height, .extra = extra};
}

PlacedShape placedShapeOf(const FreeBlock& block) {
    const Vec2 place{metres(block.x), metres(block.y)};
    const Rot rotation = block.turn == 0 ? Rot{} : Rot::fromAngle(radians(block.turn));
    if (block.form != Form::Voussoir) {
        return {flatShape(block), {place, rotation}};
    }
    Polygon polygon = voussoir(block);
    const Vec2 middle = massOf(polygon, Real(1)).center;
    for (Vec2& corner : polygon.corners) {
        corner -= middle;
    }
    return {std::move(polygon), {place + rotation * middle, rotation}};
}

kodo::JointDef jointOf(const LinkDef& link, kodo::BodyView a, kodo::BodyView b) {
    const kodo::JointEnds ends = endsOf(link, a, b);
    // The angle that counts as 0 is the one at the start.
    const Real reference = (a.rotation().inverse() * b.rotation()).angle();
    const Vec2 way{metres(link.toX - link.fromX), metres(link.toY - link.fromY)};
    switch (link.kind) {
    case LinkKind::Rope:
        return kodo::DistanceJoint{.ends = ends,
                                   .limits = kodo::Range{0, length(way) + metres(link.slack)}};
    case LinkKind::Spring:
        return kodo::DistanceJoint{.ends = ends,
                                   .length = length(way) + metres(link.slack),
                                   .hertz = metres(link.hertz),
                                   .damping = Real(0.3)};
    case LinkKind::Slider: {
        kodo::PrismaticJoint slider{.ends = ends, .reference = reference};
        slider.axis = unrotate(a.rotation(), Rot::fromAngle(radians(link.axis)).xAxis());
        if (link.limited) {
            slider.limits = kodo::Range{metres(link.low), metres(link.high)};
        }
        return slider;
    }
    default:
        break;
    }
    kodo::RevoluteJoint pin{.ends = ends,
                            .reference = reference,
                            .motorSpeed = metres(link.speed),
                            .motorTorque = metres(link.torque)};
    if (link.limited) {
        pin.limits = kodo::Range{radians(link.low), radians(link.high)};
    }
    return pin;
}

std::vector<Polygon> polygonsOf(const kodo::Shape& shape) {
    std::vector<Polygon> polygons;
    for (const kodo::Primitive& primitive : primitivesOf(shape)) {
        if (const auto* polygon = std::get_if<Polygon>(&primitive)) {
            polygons.push_back(*polygon);
        } else if (const auto* box = std::get_if<Box>(&primitive)) {
            polygons.push_back(boxPolygon(*box));
        } else if (const auto* circle = std::get_if<kodo::Circle>(&primitive)) {
            polygons.push_back(roundPolygon(*circle));
        }
    }
    return polygons;
}

kodo::Aabb extentOf(const kodo::Shape& shape) {
    std::vector<Vec2> corners;
    for (const Polygon& polygon : polygonsOf(shape)) {
        corners.insert(corners.end(), polygon.corners.begin(), polygon.corners.end());
    }
    return kodo::aabbOf(std::span<const Vec2>(corners));
}

kodo::Aabb boundsOf(const PlacedShape& placed) {
    std::optional<kodo::Aabb> bounds;
    for (const kodo::Primitive& primitive : primitivesOf(placed.shape)) {
        kodo::Aabb own;
        if (const auto* circle = std::get_if<kodo::Circle>(&primitive)) {
            const Vec2 center = placed.frame * circle->center;
            own = kodo::Aabb{center, center}.grown(circle->radius);
        } else {
            std::vector<Vec2> corners;
            for (const kodo::Polygon& polygon : polygonsOf(shapeOf(primitive))) {
                for (const Vec2 corner : polygon.corners) {
                    corners.push_back(placed.frame * corner);
                }
            }
            own = kodo::aabbOf(std::span<const Vec2>(corners));
        }
        bounds = bounds ? unite(*bounds, own) : own;
    }
    return bounds.value_or(kodo::Aabb{});
}

kodo::Shape shapeOfBlock(kodo::BodyView body, std::size_t part, bool ownsBody) {
    if (!ownsBody || body.partCount() == 1) {
        const kodo::Primitive& primitive = body.part(part).primitive;
        const auto* box = std::get_if<Box>(&primitive);
        return box != nullptr ? Box{box->width, box->height} : shapeOf(primitive);
    }
    kodo::Compound compound;
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        compound.parts.push_back(body.part(i).primitive);
    }
    return compound;
}

} // namespace apart
