// SPDX-License-Identifier: MIT
// Compiled twice, against both libraries.
#include <scenes/in_kodo.hpp>

#include <algorithm>
#include <utility>

#include "engine.hpp"

namespace crosscheck::KODO_PRECISION {
namespace {

kodo::StepSettings settingsOf(Profile profile) {
    switch (profile) {
    case Profile::Balanced:
        return kodo::balanced();
    case Profile::Accurate:
        return kodo::accurate();
    case Profile::Thesis:
    case Profile::ThesisWithoutShock:
        break;
    }
    kodo::StepSettings result = kodo::thesis2006();
    if (profile == Profile::ThesisWithoutShock) {
        result.propagation().shockPasses = 0;
    }
    return result;
}

kodo::StepSettings settingsOf(Profile profile, bool sleep) {
    kodo::StepSettings result = settingsOf(profile);
    if (!sleep) {
        result.leaveOut = kodo::Feature::Sleep;
    }
    return result;
}

double number(kodo::Real value) {
    return static_cast<double>(value);
}
kodo::Real real(double value) {
    return static_cast<kodo::Real>(value);
}

class KodoEngine final : public Engine {
public:
    KodoEngine(const scenes::SceneDef& scene, Profile profile)
        : scene_(scenes::inKodo(scene, settingsOf(profile, scene.sleep))) {}

    void step(double dt) override { scene_.world.step(real(dt)); }

    void join(const Link& link) override {
        const kodo::JointEnds ends{scene_.ids[link.a], scene_.ids[link.b],
                                   anchor(link.a, link.point), anchor(link.b, link.point)};
        joints_.push_back(add(link, ends));
        if (link.breakForce > 0) {
            kodo::JointDef def = scene_.world.joint(joints_.back());
            std::visit(
                [&](auto& joint) {
                    if constexpr (requires { joint.ends; }) {
                        joint.ends.breakForce = real(link.breakForce);
                    }
                },
                def);
            scene_.world.setJoint(joints_.back(), def);
        }
    }

    void split(std::size_t body, std::size_t part) override {
        const kodo::BodyId id = scene_.ids[body];
        scene_.ids.push_back(
            scene_.world.unweld(id, part, scene_.world[id].flags() & kodo::kUserFlags));
    }

    State state(std::size_t body) const override {
        const kodo::BodyView view = scene_.world[scene_.ids[body]];
        return {{number(view.center().x), number(view.center().y)},
                number(view.rotation().angle()),
                {number(view.velocity().x), number(view.velocity().y)},
                number(view.angularVelocity())};
    }

    std::vector<Touch> touches() const override {
        std::vector<Touch> result;
        for (const kodo::CollisionRecord& record : scene_.world.collisions()) {
            if (record.phase == kodo::TouchPhase::End) {
                continue;
            }
            Touch one{indexOf(record.a), record.partA, indexOf(record.b), record.partB,
                      number(record.totalImpulse)};
            if (one.a > one.b) {
                std::swap(one.a, one.b);
                std::swap(one.partA, one.partB);
            }
            result.push_back(one);
        }
        return result;
    }

    scenes::Vec2 jointForce(std::size_t joint) const override {
        const kodo::Vec2 force = scene_.world.jointForce(joints_[joint]);
        return {number(force.x), number(force.y)};
    }

    bool isBroken(std::size_t joint) const override {
        return !scene_.world.contains(joints_[joint]);
    }

    bool isAsleep(std::size_t body) const override {
        return scene_.world[scene_.ids[body]].isAsleep();
    }

    std::optional<RayFound> rayCast(scenes::Vec2 from, scenes::Vec2 to) const override {
        const auto hit = kodo::rayCast(scene_.world, scenes::toKodo(from), scenes::toKodo(to));
        return hit ? std::optional(RayFound{indexOf(hit->body), number(hit->fraction)})
                   : std::nullopt;
    }

    std::optional<RayFound> shapeCast(const scenes::Part& shape, scenes::Vec2 from,
                                      scenes::Vec2 to) const override {
        const auto hit =
            kodo::shapeCast(scene_.world, scenes::toKodo(std::vector<scenes::Part>{shape}),
                            {scenes::toKodo(from), {}}, scenes::toKodo(to - from));
        return hit ? std::optional(RayFound{indexOf(hit->body), number(hit->fraction)})
                   : std::nullopt;
    }

    std::vector<std::size_t> overlap(scenes::Vec2 low, scenes::Vec2 high) const override {
        std::vector<std::size_t> result;
        for (const kodo::BodyId id :
             kodo::overlap(scene_.world, kodo::Aabb{scenes::toKodo(low), scenes::toKodo(high)})) {
            result.push_back(indexOf(id));
        }
        std::sort(result.begin(), result.end());
        return result;
    }

private:
    kodo::JointId add(const Link& link, const kodo::JointEnds& ends) {
        using Kind = Link::Kind;
        const kodo::Real reference = real(link.reference.value_or(0));
        if (link.kind == Kind::FixedJoint) {
            return scene_.world.add(kodo::FixedJoint{.ends = ends, .reference = reference});
        }
        if (link.kind == Kind::RevoluteJoint) {
            return scene_.world.add(kodo::RevoluteJoint{.ends = ends,
                                                        .reference = reference,
                                                        .limits = range(link.limits),
                                                        .motorSpeed = real(link.motorSpeed),
                                                        .motorTorque = real(link.motorTorque)});
        }
        if (link.kind == Kind::PrismaticJoint) {
            return scene_.world.add(kodo::PrismaticJoint{.ends = ends,
                                                         .axis = axisOf(link),
                                                         .reference = reference,
                                                         .limits = range(link.limits),
                                                         .motorSpeed = real(link.motorSpeed),
                                                         .motorForce = real(link.motorTorque)});
        }
        if (link.kind == Kind::MouseJoint) {
            return scene_.world.add(kodo::MouseJoint{.body = ends.b,
                                                     .anchor = ends.anchorB,
                                                     .target = scenes::toKodo(link.pointB),
                                                     .force = real(link.motorTorque),
                                                     .hertz = real(link.hertz),
                                                     .damping = real(link.damping)});
        }
        kodo::DistanceJoint spring{.ends = ends};
        spring.ends.anchorB = anchor(link.b, link.pointB);
        spring.length =
            link.length ? real(*link.length) : length(scenes::toKodo(link.pointB - link.point));
        spring.hertz = real(link.hertz);
        spring.damping = real(link.damping);
        if (link.kind == Kind::RopeJoint) {
            spring.limits = kodo::Range{0, spring.length};
        } else if (link.hertz == 0) {
            spring.limits = kodo::Range{spring.length, spring.length};
        }
        return scene_.world.add(spring);
    }

    static std::optional<kodo::Range> range(const std::optional<Limits>& limits) {
        return limits ? std::optional(kodo::Range{real(limits->lower), real(limits->upper)})
                      : std::nullopt;
    }
    kodo::Vec2 axisOf(const Link& link) const {
        return unrotate(scene_.world[scene_.ids[link.a]].rotation(), scenes::toKodo(link.axis));
    }

    std::size_t indexOf(kodo::BodyId id) const {
        if (id.index < scene_.ids.size() && scene_.ids[id.index] == id) {
            return id.index; // as long as no body was removed
        }
        const auto at = std::find(scene_.ids.begin(), scene_.ids.end(), id);
        return static_cast<std::size_t>(at - scene_.ids.begin());
    }

    kodo::Vec2 anchor(std::size_t body, scenes::Vec2 point) const {
        const kodo::BodyView view = scene_.world[scene_.ids[body]];
        return unrotate(view.rotation(), scenes::toKodo(point) - view.position());
    }

    scenes::KodoScene scene_;
    std::vector<kodo::JointId> joints_;
};

} // namespace

std::unique_ptr<Engine> makeKodo(const scenes::SceneDef& scene, Profile profile) {
    return std::make_unique<KodoEngine>(scene, profile);
}

} // namespace crosscheck::KODO_PRECISION
