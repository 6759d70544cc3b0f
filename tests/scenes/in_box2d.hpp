// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/scene_def.hpp>
#include <scenes/scene_mass.hpp>

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace scenes {

inline b2Vec2 toBox2d(Vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

/// Compensates the skin of Box2D, b2_polygonRadius: shape and skin together cover `corners`. Each
/// corner moves to the intersection of its two edges, both shifted inwards by the skin.
inline b2PolygonShape inset(const std::vector<Vec2>& corners) {
    const double skin = static_cast<double>(b2_polygonRadius);
    const auto outward = [&](std::size_t i) {
        const Vec2 edge = corners[(i + 1) % corners.size()] - corners[i];
        const double size = std::sqrt(dot(edge, edge));
        return Vec2{edge.y / size, -edge.x / size};
    };
    std::vector<b2Vec2> moved;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 n = outward((i + corners.size() - 1) % corners.size());
        const Vec2 m = outward(i);
        moved.push_back(toBox2d(corners[i] - (skin / (1 + dot(n, m))) * (n + m)));
    }
    b2PolygonShape shape;
    shape.Set(moved.data(), static_cast<int32>(moved.size()));
    return shape;
}

inline b2PolygonShape box2dShape(const Polygon& polygon) {
    return inset(polygon.corners);
}

inline b2PolygonShape box2dShape(const Box& box) {
    return inset(cornersOf(box));
}

inline b2CircleShape box2dShape(const Circle& circle) {
    b2CircleShape shape;
    shape.m_radius = static_cast<float>(circle.radius);
    shape.m_p = toBox2d(circle.center);
    return shape;
}

/// Combines restitutions by Kodo's rule, the minimum; Box2D takes the maximum.
class SmallerRestitution : public b2ContactListener {
public:
    void BeginContact(b2Contact* contact) override {
        contact->SetRestitution(std::min(contact->GetFixtureA()->GetRestitution(),
                                         contact->GetFixtureB()->GetRestitution()));
    }
};

/// Bodies with infinite mass are kinematic if they move, else static.
inline b2BodyType box2dType(const BodyDef& body) {
    const bool moves = body.spin != 0 || dot(body.velocity, body.velocity) > 0;
    return !body.locked ? b2_dynamicBody : moves ? b2_kinematicBody : b2_staticBody;
}

inline void giveNominalMass(b2Body& body, const BodyDef& source) {
    const Mass mass = massOf(source);
    b2MassData data;
    data.mass = static_cast<float>(mass.mass);
    data.center = toBox2d(mass.center);
    data.I = static_cast<float>(mass.inertia + mass.mass * dot(mass.center, mass.center));
    body.SetMassData(&data);
}

/// A part as what Box2D has: a capsule is two discs and what lies between them.
inline std::vector<Part> piecesOf(const Part& part) {
    const auto* const capsule = std::get_if<Capsule>(&part);
    if (capsule == nullptr) {
        return {part};
    }
    const Vec2 way = capsule->to - capsule->from;
    const double length = std::sqrt(dot(way, way));
    std::vector<Part> pieces{Circle{capsule->radius, capsule->from}};
    if (length > 0) {
        const Vec2 side = capsule->radius / length * Vec2{-way.y, way.x};
        pieces.push_back(Circle{capsule->radius, capsule->to});
        pieces.push_back(Polygon{
            {capsule->from - side, capsule->to - side, capsule->to + side, capsule->from + side}});
    }
    return pieces;
}

/// `bounceThreshold`: the approach speed (m/s) below which restitution is 0. The user data of a
/// fixture is the index of its part.
inline b2Body* addToBox2d(b2World& world, const BodyDef& source, float bounceThreshold = 1) {
    b2BodyDef def;
    def.type = box2dType(source);
    def.position = toBox2d(source.position);
    def.angle = static_cast<float>(std::atan2(source.rotation.s, source.rotation.c));
    def.gravityScale = source.weightless ? 0.0f : 1.0f;
    def.fixedRotation = source.upright;
    b2Body* body = world.CreateBody(&def);
    for (const Part& part : source.parts) {
        b2FixtureDef fixture;
        fixture.density = static_cast<float>(source.density);
        fixture.friction = static_cast<float>(source.material.friction);
        fixture.restitution = static_cast<float>(source.material.restitution);
        fixture.restitutionThreshold = bounceThreshold;
        fixture.isSensor = source.sensor;
        fixture.userData.pointer = static_cast<std::uintptr_t>(&part - source.parts.data());
        if (source.category != 0) {
            fixture.filter.categoryBits = source.category;
        }
        if (source.mask != 0) {
            fixture.filter.maskBits = source.mask;
        }
        const auto add = [&](const auto& shape) {
            fixture.shape = &shape;
            body->CreateFixture(&fixture);
        };
        for (const Part& piece : piecesOf(part)) {
            if (const auto* circle = std::get_if<Circle>(&piece)) {
                add(box2dShape(*circle));
            } else if (const auto* box = std::get_if<Box>(&piece)) {
                add(box2dShape(*box));
            } else {
                add(box2dShape(std::get<Polygon>(piece)));
            }
        }
    }
    if (!source.locked) {
        giveNominalMass(*body, source);
    }
    if (def.type != b2_staticBody) {
        body->SetLinearVelocity(toBox2d(source.velocity));
        body->SetAngularVelocity(static_cast<float>(source.spin));
    }
    return body;
}

inline void addToBox2d(b2World& world, const RevoluteJointDef& joint,
                       const std::vector<b2Body*>& bodies) {
    b2RevoluteJointDef def;
    def.Initialize(bodies[joint.a], bodies[joint.b], toBox2d(joint.point));
    def.enableMotor = joint.motorTorque > 0;
    def.motorSpeed = static_cast<float>(joint.motorSpeed);
    def.maxMotorTorque = static_cast<float>(joint.motorTorque);
    if (joint.limits) { // angles are relative to those at the start: see Initialize()
        def.enableLimit = true;
        def.lowerAngle = static_cast<float>(joint.limits->lower);
        def.upperAngle = static_cast<float>(joint.limits->upper);
    }
    world.CreateJoint(&def);
}

} // namespace scenes
