// SPDX-License-Identifier: MIT
#include "world/world_step.hpp"

#include "bodies/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr std::size_t kBodiesPerPiece = 256;

} // namespace

void WorldStep::run(StageListener* listener) {
    const auto enter = [&](StepStage stage) {
        if (listener != nullptr) {
            listener->enter(stage);
        }
    };
    makeRoom();
    const bool arrivals = !bodies.changes.arrived.empty();
    contactSet.updatePairs(bodies, joints.lists(), tolerances, dt, team);
    clearArrivals(bodies);
    enter(StepStage::Narrow);
    contactSet.updateManifolds(bodies, tolerances, dt, team);
    enter(StepStage::Forces);
    forAwake(beginMotion);
    wakeIslands(arrivals);
    gatherForces();
    enter(StepStage::Solve);
    solve();
    countLostLoads(bodies);
    enter(StepStage::Continuous);
    if (settings.has(Feature::ContinuousCollision) && settings.has(Feature::Collision)) {
        runContinuous();
    }
    enter(StepStage::Record);
    joints.count(bodies);
    finishMoves();
    if (!contactSet.contacts().empty() || !contactSet.touchCounts().changes().empty()) {
        recordCollisions();
    }
    contactSet.records().finish(settings.has(Feature::Records));
    world_.broken_.clear();
    if (joints.size() > 0) {
        breakJoints();
    }
    enter(StepStage::Sleep);
    world_.sleep_.keepArrivals(bodies, contactSet);
    if (settings.has(Feature::Sleep) && !bodies.awake.empty() &&
        world_.sleep_.updateSleep(bodies, contactSet, joints, settings, tolerances, dt)) {
        world_.sleep_.sleepIslands(bodies, contactSet);
    }
    if (listener != nullptr) {
        listener->leave();
    }
}

/// Sizes what is stored by body in the step after bodies were added: no later one has to.
void WorldStep::makeRoom() {
    if (world_.roomFor_ == bodies.size()) {
        return;
    }
    world_.roomFor_ = bodies.size();
    contactSet.makeRoom(bodies);
    std::visit([&](const auto& own) { solverOf(own).makeRoom(bodies); }, settings.solver);
    if (settings.has(Feature::ContinuousCollision)) {
        world_.continuous_.makeRoom(bodies);
    }
    if (settings.has(Feature::Sleep)) {
        world_.sleep_.makeRoom(bodies);
    }
}

/// Wakes islands that awake bodies touch, or bodies that were added or changed.
void WorldStep::wakeIslands(bool arrivals) {
    if (canWake() || (arrivals && world_.sleep_.anyAsleep())) {
        world_.sleep_.wakeTouched(bodies, contactSet, tolerances);
        world_.sleep_.wakeJointed(bodies, contactSet, joints);
    }
}

/// Computes the accelerations.
void WorldStep::gatherForces() {
    if (world_.listAwake()) {
        contactSet.addArrivals(bodies.changes.toggled); // kinematic bodies that stopped
    }
    if (bodies.changes.anyDamped) {
        dampVelocities(bodies, dt, team);
    }
    world_.frozen_.clear();
    if (!gatherAccelerations(bodies, world_.fields_, dt, team)) {
        freezeUnsoundForces();
    }
    if (bodies.changes.loadsStale) {
        noteLoads(bodies);
    }
    if (world_.region_.isActive()) {
        world_.region_.makeOutsideStatic(bodies, contactSet, joints);
        world_.region_.forEachHeld([&](std::uint32_t body) {
            contactSet.measureApproach(bodies, body); // its velocity is zero now
        });
    }
    bodies.anySleeping = world_.sleep_.anyAsleep();
}

/// Continuous collision: shortens displacements at the first impact.
void WorldStep::runContinuous() {
    contactSet.coverDisplacements(bodies, joints.lists(), tolerances, team);
    if (canWake() && world_.sleep_.wakeRunOver(bodies, contactSet, tolerances)) {
        world_.listAwake();
    }
    if (!contactSet.contacts().empty()) {
        world_.continuous_.run(*this);
        for (const std::uint32_t slot : world_.continuous_.stoppedAtLines()) {
            contactSet.store().lane(slot).expire();
        }
    }
}

/// Applies the displacements. Bodies with unsound motion freeze at their present poses.
void WorldStep::finishMoves() {
    world_.region_.restoreOutside(bodies);
    if (!allSound()) {
        freezeUnsoundMotion();
    }
    forAwake(movePoses);
    if (settings.has(Feature::Collision)) {
        contactSet.candidates().coverPoses(bodies, tolerances);
    }
}

void WorldStep::forAwake(void (*move)(Bodies&, std::span<const std::uint32_t>)) {
    team.forEach(bodies.awake.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
        move(bodies, std::span<const std::uint32_t>(bodies.awake).subspan(first, last - first));
    });
}

void WorldStep::solve() {
    work = {};
    std::visit([&](const auto& own) { solverOf(own).solve(*this); }, settings.solver);
}

void WorldStep::freezeUnsoundForces() {
    for (const std::uint32_t body : bodies.awake) {
        if (!isSound(bodies.acceleration[body])) {
            freeze(bodies, body);
            world_.frozen_.push_back(bodies.idAt(body));
            contactSet.bodyChanged(body); // a frozen body is immovable
            contactSet.lanes().discardLanes();
        }
    }
}

bool WorldStep::allSound() {
    // Fast test, four numbers at a time; isSound() has the same limit for velocities and
    // displacements. A vector is shorter than the limit if both components are below half of it.
    const Real slow = kMaxSpeed * std::min(tolerances.unit(), Real(1)) / 2;
    const Four bound{slow, slow, slow, 0}; // the fourth number is an inverse mass or inertia
    std::uint8_t fast = 0;
    team.forEach(bodies.awake.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
        auto within = bound == bound;
        for (std::size_t k = first; k < last; ++k) {
            const BodyVelocity& motion = bodies.motion[bodies.awake[k]];
            within &= (speeds(motion) <= bound) & (speeds(motion) >= -bound) &
                      (moves(motion) <= bound) & (moves(motion) >= -bound);
        }
        if ((within[0] & within[1] & within[2]) == 0) {
            WorkerTeam::mark(fast);
        }
    });
    return fast == 0 || std::all_of(bodies.awake.begin(), bodies.awake.end(), [&](auto body) {
               return isSound(bodies.motion[body], tolerances.unit());
           });
}

/// A body that became unsound may have affected its neighbours within the step. All affected bodies
/// stop; only those with finite velocities are frozen.
void WorldStep::freezeUnsoundMotion() {
    const std::size_t before = world_.frozen_.size();
    for (const std::uint32_t body : bodies.awake) {
        BodyVelocity& motion = bodies.motion[body];
        if (isSound(motion, tolerances.unit())) {
            continue;
        }
        if (isFinite(motion.velocity) && std::isfinite(motion.angularVelocity)) {
            freeze(bodies, body); // too fast by itself
        }
        motion.stop();
        contactSet.bodyChanged(body);
        const BodyId id = bodies.idAt(body);
        if (!std::binary_search(world_.frozen_.data(), world_.frozen_.data() + before, id)) {
            world_.frozen_.push_back(id);
        }
    }
    if (world_.frozen_.size() > before) {
        for (BodyVelocity& motion : bodies.motion) { // also locked bodies: 0 times infinity is NaN
            if (!isSound(motion, tolerances.unit())) {
                motion.stop();
            }
        }
        contactSet.forgetUnsound(bodies, tolerances, dt);
        joints.forgetUnsound();
        bodies.changes.allActivity = true;
    }
}

void WorldStep::breakJoints() {
    const std::span<const BrokenJoint> broken = joints.endStep(dt);
    world_.broken_.assign(broken.begin(), broken.end());
    for (const BrokenJoint& joint : world_.broken_) {
        bodies.noteLostLoad(joint.a.index);
        bodies.noteLostLoad(joint.b.index);
    }
    joints.takePairChanges([&](std::uint32_t body) { contactSet.activityChanged(body); });
}

/// Updates the contact phases and kColliding. Only bodies whose flag changes are visited.
void WorldStep::recordCollisions() {
    contactSet.finishStepOfContacts(bodies, tolerances, team);
    for (const std::uint32_t body : contactSet.touchCounts().changes()) {
        Flags& flags = bodies.filter[body].flags;
        flags = contactSet.touchCounts().isTouched(body) ? flags | kColliding : flags & ~kColliding;
    }
    contactSet.touchCounts().clearChanges();
}

} // namespace KODO_PRECISION
} // namespace kodo
