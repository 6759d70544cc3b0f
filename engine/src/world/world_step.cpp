// SPDX-License-Identifier: MIT
#include "world/world_step.hpp"

#include "bodies/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// With fewer awake bodies, a step ends before a helper could start.
constexpr std::size_t kMinBodiesForHelp = 256;
constexpr std::size_t kBodiesPerPiece = 256;

} // namespace

WorldStep::WorldStep(WorldImpl& world, Real dt, Executor* executor)
    : settings_(world.settings_),
      tolerances_(world.tolerances_),
      fields_(world.fields_),
      bodies_(world.bodies_),
      contacts_(world.contacts_),
      joints_(world.joints_),
      sleep_(world.sleep_),
      region_(world.region_),
      impacts_(world.impacts_),
      softSolver_(world.softSolver_),
      propagation_(world.propagation_),
      continuous_(world.continuous_),
      broken_(world.broken_),
      frozen_(world.frozen_),
      roomFor_(world.roomFor_),
      contactVisits_(world.contactVisits_),
      stepCount_(world.stepCount_),
      dt_(dt),
      team_(bodies_.awake.size() >= kMinBodiesForHelp ? executor : nullptr) {}

void WorldStep::run(StageListener* listener) {
    const auto enter = [&](StepStage stage) {
        if (listener != nullptr) {
            listener->enter(stage);
        }
    };
    makeRoom();
    const bool arrivals = !bodies_.changes.arrived.empty();
    contacts_.updatePairs(bodies_, joints_.lists(), tolerances_, dt_, team_);
    clearArrivals(bodies_);
    enter(StepStage::Narrow);
    contacts_.updateManifolds(bodies_, tolerances_, dt_, team_);
    enter(StepStage::Forces);
    forAwake(beginMotion);
    wakeIslands(arrivals);
    gatherForces();
    enter(StepStage::Solve);
    const StepInput input{bodies_,     contacts_, joints_, settings_,
                          tolerances_, dt_,       team_,   stepCount_};
    solve(input);
    countLostLoads(bodies_);
    enter(StepStage::Continuous);
    if (settings_.has(Feature::ContinuousCollision)) {
        runContinuous(input);
    }
    enter(StepStage::Record);
    joints_.count(bodies_);
    finishMoves();
    if (!contacts_.contacts().empty() || !contacts_.touchCounts().changes().empty()) {
        recordCollisions();
    }
    contacts_.records().finish(settings_.has(Feature::Records));
    broken_.clear();
    if (joints_.size() > 0) {
        breakJoints();
    }
    enter(StepStage::Sleep);
    sleep_.keepArrivals(bodies_, contacts_);
    if (settings_.has(Feature::Sleep) && !bodies_.awake.empty() &&
        sleep_.updateSleep(bodies_, contacts_, joints_, settings_, tolerances_, dt_)) {
        sleep_.sleepIslands(bodies_, contacts_);
    }
    if (listener != nullptr) {
        listener->leave();
    }
}

/// Sizes what is stored by body in the step after bodies were added: no later one has to.
void WorldStep::makeRoom() {
    if (roomFor_ == bodies_.size()) {
        return;
    }
    roomFor_ = bodies_.size();
    contacts_.makeRoom(bodies_);
    if (std::holds_alternative<PropagationSettings>(settings_.solver)) {
        propagation_.makeRoom(bodies_);
    } else {
        impacts_.makeRoom(bodies_);
        softSolver_.makeRoom(bodies_);
    }
    if (settings_.has(Feature::ContinuousCollision)) {
        continuous_.makeRoom(bodies_);
    }
    if (settings_.has(Feature::Sleep)) {
        sleep_.makeRoom(bodies_);
    }
}

/// Wakes islands that awake bodies touch, or bodies that were added or changed.
void WorldStep::wakeIslands(bool arrivals) {
    if (canWake() || (arrivals && sleep_.anyAsleep())) {
        sleep_.wakeTouched(bodies_, contacts_, tolerances_);
        sleep_.wakeJointed(bodies_, contacts_, joints_);
    }
}

/// Brings the list of awake bodies up to date. True if any may have toggled.
bool WorldStep::updateAwake() {
    const bool toggled = refreshAwake(bodies_);
    joints_.findBusy(bodies_, toggled);
    if (toggled) {
        contacts_.candidates().moveToTrees(bodies_, bodies_.changes.toggled);
    }
    return toggled;
}

/// Computes the accelerations.
void WorldStep::gatherForces() {
    if (updateAwake()) {
        contacts_.addArrivals(bodies_.changes.toggled); // kinematic bodies that stopped
    }
    if (bodies_.changes.anyDamped) {
        dampVelocities(bodies_, dt_, team_);
    }
    frozen_.clear();
    if (!gatherAccelerations(bodies_, fields_, dt_, team_)) {
        freezeUnsoundForces();
    }
    if (bodies_.changes.loadsStale) {
        noteLoads(bodies_);
    }
    if (region_.isActive()) {
        region_.makeOutsideStatic(bodies_, contacts_, joints_);
        region_.forEachHeld([&](std::uint32_t body) {
            contacts_.measureApproach(bodies_, body); // its velocity is zero now
        });
    }
    bodies_.anySleeping = sleep_.anyAsleep();
}

/// Continuous collision: shortens displacements at the first impact.
void WorldStep::runContinuous(const StepInput& input) {
    contacts_.coverDisplacements(bodies_, joints_.lists(), tolerances_, team_);
    if (canWake() && sleep_.wakeRunOver(bodies_, contacts_, tolerances_)) {
        updateAwake();
    }
    if (!contacts_.contacts().empty()) {
        continuous_.run(input);
        for (const std::uint32_t slot : continuous_.stoppedAtLines()) {
            contacts_.store().lane(slot).expire();
        }
    }
}

/// Applies the displacements. Bodies with unsound motion freeze at their present poses.
void WorldStep::finishMoves() {
    region_.restoreOutside(bodies_);
    if (!allSound()) {
        freezeUnsoundMotion();
    }
    forAwake(movePoses);
    contacts_.candidates().coverPoses(bodies_, tolerances_);
}

void WorldStep::forAwake(void (*work)(Bodies&, std::span<const std::uint32_t>)) {
    team_.forEach(bodies_.awake.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
        work(bodies_, std::span<const std::uint32_t>(bodies_.awake).subspan(first, last - first));
    });
}

void WorldStep::solve(const StepInput& input) {
    if (std::holds_alternative<PropagationSettings>(settings_.solver)) {
        propagation_.solve(input);
        contactVisits_ = propagation_.visits();
        return;
    }
    impacts_.solve(input);
    softSolver_.solve(input);
    contactVisits_ = softSolver_.visits();
}

void WorldStep::freezeUnsoundForces() {
    for (const std::uint32_t body : bodies_.awake) {
        if (!isSound(bodies_.acceleration[body])) {
            freeze(bodies_, body);
            frozen_.push_back(bodies_.idAt(body));
            contacts_.bodyChanged(body); // a frozen body is immovable
            contacts_.lanes().discardLanes();
        }
    }
}

bool WorldStep::allSound() {
    // Fast test, four numbers at a time; isSound() has the same limit for velocities and
    // displacements. A vector is shorter than the limit if both components are below half of it.
    const Real slow = kMaxSpeed * std::min(tolerances_.unit(), Real(1)) / 2;
    const Four bound{slow, slow, slow, 0}; // the fourth number is an inverse mass or inertia
    std::uint8_t fast = 0;
    team_.forEach(bodies_.awake.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
        auto within = bound == bound;
        for (std::size_t k = first; k < last; ++k) {
            const BodyVelocity& motion = bodies_.motion[bodies_.awake[k]];
            within &= (speeds(motion) <= bound) & (speeds(motion) >= -bound) &
                      (moves(motion) <= bound) & (moves(motion) >= -bound);
        }
        if ((within[0] & within[1] & within[2]) == 0) {
            WorkerTeam::mark(fast);
        }
    });
    return fast == 0 || std::all_of(bodies_.awake.begin(), bodies_.awake.end(), [&](auto body) {
               return isSound(bodies_.motion[body], tolerances_.unit());
           });
}

/// A body that became unsound may have affected its neighbours within the step. All affected bodies
/// stop; only those with finite velocities are frozen.
void WorldStep::freezeUnsoundMotion() {
    const std::size_t before = frozen_.size();
    for (const std::uint32_t body : bodies_.awake) {
        BodyVelocity& motion = bodies_.motion[body];
        if (isSound(motion, tolerances_.unit())) {
            continue;
        }
        if (isFinite(motion.velocity) && std::isfinite(motion.angularVelocity)) {
            freeze(bodies_, body); // too fast by itself
        }
        motion.stop();
        contacts_.bodyChanged(body);
        const BodyId id = bodies_.idAt(body);
        if (!std::binary_search(frozen_.data(), frozen_.data() + before, id)) {
            frozen_.push_back(id);
        }
    }
    if (frozen_.size() > before) {
        for (BodyVelocity& motion : bodies_.motion) { // also locked bodies: 0 times infinity is NaN
            if (!isSound(motion, tolerances_.unit())) {
                motion.stop();
            }
        }
        contacts_.forgetUnsound(bodies_, tolerances_, dt_);
        joints_.forgetUnsound();
        bodies_.changes.allActivity = true;
    }
}

void WorldStep::breakJoints() {
    const std::span<const BrokenJoint> broken = joints_.endStep(dt_);
    broken_.assign(broken.begin(), broken.end());
    for (const BrokenJoint& joint : broken_) {
        bodies_.noteLostLoad(joint.a.index);
        bodies_.noteLostLoad(joint.b.index);
    }
    joints_.takePairChanges([&](std::uint32_t body) { contacts_.activityChanged(body); });
}

/// Updates the contact phases and kColliding. Only bodies whose flag changes are visited.
void WorldStep::recordCollisions() {
    contacts_.finishStepOfContacts(bodies_, tolerances_, team_);
    for (const std::uint32_t body : contacts_.touchCounts().changes()) {
        Flags& flags = bodies_.filter[body].flags;
        flags = contacts_.touchCounts().isTouched(body) ? flags | kColliding : flags & ~kColliding;
    }
    contacts_.touchCounts().clearChanges();
}

} // namespace KODO_PRECISION
} // namespace kodo
