// SPDX-License-Identifier: MIT
#include <scenes/in_box2d.hpp>

#include <box2d/b2_distance.h>

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
    explicit Listener(const std::vector<scenes::BodyDef>& defs) : defs_(defs) {}

    struct Applied {
        b2Contact* contact;
        double impulse;
    };
    std::vector<Applied> applied;

    void PreSolve(b2Contact* contact, const b2Manifold*) override {
        contact->SetTangentSpeed(speedOf(*contact->GetFixtureA()) +
                                 speedOf(*contact->GetFixtureB()));
    }

    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
        double sum = 0;
        for (int32 i = 0; i < impulse->count; ++i) {
            sum += static_cast<double>(impulse->normalImpulses[i]);
        }
        applied.push_back({contact, sum});
    }

private:
    float speedOf(b2Fixture& fixture) const {
        const auto index = fixture.GetBody()->GetUserData().pointer;
        return index < defs_.size() ? static_cast<float>(defs_[index].material.surfaceSpeed) : 0;
    }

    const std::vector<scenes::BodyDef>& defs_;
};

float small(double value) {
    return static_cast<float>(value);
}

class Box2dEngine final : public Engine {
public:
    Box2dEngine(const scenes::SceneDef& scene, double bounceThreshold)
        : defs_(scene.bodies),
          bounceThreshold_(small(bounceThreshold)),
          listener_(defs_),
          world_(std::make_unique<b2World>(scenes::toBox2d(scene.gravity))) {
        world_->SetAllowSleeping(scene.sleep);
        world_->SetContactListener(&listener_);
        for (const scenes::BodyDef& body : scene.bodies) {
            bodies_.push_back(scenes::addToBox2d(*world_, body, bounceThreshold_));
            bodies_.back()->GetUserData().pointer = bodies_.size() - 1;
        }
        for (const scenes::ChainDef& chain : scene.chains) {
            addChain(chain);
        }
    }

    void step(double dt) override {
        listener_.applied.clear();
        world_->Step(small(dt), 8, 3);
        dt_ = small(dt);
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            if (breakForces_[i] > 0 && !isBroken(i) && length(jointForce(i)) > breakForces_[i]) {
                world_->DestroyJoint(joints_[i]);
                joints_[i] = nullptr;
            }
        }
    }

    void join(const Link& link) override {
        using Kind = Link::Kind;
        b2Joint* joint = link.kind == Kind::FixedJoint       ? fixed(link)
                         : link.kind == Kind::RevoluteJoint  ? revolute(link)
                         : link.kind == Kind::PrismaticJoint ? prismatic(link)
                         : link.kind == Kind::MouseJoint     ? mouse(link)
                                                             : distance(link);
        joints_.push_back(joint);
        breakForces_.push_back(link.breakForce);
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
        made->GetUserData().pointer = bodies_.size();
        bodies_.push_back(made);
        defs_.push_back(piece);
    }

    State state(std::size_t index) const override {
        const b2Body& body = *bodies_[index];
        // Without mass, Box2D takes the origin of the frame for the centre.
        const b2Vec2 center =
            body.GetType() == b2_dynamicBody
                ? body.GetWorldCenter()
                : body.GetWorldPoint(scenes::toBox2d(massOf(defs_[index]).center));
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

    bool isBroken(std::size_t joint) const override { return joints_[joint] == nullptr; }

    bool isAsleep(std::size_t body) const override { return !bodies_[body]->IsAwake(); }

    std::optional<RayFound> rayCast(scenes::Vec2 from, scenes::Vec2 to) const override {
        struct First final : b2RayCastCallback {
            float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&,
                                float fraction) override {
                found = RayFound{fixture->GetBody()->GetUserData().pointer,
                                 static_cast<double>(fraction)};
                return fraction;
            }
            std::optional<RayFound> found;
        } first;
        world_->RayCast(&first, scenes::toBox2d(from), scenes::toBox2d(to));
        return first.found;
    }

    /// Box2D casts a shape at one other: each fixture is asked.
    std::optional<RayFound> shapeCast(const scenes::Part& shape, scenes::Vec2 from,
                                      scenes::Vec2 to) const override {
        std::optional<RayFound> found;
        const auto ask = [&](const auto& moving) {
            for (b2Body* body = world_->GetBodyList(); body != nullptr; body = body->GetNext()) {
                for (b2Fixture* one = body->GetFixtureList(); one != nullptr;
                     one = one->GetNext()) {
                    b2ShapeCastInput input;
                    input.proxyA.Set(one->GetShape(), 0);
                    input.proxyB.Set(&moving, 0);
                    input.transformA = body->GetTransform();
                    input.transformB = b2Transform(scenes::toBox2d(from), b2Rot(0));
                    input.translationB = scenes::toBox2d(to - from);
                    b2ShapeCastOutput output{};
                    if (b2ShapeCast(&output, &input) &&
                        (!found || static_cast<double>(output.lambda) < found->fraction)) {
                        found = RayFound{indexOf(body), static_cast<double>(output.lambda)};
                    }
                }
            }
        };
        if (const auto* circle = std::get_if<scenes::Circle>(&shape)) {
            ask(scenes::box2dShape(*circle));
        } else {
            ask(scenes::box2dShape(std::get<scenes::Box>(shape)));
        }
        return found;
    }

    std::vector<std::size_t> overlap(scenes::Vec2 low, scenes::Vec2 high) const override {
        struct Near final : b2QueryCallback {
            bool ReportFixture(b2Fixture* fixture) override {
                if (b2TestOverlap(&box, 0, fixture->GetShape(), 0,
                                  b2Transform(b2Vec2_zero, b2Rot(0)),
                                  fixture->GetBody()->GetTransform())) {
                    found.push_back(fixture->GetBody()->GetUserData().pointer);
                }
                return true;
            }
            b2PolygonShape box;
            std::vector<std::size_t> found;
        } near;
        const scenes::Vec2 size = high - low;
        near.box = scenes::box2dShape(scenes::Box{size.x, size.y, 0.5 * (low + high)});
        world_->QueryAABB(&near, b2AABB{scenes::toBox2d(low), scenes::toBox2d(high)});
        std::sort(near.found.begin(), near.found.end());
        near.found.erase(std::unique(near.found.begin(), near.found.end()), near.found.end());
        return near.found;
    }

private:
    static double length(scenes::Vec2 force) { return std::sqrt(dot(force, force)); }

    void addChain(const scenes::ChainDef& chain) {
        std::vector<b2Vec2> points;
        for (auto point = chain.points.rbegin(); point != chain.points.rend(); ++point) {
            points.push_back(scenes::toBox2d(*point)); // its solid side is the other one
        }
        b2ChainShape shape;
        shape.CreateChain(points.data(), static_cast<int32>(points.size()),
                          points.front() + (points.front() - points[1]),
                          points.back() + (points.back() - points[points.size() - 2]));
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.friction = small(chain.material.friction);
        fixture.restitution = small(chain.material.restitution);
        b2BodyDef def;
        def.userData.pointer = defs_.size() + 1; // no body of the scene
        world_->CreateBody(&def)->CreateFixture(&fixture);
    }

    b2Joint* mouse(const Link& link) {
        b2MouseJointDef def;
        def.bodyA = bodies_[link.a];
        def.bodyB = bodies_[link.b];
        def.target = scenes::toBox2d(link.point);
        def.maxForce = small(link.motorTorque);
        def.collideConnected = true;
        b2LinearStiffness(def.stiffness, def.damping, small(link.hertz), small(link.damping),
                          def.bodyA, def.bodyB);
        auto* joint = static_cast<b2MouseJoint*>(world_->CreateJoint(&def));
        joint->SetTarget(scenes::toBox2d(link.pointB));
        return joint;
    }

    b2Joint* fixed(const Link& link) {
        b2WeldJointDef def;
        def.Initialize(bodies_[link.a], bodies_[link.b], scenes::toBox2d(link.point));
        def.referenceAngle =
            small(link.reference.value_or(static_cast<double>(def.referenceAngle)));
        return world_->CreateJoint(&def);
    }

    b2Joint* revolute(const Link& link) {
        b2RevoluteJointDef def;
        def.Initialize(bodies_[link.a], bodies_[link.b], scenes::toBox2d(link.point));
        def.enableMotor = link.motorTorque > 0;
        def.motorSpeed = small(link.motorSpeed);
        def.maxMotorTorque = small(link.motorTorque);
        def.enableLimit = link.limits.has_value();
        def.lowerAngle = small(link.limits.value_or(Limits{}).lower);
        def.upperAngle = small(link.limits.value_or(Limits{}).upper);
        def.referenceAngle =
            small(link.reference.value_or(static_cast<double>(def.referenceAngle)));
        return world_->CreateJoint(&def);
    }

    b2Joint* prismatic(const Link& link) {
        b2PrismaticJointDef def;
        def.Initialize(bodies_[link.a], bodies_[link.b], scenes::toBox2d(link.point),
                       scenes::toBox2d(link.axis));
        def.enableMotor = link.motorTorque > 0;
        def.motorSpeed = small(link.motorSpeed);
        def.maxMotorForce = small(link.motorTorque);
        def.enableLimit = link.limits.has_value();
        def.lowerTranslation = small(link.limits.value_or(Limits{}).lower);
        def.upperTranslation = small(link.limits.value_or(Limits{}).upper);
        def.referenceAngle =
            small(link.reference.value_or(static_cast<double>(def.referenceAngle)));
        return world_->CreateJoint(&def);
    }

    b2Joint* distance(const Link& link) {
        b2Body* a = bodies_[link.a];
        b2Body* b = bodies_[link.b];
        b2DistanceJointDef def;
        def.Initialize(a, b, scenes::toBox2d(link.point), scenes::toBox2d(link.pointB));
        def.length = small(link.length.value_or(static_cast<double>(def.length)));
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

    static std::size_t indexOf(b2Body* body) {
        return static_cast<std::size_t>(body->GetUserData().pointer);
    }

    static Touch touch(b2Contact& contact, double impulse) {
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
    std::vector<b2Joint*> joints_;    // nullptr: broken
    std::vector<double> breakForces_; // N; 0: none
};

} // namespace

std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, double bounceThreshold) {
    return std::make_unique<Box2dEngine>(scene, bounceThreshold);
}

} // namespace crosscheck
