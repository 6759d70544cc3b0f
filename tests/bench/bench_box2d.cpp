// SPDX-License-Identifier: MIT
#include <kodo/state_hash.hpp>
#include <scenes/in_box2d.hpp>

#include "bench_engine.hpp"

namespace bench {
namespace {

class Box2dEngine final : public Engine {
public:
    Box2dEngine(const scenes::SceneDef& scene, const StepOptions& options)
        : world_(scenes::toBox2d(scene.gravity)),
          passes_(options.passes.value_or(8)),
          positionPasses_(options.positionPasses.value_or(3)) {
        refuse(options);
        world_.SetAllowSleeping(options.rest);
        world_.SetContactListener(&mixing_);
        for (const scenes::BodyDef& body : scene.bodies) {
            bodies_.push_back(scenes::addToBox2d(world_, body));
        }
        for (const scenes::RevoluteJointDef& joint : scene.joints) {
            scenes::addToBox2d(world_, joint, bodies_);
        }
    }

    void step(double dt) override { world_.Step(static_cast<float>(dt), passes_, positionPasses_); }

    BodyState state(std::size_t body) const override {
        const b2Transform& frame = bodies_[body]->GetTransform();
        return {wide(frame.p),
                {static_cast<double>(frame.q.c), static_cast<double>(frame.q.s)},
                wide(bodies_[body]->GetLinearVelocity()),
                static_cast<double>(bodies_[body]->GetAngularVelocity())};
    }

    void add(const scenes::BodyDef& body) override {
        bodies_.push_back(scenes::addToBox2d(world_, body));
    }
    void remove(std::size_t body) override {
        world_.DestroyBody(bodies_[body]);
        bodies_[body] = nullptr;
    }

    void place(std::size_t body, scenes::Vec2 position) override {
        bodies_[body]->SetTransform(scenes::toBox2d(position), bodies_[body]->GetAngle());
        bodies_[body]->SetLinearVelocity({0, 0});
    }

    void push(std::size_t body, scenes::Vec2 velocity) override {
        bodies_[body]->SetLinearVelocity(scenes::toBox2d(velocity));
    }

    double readContacts() const override {
        double sum = 0;
        for (const b2Contact* contact = world_.GetContactList(); contact != nullptr;
             contact = contact->GetNext()) {
            sum += contact->IsTouching() ? impulseOf(*contact->GetManifold()) : 0;
        }
        return sum;
    }

    double impulse(std::size_t a, std::size_t b) const override {
        double sum = 0;
        for (const b2ContactEdge* edge = bodies_[a]->GetContactList(); edge != nullptr;
             edge = edge->next) {
            sum += edge->other == bodies_[b] ? impulseOf(*edge->contact->GetManifold()) : 0;
        }
        return sum;
    }

    double rayCast(scenes::Vec2 from, scenes::Vec2 to) const override {
        Closest closest;
        world_.RayCast(&closest, scenes::toBox2d(from), scenes::toBox2d(to));
        return static_cast<double>(closest.fraction);
    }

    std::size_t bodyCount() const override {
        return static_cast<std::size_t>(world_.GetBodyCount());
    }

    double mass() const override {
        double sum = 0;
        for (const b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext()) {
            sum += static_cast<double>(body->GetMass()); // 0 for static and kinematic bodies
        }
        return sum;
    }

    std::uint64_t stateHash() const override {
        kodo::StateHash hash;
        for (const b2Body* body : bodies_) {
            if (body == nullptr) {
                continue;
            }
            const b2Vec2 velocity = body->GetLinearVelocity();
            for (const float value :
                 {body->GetWorldCenter().x, body->GetWorldCenter().y, body->GetAngle(), velocity.x,
                  velocity.y, body->GetAngularVelocity()}) {
                hash.add(value);
            }
        }
        return hash.value();
    }

private:
    struct Closest final : b2RayCastCallback {
        float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float at) override {
            fraction = at;
            return at; // clips the ray
        }
        float fraction = 1;
    };

    static scenes::Vec2 wide(b2Vec2 v) {
        return {static_cast<double>(v.x), static_cast<double>(v.y)};
    }

    static double impulseOf(const b2Manifold& manifold) {
        double sum = 0;
        for (int i = 0; i < manifold.pointCount; ++i) {
            sum += static_cast<double>(manifold.points[i].normalImpulse);
        }
        return sum;
    }

    static void refuse(const StepOptions& options) {
        if (options.profile || options.substeps || !options.set.empty() ||
            !options.leaveOut.empty() || options.continuous != "all" || options.threads != 1) {
            throw WrongUse("Box2D 2.4.1 takes passes and position passes, and nothing else");
        }
    }

    scenes::SmallerRestitution mixing_;
    b2World world_;
    int passes_;
    int positionPasses_;
    std::vector<b2Body*> bodies_;
};

} // namespace

std::unique_ptr<Engine> makeBox2d(const scenes::SceneDef& scene, const StepOptions& options) {
    return std::make_unique<Box2dEngine>(scene, options);
}

} // namespace bench
