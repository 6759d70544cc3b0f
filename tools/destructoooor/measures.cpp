// SPDX-License-Identifier: MIT
#include "measures.hpp"

#include <algorithm>
#include <numeric>

namespace destructoooor {

void Measures::clear() {
    samples_.clear();
    stages_ = {};
    within_ = false;
}

void Measures::endStage() {
    if (within_) {
        stages_[stage_] += std::chrono::duration<float, std::micro>(Clock::now() - since_).count();
    }
}

void Measures::enter(kodo::StepStage stage) {
    endStage();
    stage_ = static_cast<std::size_t>(stage);
    since_ = Clock::now();
    within_ = true;
}

void Measures::leave() {
    endStage();
    within_ = false;
}

void Measures::sample(const kodo::World& world, kodo::Real gravity) {
    Sample now;
    kodo::Vec2 momentum{};
    double energy = 0;
    for (const kodo::BodyId id : world.bodies()) {
        const kodo::BodyView body = world[id];
        if (body.type() != kodo::BodyType::Dynamic) {
            continue;
        }
        const kodo::Real speed = kodo::length(body.velocity());
        const kodo::Real spin = body.angularVelocity();
        momentum += body.mass() * body.velocity();
        energy +=
            static_cast<double>(body.mass() * (speed * speed / 2 + gravity * body.center().y) +
                                body.inertia() * spin * spin / 2);
        now.fastest = std::max(now.fastest, static_cast<float>(speed));
        now.awake += body.isAsleep() ? 0.0f : 1.0f;
    }
    now.energy = static_cast<float>(energy);
    now.momentum = static_cast<float>(kodo::length(momentum));
    for (const kodo::CollisionRecord& record : world.collisions()) {
        if (record.phase != kodo::TouchPhase::End) {
            now.overlap = std::max(now.overlap, static_cast<float>(-1000 * record.separation));
        }
    }
    for (const kodo::JointId id : world.joints()) {
        const kodo::JointDef& joint = world.joint(id);
        if (std::holds_alternative<kodo::RevoluteJoint>(joint) ||
            std::holds_alternative<kodo::FixedJoint>(joint)) {
            now.gap = std::max(now.gap, static_cast<float>(1000 * world.jointState(id).length));
        }
    }
    const kodo::StepStats work = kodo::stepStats(world);
    now.visits = static_cast<float>(work.contacts);
    now.parts = static_cast<float>(work.mostParts);
    now.refined = static_cast<float>(work.refinedBodies);
    now.stages = stages_;
    now.step = std::accumulate(stages_.begin(), stages_.end(), 0.0f);
    stages_ = {};
    if (samples_.size() == kKept) {
        samples_.erase(samples_.begin());
    }
    samples_.push_back(now);
}

} // namespace destructoooor
