// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <scenes/scene_def.hpp>

#include <vector>

// In the engine's inline namespace, so that one program may build scenes in both precisions.
namespace scenes::inline KODO_PRECISION {

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
    def.density = static_cast<kodo::Real>(body.density);
    def.flags = body.locked ? kodo::kLocked : 0;
    return def;
}

/// A scene in a World of its own; ids[i] is body i of the scene. A value, as a World is.
struct KodoScene {
    kodo::World world;
    std::vector<kodo::BodyId> ids;
};

inline KodoScene inKodo(const SceneDef& scene, const kodo::StepSettings& settings = {}) {
    kodo::WorldDef def;
    def.gravity = toKodo(scene.gravity);
    def.settings = settings;
    KodoScene result{kodo::World(def), {}};
    for (const BodyDef& body : scene.bodies) {
        result.ids.push_back(result.world.add(toKodo(body)));
    }
    return result;
}

} // namespace scenes::inline KODO_PRECISION
