// SPDX-License-Identifier: MIT
#include <scenes/in_box2d.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine.hpp"

namespace crosscheck {
namespace {

/// Also keeps the impulses of the last step.
class Listener final : public scenes::SmallerRestitution {
public:
    struct FieldForce {
        const b2Body* a;
        const b2Body* b;
        double impulse;
    };
    std::vector<FieldForce> pushes;

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
        : world_(scenes::toBox2d(scene.gravity)) {
        world_.SetAllowSleeping(false);
        world_.SetContactListener(&listener_);
        for (const scenes::BodyDef& body : scene.bodies) {
            bodies_.push_back(
                scenes::addToBox2d(world_, body, static_cast<float>(bounceThreshold)));
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
        if (link.kind == Link::Kind::FixedJoint) {
            b2WeldJointDef def;
            def.Initialize(a, b, point);
            world_.CreateJoint(&def);
        } else if (link.kind == Link::Kind::RevoluteJoint) {
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
        for (const Listener::FieldForce& push : listener_.pushes) {
            if ((push.a == bodies_[a] && push.b == bodies_[b]) ||
                (push.a == bodies_[b] && push.b == bodies_[a])) {
                sum += push.impulse;
            }
        }
        return sum;
    }

private:
    Listener listener_;
    b2World world_;
    std::vector<b2Body*> bodies_;
};

} // namespace

std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, double bounceThreshold) {
    return std::make_unique<Box2dEngine>(scene, bounceThreshold);
}

} // namespace crosscheck
