// SPDX-License-Identifier: MIT
// Bodies of obstructions.
#include <apart/core/field.hpp>
#include <apart/core/tuning.hpp>
#include <kodo/geometry.hpp>

#include <numbers>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr Real metres(std::int32_t thousandths) {
    return static_cast<Real>(thousandths) / 1000;
}

/// Stops bodies from the left of the direction `from` -> `to`.
kodo::Segment gate(Real length, Facing facing) {
    const Real half = length / 2;
    kodo::Segment line{.oneSided = true};
    switch (facing) {
    case Facing::Up:
        line.from = {-half, 0};
        break;
    case Facing::Down:
        line.from = {half, 0};
        break;
    case Facing::Left:
        line.from = {0, -half};
        break;
    case Facing::Right:
        line.from = {0, half};
        break;
    }
    line.to = -line.from;
    return line;
}

kodo::Shape ground(const ObstructionDef& def) {
    if (!def.points.empty()) {
        return kodo::Chain{.points = outlineOf(def), .closed = true, .oneSided = true};
    }
    kodo::Heightmap hills{{}, metres(def.spacing), {}};
    for (const std::int32_t height : def.heights) {
        hills.heights.push_back(metres(height));
    }
    return hills;
}

} // namespace

std::vector<Vec2> outlineOf(const ObstructionDef& ground) {
    std::vector<Vec2> outline;
    for (const GroundPoint& point : ground.points) {
        outline.push_back({metres(point.x), metres(point.y)});
    }
    return outline;
}

kodo::Shape solidOf(const ObstructionDef& ground) {
    return std::get<kodo::Compound>(kodo::decompose(outlineOf(ground)));
}

kodo::BodyDef obstructionDef(const ObstructionDef& def) {
    kodo::BodyDef body{.position = {metres(def.x), metres(def.y)},
                       .material = kObstructionMaterial,
                       .type = kodo::BodyType::Kinematic,
                       .flags = flagsOf(Role::Obstruction)};
    switch (def.kind) {
    case ObstructionKind::Bumper:
    case ObstructionKind::Pin:
        body.shape = kodo::Circle{metres(def.size)};
        break;
    case ObstructionKind::Motor:
        // It passes through mounted blocks, which would jam it.
        body.shape = kodo::Box{metres(def.size), kBarThickness};
        body.density = kBarDensity;
        body.type = kodo::BodyType::Dynamic;
        body.flags = flagsOf(Role::Obstruction) | kodo::kNeverSleep | kodo::kMatchAny;
        body.required = static_cast<std::uint16_t>(flagsOf(Role::Ball) | kFalls | kStands);
        break;
    case ObstructionKind::Gate:
        body.shape = gate(metres(def.size), def.facing);
        break;
    case ObstructionKind::Ground:
        body.shape = ground(def);
        break;
    case ObstructionKind::Ledge:
        body.shape = kodo::Box{metres(def.size), metres(def.height)};
        body.rotation = kodo::Rot::fromAngle(metres(def.turn) / 180 * std::numbers::pi_v<Real>);
        break;
    }
    return body;
}

kodo::BodyDef pinDef(Vec2 place) {
    return {.shape = kodo::Circle{kPinRadius},
            .position = place,
            .material = kObstructionMaterial,
            .type = kodo::BodyType::Kinematic,
            .flags = flagsOf(Role::Obstruction)};
}

kodo::BodyDef pivotDef(Vec2 place) {
    kodo::BodyDef def = pinDef(place);
    def.flags |= kodo::kDisabled;
    return def;
}

} // namespace apart
