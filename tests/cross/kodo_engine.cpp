// SPDX-License-Identifier: MIT
#include <scenes/in_kodo.hpp>

#include "engine.hpp"

namespace crosscheck {
namespace {

/// Without sleep, since sleeping bodies report no impulses.
kodo::StepSettings settings() {
    kodo::StepSettings result;
    result.leaveOut = kodo::Feature::Sleep;
    return result;
}

class KodoEngine final : public Engine {
public:
    explicit KodoEngine(const scenes::SceneDef& scene)
        : scene_(scenes::inKodo(scene, settings())) {}

    void step(double dt) override { scene_.world.step(static_cast<kodo::Real>(dt)); }

    void join(const Link& link) override {
        const kodo::JointEnds ends{scene_.ids[link.a], scene_.ids[link.b],
                                   anchor(link.a, link.point), anchor(link.b, link.point)};
        if (link.kind == Link::Kind::FixedJoint) {
            scene_.world.add(kodo::FixedJoint{.ends = ends});
        } else if (link.kind == Link::Kind::RevoluteJoint) {
            scene_.world.add(
                kodo::RevoluteJoint{.ends = ends,
                                    .motorSpeed = static_cast<kodo::Real>(link.motorSpeed),
                                    .motorTorque = static_cast<kodo::Real>(link.motorTorque)});
        } else {
            kodo::DistanceJoint spring{.ends = ends};
            spring.ends.anchorB = anchor(link.b, link.pointB);
            spring.length = length(scenes::toKodo(link.pointB - link.point));
            spring.hertz = static_cast<kodo::Real>(link.hertz);
            spring.damping = static_cast<kodo::Real>(link.damping);
            scene_.world.add(spring);
        }
    }

    State state(std::size_t body) const override {
        const kodo::BodyView view = scene_.world[scene_.ids[body]];
        const auto number = [](kodo::Real value) { return static_cast<double>(value); };
        return {{number(view.center().x), number(view.center().y)},
                number(view.rotation().angle()),
                {number(view.velocity().x), number(view.velocity().y)},
                number(view.angularVelocity())};
    }

    double impulse(std::size_t a, std::size_t b) const override {
        double sum = 0;
        for (const kodo::CollisionRecord& record : scene_.world.collisions()) {
            if (record.involves(scene_.ids[a]) && record.involves(scene_.ids[b])) {
                sum += static_cast<double>(record.totalImpulse);
            }
        }
        return sum;
    }

private:
    kodo::Vec2 anchor(std::size_t body, scenes::Vec2 point) const {
        const kodo::BodyView view = scene_.world[scene_.ids[body]];
        return unrotate(view.rotation(), scenes::toKodo(point) - view.position());
    }

    scenes::KodoScene scene_;
};

} // namespace

std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene) {
    return std::make_unique<KodoEngine>(scene);
}

} // namespace crosscheck
