// SPDX-License-Identifier: MIT
#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine.hpp"

namespace crosscheck {
namespace {

b2Vec2 toBox2d(scenes::Vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

/// The outline whose skin of b2_polygonRadius reaches as far as `corners` do: each corner moves
/// inwards to where the two edges beside it meet after theirs.
b2PolygonShape inset(const std::vector<scenes::Vec2>& corners) {
    const double skin = static_cast<double>(b2_polygonRadius);
    const auto outward = [&](std::size_t i) {
        const scenes::Vec2 edge = corners[(i + 1) % corners.size()] - corners[i];
        const double size = std::sqrt(dot(edge, edge));
        return scenes::Vec2{edge.y / size, -edge.x / size};
    };
    std::vector<b2Vec2> moved;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const scenes::Vec2 n = outward((i + corners.size() - 1) % corners.size());
        const scenes::Vec2 m = outward(i);
        moved.push_back(toBox2d(corners[i] - (skin / (1 + dot(n, m))) * (n + m)));
    }
    b2PolygonShape shape;
    shape.Set(moved.data(), static_cast<int32>(moved.size()));
    return shape;
}

b2PolygonShape shapeOf(const scenes::Polygon& polygon) {
    return inset(polygon.corners);
}

b2PolygonShape shapeOf(const scenes::Box& box) {
    const scenes::Vec2 x{box.width / 2, 0};
    const scenes::Vec2 y{0, box.height / 2};
    return inset({box.center - x - y, box.center + x - y, box.center + x + y, box.center - x + y});
}

b2CircleShape shapeOf(const scenes::Circle& circle) {
    b2CircleShape shape;
    shape.m_radius = static_cast<float>(circle.radius);
    shape.m_p = toBox2d(circle.center);
    return shape;
}

/// Kodo's rule for restitution, and what was pushed in the last step.
class Listener final : public b2ContactListener {
public:
    struct Push {
        const b2Body* a;
        const b2Body* b;
        double impulse;
    };
    std::vector<Push> pushes;

    void PreSolve(b2Contact* contact, const b2Manifold*) override {
        contact->SetRestitution(std::min(contact->GetFixtureA()->GetRestitution(),
                                         contact->GetFixtureB()->GetRestitution()));
    }
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
        double sum = 0;
        for (int32 i = 0; i < impulse->count; ++i) {
            sum += static_cast<double>(impulse->normalImpulses[i]);
        }
        pushes.push_back(
            {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody(), sum});
    }
};

class Box2dEngine final : public Engine {
public:
    Box2dEngine(const scenes::SceneDef& scene, double bounceThreshold)
        : world_(toBox2d(scene.gravity)), bounceThreshold_(static_cast<float>(bounceThreshold)) {
        world_.SetAllowSleeping(false);
        world_.SetContactListener(&listener_);
        for (const scenes::BodyDef& body : scene.bodies) {
            add(body);
        }
    }

    void step(double dt) override {
        listener_.pushes.clear();
        world_.Step(static_cast<float>(dt), 8, 3);
    }

    void join(const Link& link) override {
        b2Body* a = bodies_[link.a];
        b2Body* b = bodies_[link.b];
        const b2Vec2 point(static_cast<float>(link.point.x), static_cast<float>(link.point.y));
        if (link.kind == Link::Kind::Weld) {
            b2WeldJointDef def;
            def.Initialize(a, b, point);
            world_.CreateJoint(&def);
        } else if (link.kind == Link::Kind::Pin) {
            b2RevoluteJointDef def;
            def.Initialize(a, b, point);
            def.enableMotor = link.motorTorque > 0;
            def.motorSpeed = static_cast<float>(link.motorSpeed);
            def.maxMotorTorque = static_cast<float>(link.motorTorque);
            world_.CreateJoint(&def);
        } else {
            b2DistanceJointDef def;
            def.Initialize(a, b, point,
                           {static_cast<float>(link.pointB.x), static_cast<float>(link.pointB.y)});
            def.minLength = 0;
            def.maxLength = std::numeric_limits<float>::max();
            b2LinearStiffness(def.stiffness, def.damping, static_cast<float>(link.hertz),
                              static_cast<float>(link.damping), a, b);
            world_.CreateJoint(&def);
        }
    }

    State state(std::size_t index) const override {
        const b2Body& body = *bodies_[index];
        const b2Vec2 center = body.GetWorldCenter();
        const b2Vec2 velocity = body.GetLinearVelocity();
        return {{static_cast<double>(center.x), static_cast<double>(center.y)},
                std::remainder(static_cast<double>(body.GetAngle()), 2 * std::numbers::pi),
                {static_cast<double>(velocity.x), static_cast<double>(velocity.y)},
                static_cast<double>(body.GetAngularVelocity())};
    }

    double impulse(std::size_t a, std::size_t b) const override {
        double sum = 0;
        for (const Listener::Push& push : listener_.pushes) {
            if ((push.a == bodies_[a] && push.b == bodies_[b]) ||
                (push.a == bodies_[b] && push.b == bodies_[a])) {
                sum += push.impulse;
            }
        }
        return sum;
    }

private:
    void add(const scenes::BodyDef& source) {
        b2BodyDef def;
        def.type = source.locked ? b2_staticBody : b2_dynamicBody;
        def.position = toBox2d(source.position);
        def.angle = static_cast<float>(std::atan2(source.rotation.s, source.rotation.c));
        b2Body* body = world_.CreateBody(&def);
        bodies_.push_back(body);
        for (const scenes::Part& part : source.parts) {
            std::visit([&](const auto& shape) { addFixture(*body, source, shapeOf(shape)); }, part);
        }
        if (source.locked) {
            return;
        }
        const Mass mass = massOf(source);
        b2MassData data;
        data.mass = static_cast<float>(mass.mass);
        data.center = toBox2d(mass.center);
        data.I = static_cast<float>(mass.inertia + mass.mass * dot(mass.center, mass.center));
        body->SetMassData(&data);
        body->SetLinearVelocity(toBox2d(source.velocity));
        body->SetAngularVelocity(static_cast<float>(source.spin));
    }

    void addFixture(b2Body& body, const scenes::BodyDef& source, const b2Shape& shape) const {
        b2FixtureDef def;
        def.shape = &shape;
        def.density = static_cast<float>(source.density);
        def.friction = static_cast<float>(source.material.friction);
        def.restitution = static_cast<float>(source.material.restitution);
        def.restitutionThreshold = bounceThreshold_;
        body.CreateFixture(&def);
    }

    Listener listener_;
    b2World world_;
    float bounceThreshold_;
    std::vector<b2Body*> bodies_;
};

} // namespace

std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, double bounceThreshold) {
    return std::make_unique<Box2dEngine>(scene, bounceThreshold);
}

} // namespace crosscheck
