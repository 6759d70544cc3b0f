// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>
#include <scenes/scene_mass.hpp>

#include <algorithm>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

// Box2D 3 is a C library whose types have the names of those of Box2D 2.4.1. In a namespace they
// are different types, so one program can use both: C functions keep their names for the linker.
// The standard headers that box2d.h includes are above.
namespace box2d3 {
#include <box2d/box2d.h>
} // namespace box2d3

namespace scenes::v3 {

inline box2d3::b2Vec2 toBox2d(Vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}
inline box2d3::b2Rot toBox2d(Rot q) {
    return {static_cast<float>(q.c), static_cast<float>(q.s)};
}

/// Without a radius: the surface is that of the nominal shape. Throws std::invalid_argument if
/// Box2D finds no hull, as for corners within 20 mm of each other.
inline box2d3::b2Polygon shapeOf(const std::vector<Vec2>& corners) {
    std::vector<box2d3::b2Vec2> points;
    for (const Vec2 corner : corners) {
        points.push_back(toBox2d(corner));
    }
    const box2d3::b2Hull hull =
        box2d3::b2ComputeHull(points.data(), static_cast<int>(points.size()));
    if (hull.count == 0) {
        throw std::invalid_argument("a polygon of the scene is too small for Box2D 3");
    }
    return box2d3::b2MakePolygon(&hull, 0);
}

/// Combines restitutions by Kodo's rule, the minimum; Box2D takes the maximum.
inline float smallerRestitution(float a, std::uint64_t, float b, std::uint64_t) {
    return std::min(a, b);
}

/// The defaults of Box2D, with Kodo's rule for restitutions.
inline box2d3::b2WorldDef worldOf(Vec2 gravity) {
    box2d3::b2WorldDef def = box2d3::b2DefaultWorldDef();
    def.gravity = toBox2d(gravity);
    def.restitutionCallback = &smallerRestitution;
    return def;
}

/// Bodies with infinite mass are kinematic if they move, else static.
inline box2d3::b2BodyType typeOf(const BodyDef& body) {
    const bool moves = body.spin != 0 || dot(body.velocity, body.velocity) > 0;
    return !body.locked ? box2d3::b2_dynamicBody
           : moves      ? box2d3::b2_kinematicBody
                        : box2d3::b2_staticBody;
}

inline box2d3::b2ShapeDef shapeDefOf(const BodyDef& source, bool events) {
    box2d3::b2ShapeDef def = box2d3::b2DefaultShapeDef();
    def.density = static_cast<float>(source.density);
    def.material.friction = static_cast<float>(source.material.friction);
    def.material.restitution = static_cast<float>(source.material.restitution);
    def.material.tangentSpeed = static_cast<float>(source.material.surfaceSpeed);
    def.isSensor = source.sensor;
    def.enableSensorEvents = events;
    if (source.category != 0) {
        def.filter.categoryBits = source.category;
    }
    if (source.mask != 0) {
        def.filter.maskBits = source.mask;
    }
    def.updateBodyMass = source.locked; // the others get their nominal mass
    def.enableContactEvents = events;
    def.enableHitEvents = events;
    return def;
}

inline void addShape(box2d3::b2BodyId body, const box2d3::b2ShapeDef& def, const Part& part) {
    if (const auto* circle = std::get_if<Circle>(&part)) {
        const box2d3::b2Circle shape{toBox2d(circle->center), static_cast<float>(circle->radius)};
        box2d3::b2CreateCircleShape(body, &def, &shape);
        return;
    }
    if (const auto* capsule = std::get_if<Capsule>(&part)) {
        const box2d3::b2Capsule shape{toBox2d(capsule->from), toBox2d(capsule->to),
                                      static_cast<float>(capsule->radius)};
        box2d3::b2CreateCapsuleShape(body, &def, &shape);
        return;
    }
    const auto* box = std::get_if<Box>(&part);
    const box2d3::b2Polygon shape =
        shapeOf(box != nullptr ? cornersOf(*box) : std::get<Polygon>(part).corners);
    box2d3::b2CreatePolygonShape(body, &def, &shape);
}

/// `events`: begins, ends and hits of the body are listed, and sensors see it. The user data of a
/// shape is the index of its part.
inline box2d3::b2BodyId addToBox2d(box2d3::b2WorldId world, const BodyDef& source, bool events) {
    box2d3::b2BodyDef def = box2d3::b2DefaultBodyDef();
    def.type = typeOf(source);
    def.position = toBox2d(source.position);
    def.rotation = toBox2d(source.rotation);
    def.gravityScale = source.weightless ? 0.0f : 1.0f;
    def.motionLocks.angularZ = source.upright;
    const box2d3::b2BodyId body = box2d3::b2CreateBody(world, &def);
    box2d3::b2ShapeDef shape = shapeDefOf(source, events);
    for (std::size_t i = 0; i < source.parts.size(); ++i) {
        shape.userData = reinterpret_cast<void*>(i);
        addShape(body, shape, source.parts[i]);
    }
    if (!source.locked) {
        const Mass mass = massOf(source);
        box2d3::b2Body_SetMassData(body, {static_cast<float>(mass.mass), toBox2d(mass.center),
                                          static_cast<float>(mass.inertia)});
    }
    if (def.type != box2d3::b2_staticBody) {
        box2d3::b2Body_SetLinearVelocity(body, toBox2d(source.velocity));
        box2d3::b2Body_SetAngularVelocity(body, static_cast<float>(source.spin));
    }
    return body;
}

/// The frames of both bodies are parallel to the axes of the world, so the angle is 0 at the start.
/// `hertz`: stiffness, 1/s; empty: that of Box2D.
inline void addToBox2d(box2d3::b2WorldId world, const RevoluteJointDef& joint,
                       const SceneDef& scene, const std::vector<box2d3::b2BodyId>& bodies,
                       std::optional<float> hertz) {
    const auto frame = [&](const BodyDef& body) {
        const Rot back{body.rotation.c, -body.rotation.s};
        return box2d3::b2Transform{toBox2d(back * (joint.point - body.position)), toBox2d(back)};
    };
    box2d3::b2RevoluteJointDef def = box2d3::b2DefaultRevoluteJointDef();
    def.base.constraintHertz = hertz.value_or(def.base.constraintHertz);
    def.base.bodyIdA = bodies[joint.a];
    def.base.bodyIdB = bodies[joint.b];
    def.base.localFrameA = frame(scene.bodies[joint.a]);
    def.base.localFrameB = frame(scene.bodies[joint.b]);
    def.enableMotor = joint.motorTorque > 0;
    def.motorSpeed = static_cast<float>(joint.motorSpeed);
    def.maxMotorTorque = static_cast<float>(joint.motorTorque);
    if (joint.limits) {
        def.enableLimit = true;
        def.lowerAngle = static_cast<float>(joint.limits->lower);
        def.upperAngle = static_cast<float>(joint.limits->upper);
    }
    box2d3::b2CreateRevoluteJoint(world, &def);
}

} // namespace scenes::v3
