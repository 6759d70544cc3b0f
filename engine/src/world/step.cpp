// SPDX-License-Identifier: MIT
#include "base/checks.hpp"
#include "bodies/integrate.hpp"
#include "solve/impact_solver.hpp"
#include "world/world_impl.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// With fewer awake bodies, a step ends before a helper could start.
constexpr std::size_t kMinBodiesForHelp = 256;
constexpr std::size_t kBodiesPerPiece = 256;

} // namespace

void WorldImpl::step(Real dt, const StepOptions& options) {
    refuse(checkRange("dt", dt, kMinTimeStep, kMaxTimeStep, "s"));
    const ChangeGuard::Step running(guard_);
    const auto enter = [&](StepStage stage) {
        if (options.listener != nullptr) {
            options.listener->enter(stage);
        }
    };
    enter(StepStage::Broad);
    updateAwake();
    WorkerTeam team(bodies_.awake.size() >= kMinBodiesForHelp ? options.executor : nullptr);
    const bool arrivals = !bodies_.changes.arrived.empty();
    contacts_.updatePairs(bodies_, tolerances_, dt, team);
    clearArrivals(bodies_);
    enter(StepStage::Narrow);
    updateManifolds(team);
    enter(StepStage::Forces);
    forAwake(team, beginMotion);
    wakeIslands(arrivals);
    gatherForces(dt, team);
    enter(StepStage::Solve);
    solve(dt, team);
    enter(StepStage::Continuous);
    if (settings_.has(Feature::ContinuousCollision)) {
        runContinuous(dt, team);
    }
    enter(StepStage::Record);
    finishMoves(team);
    if (!contacts_.contacts().empty() || !contacts_.touchChanges().empty()) {
        recordCollisions(team);
    }
    contacts_.finishStep(settings_.has(Feature::Records));
    broken_.clear();
    if (joints_.size() > 0) {
        breakJoints(dt);
    }
    enter(StepStage::Sleep);
    if (settings_.has(Feature::Sleep) && !bodies_.awake.empty() &&
        sleep_.updateSleep(bodies_, contacts_, joints_, settings_, tolerances_, dt)) {
        sleep_.sleepIslands(bodies_, contacts_, writeBack());
        softSolver_.blocks().shrink(bodies_, contacts_.contacts());
    }
    ++stepCount_;
    if (options.listener != nullptr) {
        options.listener->leave();
    }
}

/// Updates the manifolds.
void WorldImpl::updateManifolds(WorkerTeam& team) {
    ContactBlocks& blocks = softSolver_.blocks();
    evictTeleported();
    noteStart(bodies_);
    blocks.carry(bodies_, team);
    contacts_.updateManifolds(
        bodies_, tolerances_,
        {blocks.carried(), [&](Contact& contact) { blocks.evict(contact, bodies_); }}, team);
}

/// Evicts the resident contacts of teleported bodies, so that their manifolds are updated.
void WorldImpl::evictTeleported() {
    for (const std::uint32_t body : bodies_.changes.teleported) {
        contacts_.lists().forEach(body, [&](std::uint32_t slot) {
            if (contacts_.summaries()[slot].row != ContactRow::kNone) {
                softSolver_.blocks().evict(contacts_.contacts()[slot], bodies_);
                contacts_.noteRow(slot);
            }
        });
    }
}

/// Wakes islands that awake bodies touch, or bodies that were added or changed.
void WorldImpl::wakeIslands(bool arrivals) {
    if (canWake() || (arrivals && sleep_.anyAsleep())) {
        sleep_.wakeTouched(bodies_, contacts_, tolerances_);
        sleep_.wakeJointed(bodies_, contacts_, joints_);
    }
}

/// Computes the accelerations.
void WorldImpl::gatherForces(Real dt, WorkerTeam& team) {
    joints_.findBusy(bodies_, refreshAwake(bodies_));
    frozen_.clear();
    const bool changed = bodies_.accelerationsStale;
    if (!gatherAccelerations(bodies_, fields_, dt, team)) {
        freezeUnsoundForces();
    }
    if (changed) {
        noteLoads(bodies_);
    }
    if (region_) {
        makeOutsideStatic();
    }
    bodies_.anySleeping = sleep_.anyAsleep();
}

/// Continuous collision: shortens displacements at the first impact.
void WorldImpl::runContinuous(Real dt, WorkerTeam& team) {
    contacts_.coverDisplacements(bodies_, tolerances_, team);
    if (canWake() && sleep_.wakeRunOver(bodies_, contacts_, tolerances_)) {
        joints_.findBusy(bodies_, refreshAwake(bodies_));
    }
    if (!contacts_.contacts().empty()) {
        continuous_.run(bodies_, contacts_, joints_, {settings_, tolerances_, dt}, team);
    }
}

/// Applies the displacements. Bodies with unsound motion freeze at their present poses.
void WorldImpl::finishMoves(WorkerTeam& team) {
    restoreOutside();
    if (!allSound(team)) {
        freezeUnsoundMotion();
    }
    forAwake(team, movePoses);
    queries_.bodiesMoved(bodies_.awake);
}

void WorldImpl::forAwake(WorkerTeam& team, void (*work)(Bodies&, std::span<const std::uint32_t>)) {
    team.forEach(bodies_.awake.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
        work(bodies_, std::span<const std::uint32_t>(bodies_.awake).subspan(first, last - first));
    });
}

void WorldImpl::solve(Real dt, WorkerTeam& team) {
    if (std::holds_alternative<PropagationSettings>(settings_.solver)) {
        contacts_.visitAll(); // it predicts contacts within the step
        propagation_.solve(bodies_, contacts_, joints_, {settings_, tolerances_, dt, stepCount_});
        contacts_.noteManifolds();
        contactVisits_ = propagation_.visits();
        return;
    }
    impacts_.solve(bodies_, contacts_, softSolver_.blocks(), {settings_, tolerances_, dt, team});
    softSolver_.solve(bodies_, contacts_, joints_, {settings_, tolerances_, dt, team});
    contactVisits_ = softSolver_.visits();
}

/// Deactivates bodies that left the region, and activates those that it reaches.
void WorldImpl::updateAwake() {
    if (region_) {
        for (const std::uint32_t body : bodies_.awake) {
            if (bodies_.ids.aliveAt(body) && !overlap(*region_, boundsOfBody(bodies_, body))) {
                placeInRegion(body);
            }
        }
    }
    const bool changed = refreshAwake(bodies_);
    joints_.findBusy(bodies_, changed);
    if (changed && (sleep_.anyAsleep() || region_)) {
        for (const std::uint32_t body : bodies_.changes.toggled) {
            contacts_.activityChanged(body);
        }
    }
}

void WorldImpl::freezeUnsoundForces() {
    for (const std::uint32_t body : bodies_.awake) {
        if (!isSound(bodies_.acceleration[body])) {
            freeze(bodies_, body);
            frozen_.push_back(bodies_.idAt(body));
            contacts_.bodiesChanged(); // a frozen body is immovable
            softSolver_.blocks().discardLanes();
        }
    }
}

bool WorldImpl::allSound(WorkerTeam& team) const {
    // Fast test, four numbers at a time; isSound() has the same limit for velocities and
    // displacements. A vector is shorter than the limit if both components are below half of it.
    const Real slow = kMaxSpeed * std::min(tolerances_.unit(), Real(1)) / 2;
    const Four bound{slow, slow, slow, 0}; // the fourth number is an inverse mass or inertia
    std::uint8_t fast = 0;
    team.forEach(bodies_.awake.size(), kBodiesPerPiece, [&](std::size_t first, std::size_t last) {
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
void WorldImpl::freezeUnsoundMotion() {
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
        const BodyId id = bodies_.idAt(body);
        if (std::find(frozen_.begin(), frozen_.end(), id) == frozen_.end()) {
            frozen_.push_back(id);
        }
    }
    if (frozen_.size() > before) {
        for (BodyVelocity& motion : bodies_.motion) { // also locked bodies: 0 times infinity is NaN
            if (!isSound(motion, tolerances_.unit())) {
                motion.stop();
            }
        }
        writeBackContacts();
        contacts_.forgetUnsound(bodies_, tolerances_);
        joints_.forgetUnsound();
        contacts_.bodiesChanged();
        bodies_.awakeStale = true;
    }
}

void WorldImpl::breakJoints(Real dt) {
    const std::span<const BrokenJoint> broken = joints_.endStep(dt);
    broken_.assign(broken.begin(), broken.end());
    if (!broken_.empty()) {
        contacts_.setExcludedPairs(joints_.excludedPairs());
    }
}

/// Updates the contact phases and kColliding. Only bodies whose flag changes are visited.
void WorldImpl::recordCollisions(WorkerTeam& team) {
    contacts_.finishStepOfContacts(softSolver_.blocks().touched(), tolerances_, team);
    for (const std::uint32_t body : contacts_.touchChanges()) {
        Flags& flags = bodies_.filter[body].flags;
        flags = contacts_.isTouched(body) ? flags | kColliding : flags & ~kColliding;
    }
    contacts_.clearTouchChanges();
}

} // namespace KODO_PRECISION
} // namespace kodo
