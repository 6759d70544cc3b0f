// SPDX-License-Identifier: MIT
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/impact.hpp>
#include <kodo/world/world.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::inline KODO_PRECISION {

void World::step(Real dt, StageWatch* watch) {
    refuse(checkRange("dt", dt, kShortestStep, kLongestStep));
    const auto enter = [&](StepStage stage) {
        if (watch != nullptr) {
            watch->enter(stage);
        }
    };
    enter(StepStage::Broad);
    findAwake();
    contacts_.updatePairs(bodies_, tolerances_, dt);
    enter(StepStage::Narrow);
    contacts_.updateManifolds(bodies_, tolerances_);
    enter(StepStage::Forces);
    beginMotion(bodies_);
    rest_.wakeTouched(bodies_, contacts_, tolerances_);
    rest_.wakeJointed(bodies_, contacts_, joints_);
    refreshAwake(bodies_);
    gatherAccelerations(bodies_, fields_, dt);
    freezeUnsoundForces();
    if (region_) {
        holdWhatWaits();
    }
    enter(StepStage::Solve);
    solve(dt);
    enter(StepStage::Sweep);
    if (settings_.has(Feature::Sweep)) {
        contacts_.coverMoves(bodies_, tolerances_);
        sweep_.run(bodies_, contacts_.contacts(), settings_, tolerances_, dt);
    }
    enter(StepStage::Record);
    releaseWhatWaits();
    freezeUnsoundMotion();
    movePoses(bodies_);
    recordCollisions();
    breakJoints(dt);
    enter(StepStage::Rest);
    rest_.settle(bodies_, contacts_, joints_, settings_, tolerances_, dt);
    ++stepCount_;
    if (watch != nullptr) {
        watch->leave();
    }
}

void World::solve(Real dt) {
    const std::span<Contact> contacts = contacts_.contacts();
    if (settings_.strategy == Strategy::Propagation) {
        propagation_.solve(bodies_, contacts, joints_, {settings_, tolerances_, dt, stepCount_});
        contactVisits_ = propagation_.visits();
        return;
    }
    if (contacts_.fastestApproach() > leastRestSpeed(bodies_, dt)) {
        solveImpacts(bodies_, contacts, settings_, tolerances_, dt);
    }
    softStep_.solve(bodies_, contacts, joints_, settings_, tolerances_, dt);
    contactVisits_ = softStep_.visits();
}

/// Bodies that have left the region wait, and those that it has reached go on.
void World::findAwake() {
    if (region_) {
        for (const std::uint32_t body : bodies_.awake) {
            if (bodies_.ids.aliveAt(body) && !overlap(*region_, boundsOfBody(bodies_, body))) {
                placeInRegion(body);
            }
        }
    }
    if (refreshAwake(bodies_) && (rest_.anyResting() || region_)) {
        contacts_.activityChanged();
    }
}

void World::freezeUnsoundForces() {
    frozen_.clear();
    for (const std::uint32_t body : bodies_.awake) {
        if (!isSound(bodies_.acceleration[body])) {
            freeze(bodies_, body);
            frozen_.push_back(bodies_.idAt(body));
        }
    }
}

/// What a body that became unsound did to its neighbours within the step cannot be told apart any
/// more, so they stop with it, but are free to go on from there.
void World::freezeUnsoundMotion() {
    const std::size_t before = frozen_.size();
    for (const std::uint32_t body : bodies_.awake) {
        Motion& motion = bodies_.motion[body];
        if (isSound(motion)) {
            continue;
        }
        if (isFinite(motion.velocity) && std::isfinite(motion.angularVelocity)) {
            freeze(bodies_, body); // too fast by itself
        }
        motion.stand();
        const BodyId id = bodies_.idAt(body);
        if (std::find(frozen_.begin(), frozen_.end(), id) == frozen_.end()) {
            frozen_.push_back(id);
        }
    }
    if (frozen_.size() > before) {
        for (Motion& motion : bodies_.motion) { // of what stands too: 0 times infinity is no number
            if (!isSound(motion)) {
                motion.stand();
            }
        }
        for (Contact& contact : contacts_.contacts()) {
            softStep_.fetch(contact);
        }
        contacts_.forgetUnsound(bodies_, tolerances_);
        joints_.forgetUnsound();
        contacts_.bodiesChanged(); // what froze is a piece of ground now
    }
}

void World::breakJoints(Real dt) {
    const std::span<const BrokenJoint> broken = joints_.endStep(dt);
    broken_.assign(broken.begin(), broken.end());
    if (!broken_.empty()) {
        contacts_.setApart(joints_.apart());
    }
}

/// Sums up the contacts of the step, and brings kColliding up to date: only those for which it
/// changes are touched.
void World::recordCollisions() {
    constexpr std::uint8_t kBefore = 1;
    constexpr std::uint8_t kNow = 2;
    isColliding_.resize(bodies_.size());
    for (const std::uint32_t body : colliding_) {
        isColliding_[body] = kBefore;
    }
    std::swap(colliding_, collidedBefore_);
    colliding_.clear();
    colliding_.reserve(collidedBefore_.capacity()); // the two take turns
    const auto note = [&](std::uint32_t body) {
        if ((isColliding_[body] & kNow) == 0) {
            isColliding_[body] |= kNow;
            colliding_.push_back(body);
        }
    };
    contacts_.finishStep(
        tolerances_, settings_.has(Feature::Records),
        [&](Contact& contact) { softStep_.fetch(contact); },
        [&](const Contact& contact) {
            note(contact.key.bodyA);
            note(contact.key.bodyB);
        });
    for (const std::uint32_t body : collidedBefore_) {
        if (isColliding_[body] == kBefore) {
            bodies_.record[body].filter.flags &= ~kColliding;
        }
    }
    for (const std::uint32_t body : colliding_) {
        if (isColliding_[body] == kNow) {
            bodies_.record[body].filter.flags |= kColliding;
        }
        isColliding_[body] = 0;
    }
    for (const std::uint32_t body : collidedBefore_) {
        isColliding_[body] = 0;
    }
}

} // namespace kodo::inline KODO_PRECISION
