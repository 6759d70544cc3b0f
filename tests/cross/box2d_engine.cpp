// SPDX-License-Identifier: MIT
#include <scenes/in_box2d.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine.hpp"

namespace crosscheck {
namespace {

/// Also keeps the impulses of the last step.
class Listener final : public scenes::SmallerRestitution {
public:
    struct Applied {
        b2Contact* contact;
        double impulse;
    };
    std::vector<Applied> applied;

    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
        double sum = 0;
        for (int32 i = 0; i < impulse->count; ++i) {
            sum += static_cast<double>(impulse->normalImpulses[i]);
        }
        applied.push_back({contact, sum});
    }
};

float small(double value) {
    return static_cast<float>(value);
}

class Box2dEngine final : public Engine {
public:
    Box2dEngine(const scenes::SceneDef& scene, double bounceThreshold)
        : defs_(scene.bodies),
          bounceThreshold_(small(bounceThreshold)),
          world_(std::make_unique<b2World>(scenes::toBox2d(scene.gravity))) {
        world_->SetAllowSleeping(false);
        world_->SetContactListener(&listener_);
        for (const scenes::BodyDef& body : scene.bodies) {
            bodies_.push_back(scenes::addToBox2d(*world_, body, bounceThreshold_));
        }
    }

    void step(double dt) override {
        listener_.applied.clear();
        world_->Step(small(dt), 8, 3);
        dt_ = small(dt);
    }

    void join(const Link& link) override {
        using Kind = Link::Kind;
        b2Joint* joint = link.kind == Kind::FixedJoint       ? fixed(link)
                         : link.kind == Kind::RevoluteJoint  ? revolute(link)
                         : link.kind == Kind::PrismaticJoint ? prismatic(link)
                                                             : distance(link);
        joints_.push_back(joint);
    }

    void split(std::size_t index, std::size_t part) override {
        listener_.applied.clear(); // contacts of the old fixtures go
        b2Body& old = *bodies_[index];
        scenes::BodyDef piece = defs_[index];
        piece.parts = {piece.parts[part]};
        piece.position = {static_cast<double>(old.GetPosition().x),
                          static_cast<double>(old.GetPosition().y)};
        const double angle = static_cast<double>(old.GetAngle());
        piece.rotation = {std::cos(angle), std::sin(angle)};
        b2Body* made = scenes::addToBox2d(*world_, piece, bounceThreshold_);
        made->SetLinearVelocity(old.GetLinearVelocityFromWorldPoint(made->GetWorldCenter()));
        made->SetAngularVelocity(old.GetAngularVelocity());
        for (b2Fixture* fixture = old.GetFixtureList(); fixture != nullptr;) {
            b2Fixture* next = fixture->GetNext();
            if (fixture->GetUserData().pointer == part) {
                old.DestroyFixture(fixture);
            }
            fixture = next;
        }
        defs_[index].parts.erase(defs_[index].parts.begin() + static_cast<std::ptrdiff_t>(part));
        scenes::giveNominalMass(old, defs_[index]); // moves the velocity to the new centre
        bodies_.push_back(made);
        defs_.push_back(piece);
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

    std::vector<Touch> touches() const override {
        std::vector<Touch> result;
        for (const Listener::Applied& one : listener_.applied) {
            result.push_back(touch(*one.contact, one.impulse));
        }
        for (b2Contact* c = world_->GetContactList(); c != nullptr; c = c->GetNext()) {
            if (c->IsTouching()) {
                result.push_back(touch(*c, 0));
            }
        }
        return result;
    }

    scenes::Vec2 jointForce(std::size_t joint) const override {
        const b2Vec2 force = joints_[joint]->GetReactionForce(1 / dt_);
        return {static_cast<double>(force.x), static_cast<double>(force.y)};
    }

private:
    b2Joint* fixed(const Link& link) {
        b2WeldJointDef def;
        def.Initialize(bodies_[link.a], bodies_[link.b], scenes::toBox2d(link.point));
        return world_->CreateJoint(&def);
    }

    b2Joint* revolute(const Link& link) {
        b2RevoluteJointDef def;
        def.Initialize(bodies_[link.a], bodies_[link.b], scenes::toBox2d(link.point));
        def.enableMotor = link.motorTorque > 0;
        def.motorSpeed = small(link.motorSpeed);
        def.maxMotorTorque = small(link.motorTorque);
        def.enableLimit = link.limit.has_value();
        def.lowerAngle = small(-link.limit.value_or(0));
        def.upperAngle = small(link.limit.value_or(0));
        return world_->CreateJoint(&def);
    }

    b2Joint* prismatic(const Link& link) {
        b2PrismaticJointDef def;
        def.Initialize(bodies_[link.a], bodies_[link.b], scenes::toBox2d(link.point),
                       scenes::toBox2d(link.axis));
        def.enableMotor = link.motorTorque > 0;
        def.motorSpeed = small(link.motorSpeed);
        def.maxMotorForce = small(link.motorTorque);
        def.enableLimit = link.limit.has_value();
        def.lowerTranslation = small(-link.limit.value_or(0));
        def.upperTranslation = small(link.limit.value_or(0));
        return world_->CreateJoint(&def);
    }

    b2Joint* distance(const Link& link) {
        b2Body* a = bodies_[link.a];
        b2Body* b = bodies_[link.b];
        b2DistanceJointDef def;
        def.Initialize(a, b, scenes::toBox2d(link.point), scenes::toBox2d(link.pointB));
        def.minLength = 0;
        if (link.kind == Link::Kind::DistanceJoint && link.hertz == 0) {
            def.minLength = def.length;
            def.maxLength = def.length;
        } else if (link.kind == Link::Kind::DistanceJoint) {
            def.maxLength = std::numeric_limits<float>::max();
            b2LinearStiffness(def.stiffness, def.damping, small(link.hertz), small(link.damping), a,
                              b);
        } else {
            def.maxLength = def.length;
        }
        return world_->CreateJoint(&def);
    }

    std::size_t indexOf(const b2Body* body) const {
        const auto at = std::find(bodies_.begin(), bodies_.end(), body);
        return static_cast<std::size_t>(at - bodies_.begin());
    }

    Touch touch(b2Contact& contact, double impulse) const {
        b2Fixture& a = *contact.GetFixtureA();
        b2Fixture& b = *contact.GetFixtureB();
        Touch one{indexOf(a.GetBody()), static_cast<std::size_t>(a.GetUserData().pointer),
                  indexOf(b.GetBody()), static_cast<std::size_t>(b.GetUserData().pointer), impulse};
        if (one.a > one.b) {
            std::swap(one.a, one.b);
            std::swap(one.partA, one.partB);
        }
        return one;
    }

    std::vector<scenes::BodyDef> defs_;
    float bounceThreshold_;
    float dt_ = 1;
    Listener listener_;
    std::unique_ptr<b2World> world_; // reading its contacts needs one that may change
    std::vector<b2Body*> bodies_;
    std::vector<b2Joint*> joints_;
};

} // namespace

std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, double bounceThreshold) {
    return std::make_unique<Box2dEngine>(scene, bounceThreshold);
}

} // namespace crosscheck
