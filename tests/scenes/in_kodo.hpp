// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>
#include <scenes/scene_def.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// In the engine's inline namespace, so that one program can build scenes in both precisions.
namespace scenes {
inline namespace KODO_PRECISION {

inline kodo::Vec2 toKodo(Vec2 v) {
    return {static_cast<kodo::Real>(v.x), static_cast<kodo::Real>(v.y)};
}
inline kodo::Rot toKodo(Rot q) {
    return {static_cast<kodo::Real>(q.c), static_cast<kodo::Real>(q.s)};
}

inline kodo::Primitive toKodo(const Part& part) {
    if (const auto* circle = std::get_if<Circle>(&part)) {
        return kodo::Circle{static_cast<kodo::Real>(circle->radius), toKodo(circle->center)};
    }
    if (const auto* rectangle = std::get_if<Box>(&part)) {
        kodo::Box result;
        result.width = static_cast<kodo::Real>(rectangle->width);
        result.height = static_cast<kodo::Real>(rectangle->height);
        result.center = toKodo(rectangle->center);
        return result;
    }
    if (const auto* capsule = std::get_if<Capsule>(&part)) {
        return kodo::Capsule{toKodo(capsule->from), toKodo(capsule->to),
                             static_cast<kodo::Real>(capsule->radius)};
    }
    kodo::Polygon polygon;
    for (const Vec2 corner : std::get<Polygon>(part).corners) {
        polygon.corners.push_back(toKodo(corner));
    }
    return polygon;
}

inline kodo::Shape toKodo(const std::vector<Part>& parts) {
    if (parts.size() == 1) {
        return std::visit([](const auto& only) { return kodo::Shape(only); }, toKodo(parts[0]));
    }
    kodo::Compound compound;
    for (const Part& part : parts) {
        compound.parts.push_back(toKodo(part));
    }
    return compound;
}

inline kodo::BodyDef toKodo(const BodyDef& body) {
    kodo::BodyDef def;
    def.shape = toKodo(body.parts);
    def.position = toKodo(body.position);
    def.rotation = toKodo(body.rotation);
    def.velocity = toKodo(body.velocity);
    def.angularVelocity = static_cast<kodo::Real>(body.spin);
    def.material = kodo::withFriction(static_cast<kodo::Real>(body.material.friction),
                                      static_cast<kodo::Real>(body.material.restitution));
    def.material.surfaceSpeed = static_cast<kodo::Real>(body.material.surfaceSpeed);
    def.density = static_cast<kodo::Real>(body.density);
    const bool moves = def.velocity != kodo::Vec2{} || def.angularVelocity != 0;
    def.type = !body.locked ? kodo::BodyType::Dynamic
               : moves      ? kodo::BodyType::Kinematic
                            : kodo::BodyType::Static;
    def.flags = body.category;
    def.flags |= body.upright ? kodo::kLockRotate : 0;
    def.flags |= body.sensor ? kodo::kSensor : 0;
    if (body.mask != 0) {
        def.flags |= kodo::kMatchAny;
        def.required = body.mask;
    }
    return def;
}

/// User flag of bodies under gravity, for scenes with weightless bodies.
inline constexpr kodo::Flags kHeavy = 0x8000;

inline kodo::RevoluteJoint toKodo(const RevoluteJointDef& joint, const SceneDef& scene,
                                  const std::vector<kodo::BodyId>& ids) {
    const auto anchor = [&](const BodyDef& body) {
        const Rot back{body.rotation.c, -body.rotation.s};
        return toKodo(back * (joint.point - body.position));
    };
    kodo::RevoluteJoint def;
    def.ends.a = ids[joint.a];
    def.ends.b = ids[joint.b];
    def.ends.anchorA = anchor(scene.bodies[joint.a]);
    def.ends.anchorB = anchor(scene.bodies[joint.b]);
    def.motorSpeed = static_cast<kodo::Real>(joint.motorSpeed);
    def.motorTorque = static_cast<kodo::Real>(joint.motorTorque);
    if (joint.limits) {
        const auto angle = [](Rot q) { return std::atan2(q.s, q.c); };
        def.reference = static_cast<kodo::Real>(angle(scene.bodies[joint.b].rotation) -
                                                angle(scene.bodies[joint.a].rotation));
        def.limits = kodo::Range{static_cast<kodo::Real>(joint.limits->lower),
                                 static_cast<kodo::Real>(joint.limits->upper)};
    }
    return def;
}

/// A scene in its own World; ids[i] is body i of the scene.
struct KodoScene {
    kodo::World world;
    std::vector<kodo::BodyId> ids;
};

inline KodoScene inKodo(const SceneDef& scene, const kodo::StepSettings& settings = {}) {
    const bool allHeavy = std::none_of(scene.bodies.begin(), scene.bodies.end(),
                                       [](const BodyDef& body) { return body.weightless; });
    kodo::WorldDef def;
    def.gravity = allHeavy ? toKodo(scene.gravity) : kodo::Vec2{};
    def.settings = settings;
    KodoScene result{kodo::World(def), {}};
    if (!allHeavy) {
        result.world.addField({std::make_shared<kodo::Gravity>(toKodo(scene.gravity)),
                               {kodo::kMatchAny, std::uint16_t{kHeavy}}});
    }
    for (const BodyDef& body : scene.bodies) {
        kodo::BodyDef one = toKodo(body);
        one.flags |= allHeavy || body.weightless ? 0 : kHeavy;
        result.ids.push_back(result.world.add(one));
    }
    for (const ChainDef& chain : scene.chains) {
        kodo::Chain shape;
        for (const Vec2 point : chain.points) {
            shape.points.push_back(toKodo(point));
        }
        const kodo::Material material =
            kodo::withFriction(static_cast<kodo::Real>(chain.material.friction),
                               static_cast<kodo::Real>(chain.material.restitution));
        result.world.add({.shape = shape, .material = material, .type = kodo::BodyType::Static});
    }
    for (const RevoluteJointDef& joint : scene.joints) {
        result.world.add(kodo::JointDef(toKodo(joint, scene, result.ids)));
    }
    return result;
}

} // namespace KODO_PRECISION
} // namespace scenes
