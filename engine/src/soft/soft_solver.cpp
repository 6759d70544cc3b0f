// SPDX-License-Identifier: MIT
#include "soft/soft_solver.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Largest part of a cycle of contact and joint springs in a substep. With 1/4 for contacts piles
// shake for long and creep apart; with 1/5 they come to rest.
constexpr Real kMostCycles = Real(0.21);
constexpr Real kMostJointCycles = Real(0.25);
// With 0, rows of ten springs of 1,000 Hz gain energy; with 4 or 8 they gain none.
constexpr int kSpringPasses = 4;
// Separating speed, in slops per second, above which a contact carries nothing. With 36, columns of
// 1 : 300 that a weight lands on give way.
constexpr Real kCarriesNothing = 64;

} // namespace

void SoftSolver::makeRoom(const Bodies& bodies) {
    impacts_.makeRoom(bodies);
    resizeByBody(exposure_, bodies);
    resizeByBody(near_, bodies);
    resizeByBody(touched_, bodies);
    resizeByBody(overlapCount_, bodies);
    resizeByBody(before_, bodies);
    refinement_.makeRoom(bodies);
    manifoldRefresh_.makeRoom(bodies);
    loadRelease_.makeRoom(bodies);
}

/// Lists the bodies of joints that RevoluteBlocks does not solve, each once.
void SoftSolver::findJointed(const JointSet& joints) {
    jointed_.clear();
    joints.forEachOwn([&](const JointSet::Joint& joint) {
        jointed_.push_back(firstBody(joint.def).index);
        jointed_.push_back(secondBody(joint.def).index);
    });
    sortUnique(jointed_);
    fromJoints_.resize(jointed_.size());
    beforeJoints_.resize(jointed_.size());
}

/// True if no contact needs a row; then none has one.
bool SoftSolver::noneNeedsRow(const Bodies& bodies, ContactSet& contactSet,
                              const StepSettings& settings, const Tolerances& tolerances) {
    for (const std::uint32_t place : contactSet.live()) {
        if (contactSet.contacts()[place].responds() &&
            needsRow(bodies, contactSet.store(), place, settings.has(Feature::Restitution),
                     tolerances.slop)) {
            return false;
        }
        contactSet.store().leavePasses(place, bodies);
    }
    return true;
}

/// Moves bodies without contacts and joints over the whole step. So their flight does not depend on
/// the substeps, not even by rounding. The others are listed in their groups.
void SoftSolver::moveFree(Bodies& bodies, Real dt) {
    for (Group& group : groups_) {
        group.bound.clear();
    }
    std::vector<std::uint32_t>& bound = groups_[0].bound;
    free_.resize(bodies.awake.size());
    bound.resize(bodies.awake.size());
    kinematic_.clear();
    std::size_t free = 0;
    std::size_t held = 0;
    for (const std::uint32_t body : bodies.awake) {
        const ContactExposure near =
            near_[body] != 0 ? ContactExposure::Near : ContactExposure::Free;
        const ContactExposure hold = touched_[body] != 0 ? ContactExposure::Touched : near;
        exposure_[body] = hold;
        free_[free] = bound[held] = body; // only one of the two counts advances
        free += hold == ContactExposure::Free ? 1 : 0;
        held += hold == ContactExposure::Free ? 0 : 1;
    }
    free_.resize(free);
    bound.resize(held);
    if (bodies.loads.driven) {
        std::copy_if(bound.begin(), bound.end(), std::back_inserter(kinematic_),
                     [&](std::uint32_t body) { return bodies.locked(body); });
    }
    if (!refinement_.levels().empty()) {
        splitGroups(bodies);
    }
    moveFreely(bodies, free_, dt);
}

/// Moves the bodies of refined islands from the first group to the group of their level. Kinematic
/// bodies belong to each group that has other bodies.
void SoftSolver::splitGroups(const Bodies& bodies) {
    std::vector<std::uint32_t>& all = groups_[0].bound;
    std::size_t kept = 0;
    for (const std::uint32_t body : all) {
        const bool kinematic = bodies.locked(body);
        for (std::uint32_t level = 1; level < Refinement::kLevels; ++level) {
            if (kinematic || refinement_.levelOf(body) == level) {
                groups_[level].bound.push_back(body);
            }
        }
        if (kinematic || refinement_.levelOf(body) == 0) {
            all[kept++] = body;
        }
    }
    all.resize(kept);
    for (Group& group : groups_) {
        if (group.bound.size() == kinematic_.size()) {
            group.bound.clear();
        }
    }
}

/// Sets the displacement of kinematic bodies to that of the whole step, after the last group. So no
/// group affects its rounding.
void SoftSolver::moveKinematic(Bodies& bodies, Real dt) {
    for (const std::uint32_t body : kinematic_) {
        bodies.motion[body].clearDisplacement();
    }
    moveFreely(bodies, kinematic_, dt);
}

void SoftSolver::solve(const StepInput& step) {
    impacts_.solve(step);
    Bodies& bodies = step.bodies;
    ContactSet& contactSet = step.contactSet;
    if (step.joints.awakeCount() == 0 &&
        noneNeedsRow(bodies, contactSet, step.settings, step.tolerances)) {
        if (contactSet.lanes().size() > 0) {
            contactSet.lanes().forgetLanes();
        }
        moveFreely(bodies, bodies.awake, step.dt);
    } else {
        solveHeld(step);
    }
}

/// The contacts whose level has changed get another lane.
void SoftSolver::refine(const Bodies& bodies, ContactSet& contactSet) {
    contactSet.lanes().refine(refinement_.levels());
    for (std::uint32_t slot = 0; slot < contactSet.summaries().size(); ++slot) {
        if (!contactSet.lanes().hasLevel(contactSet.summaries()[slot])) {
            contactSet.store().change(slot, bodies).filled = false;
        }
    }
}

/// solve() for a step in which some bodies have contacts or joints.
void SoftSolver::solveHeld(const StepInput& step) {
    const auto& [bodies, contactSet, joints, settings, tolerances, dt, team, count, work] = step;
    const SoftSettings& soft = step.solver<SoftSettings>();
    const Real h = dt / static_cast<Real>(soft.substeps);
    const Real hertz = std::min(soft.contactHertz, kMostCycles / h);
    if (refinement_.find({step, hertz, std::min(soft.jointHertz, kMostJointCycles / h), h})) {
        refine(bodies, contactSet);
    }
    collect(step);
    if (anyCrowded_ != 0) {
        limitOverlaps(bodies, contactSet);
    }
    contactSet.store().sortByKey(newcomers_); // colours depend on the order
    contactSet.lanes().arrange(bodies, contactSet.store().all(), newcomers_,
                               anyCrowded_ != 0 ? std::span<const std::uint16_t>(overlapCount_)
                                                : std::span<const std::uint16_t>(),
                               soft.pushSpeed * tolerances.unit());
    joints.beginStep();
    joints.boundBias(contactSet, tolerances.slop, soft.pushSpeed * tolerances.unit());
    moveFree(bodies, dt);
    work.refinedBodies = refinement_.size();
    manifoldRefresh_.begin(dt);
    for (std::uint32_t level = 0; level < Refinement::kLevels; ++level) {
        if (!groups_[level].bound.empty()) {
            solveGroup(step, level);
            work.mostParts = std::uint32_t(1) << level;
        }
    }
    moveKinematic(bodies, dt);
    if (anyCrowded_ != 0) {
        clearOverlapCounts(contactSet);
    }
    contactSet.lanes().findTouching(tolerances.slop, team);
}

/// Solves the islands of a level.
void SoftSolver::solveGroup(const StepInput& step, std::uint32_t level) {
    const auto& [bodies, contactSet, joints, settings, tolerances, dt, team, count, work] = step;
    const SoftSettings& soft = step.solver<SoftSettings>();
    ContactBlocks& blocks = contactSet.lanes();
    const int parts = 1 << level;
    const int substeps = parts * soft.substeps;
    const Real h = dt / static_cast<Real>(soft.substeps) / static_cast<Real>(parts);
    const Real hertz = std::min(soft.contactHertz * static_cast<Real>(parts), kMostCycles / h);
    const Real jointHertz =
        std::min(soft.jointHertz * static_cast<Real>(parts), kMostJointCycles / h);
    // Stiffer joints close their gaps no faster, so that what a load has opened adds no energy.
    const Real damping =
        soft.jointDamping * static_cast<Real>(parts) * std::sqrt(static_cast<Real>(parts));
    JointPass jointPass{h, Softness::from(jointHertz, damping, h)};
    jointPass.springPasses = kSpringPasses;
    jointPass.mostBias = soft.pushSpeed * tolerances.unit();
    joints.beginGroup(bodies, soft.jointGap, refinement_.levels(), level);
    joints.scaleImpulses(1 / static_cast<Real>(parts));
    revolutes_.begin(bodies, joints);
    findJointed(joints);
    for (const std::uint32_t body : kinematic_) {
        bodies.motion[body].clearDisplacement();
    }
    WorkerTeam serial;
    const bool helped =
        blocks.worthPartitioning(level) && blocks.partitions().count() == team.partitions();
    Substeps run{step,
                 level,
                 {},
                 jointPass,
                 soft.pushSpeed * tolerances.slop * Tolerances::kSlopsPerUnit,
                 helped ? team : serial};
    run.pass.settings = {Softness::from(hertz, soft.contactDamping, h),
                         Softness::from(2 * hertz, soft.contactDamping, h), 1 / h,
                         settings.has(Feature::Friction), 1};
    run.pass.settings.pushSpeed = run.pushSpeed;
    run.pass.settings.thrown = kCarriesNothing * tolerances.slop;
    preparePasses(run);
    runSubsteps(run, substeps);
    revolutes_.end(bodies, joints, h, tolerances.slop);
    joints.scaleImpulses(static_cast<Real>(parts));
    work.contacts += (2 * blocks.size(level)) * static_cast<std::size_t>(substeps);
}

/// Gathers the blocks of a group for its passes, after lanes have changed.
void SoftSolver::preparePasses(Substeps& run) {
    Group& group = groups_[run.level];
    ContactBlocks& blocks = run.contactSet.lanes();
    run.pass = blocks.pass(run.bodies, run.level, run.pass.settings);
    if (!run.helpers.alone()) {
        group.partitions.buildGraph({blocks, run.level, run.pass, group.bound, run.bodies.size()},
                                    run.helpers);
    }
}

/// Before the passes of a substep: contacts get new manifolds and lanes where their bodies have
/// turned too far. Impulses that a warm start has applied act along the new manifold.
void SoftSolver::refreshManifolds(Substeps& run, bool first) {
    if (!run.helpers.alone()) {
        runPhases(run);
    }
    Bodies& bodies = run.bodies;
    ContactStore& store = run.contactSet.store();
    const ManifoldRefresh::Step step{run, run.jointPass.h, refinement_.arriving(), first};
    const bool restitution = run.settings.has(Feature::Restitution);
    const auto isSolved = [&](std::uint32_t body) {
        return bodies.isStill(body) ||
               (bodies.active(body) && exposure_[body] != ContactExposure::Free &&
                (bodies.locked(body) || refinement_.levelOf(body) == run.level));
    };
    const std::span<const std::uint32_t> slots =
        manifoldRefresh_.list(step, groups_[run.level].bound, [&](const ContactSummary& s) {
            return isSolved(s.bodyA) && isSolved(s.bodyB) &&
                   (!(s.bounces && restitution) || s.inPasses());
        });
    if (slots.empty()) {
        return;
    }
    if (!first) {
        for (const std::uint32_t slot : slots) {
            ManifoldRefresh::apply(step, slot, -1);
        }
    }
    newcomers_.clear();
    if (store.lanes().uncoloured() > 0) { // their lanes depend on one another
        for (std::size_t k = run.contactSet.live().size(); k-- > 0;) { // backwards, as freeLanes()
            const std::uint32_t slot = run.contactSet.live()[k];
            const ContactRow& row = store.summaries()[slot].row;
            if (row.index != ContactRow::kNone && row.colour == ContactRow::kNoColour) {
                store.lanes().drop(store.entry(slot));
                newcomers_.push_back(slot);
            }
        }
    }
    for (const std::uint32_t slot : slots) {
        store.lanes().drop(store.entry(slot));
        ManifoldRefresh::find(step, slot);
        if (store.contacts()[slot].responds()) {
            newcomers_.push_back(slot);
        }
    }
    store.sortByKey(newcomers_); // colours depend on the order
    newcomers_.erase(std::unique(newcomers_.begin(), newcomers_.end()), newcomers_.end());
    store.lanes().rearrange(bodies, store.all(), newcomers_, overlapCount_);
    for (const std::uint32_t slot : slots) {
        store.summaries()[slot].kept = false;
        if (!first) {
            ManifoldRefresh::apply(step, slot, 1);
        }
    }
    preparePasses(run);
}

} // namespace KODO_PRECISION
} // namespace kodo
