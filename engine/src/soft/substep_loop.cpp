// SPDX-License-Identifier: MIT
// The substeps of the soft solver, on one thread or on a worker team.
#include "bodies/integrate.hpp"

#include <algorithm>
#include <iterator>

#include "soft/soft_solver.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Applies the forces in the first substep.
void SoftSolver::beginVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    integrateVelocities(bodies, list, h);
    for (const std::uint32_t i : list) {
        before_[i].speeds = speeds(bodies.motion[i]);
        manifoldRefresh_.note(bodies.motion[i].angularVelocity);
    }
}

/// Applies the forces in a later substep, and the velocity change by contacts in the substep
/// before.
void SoftSolver::nextVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    const Four time{h, h, h, 0};
    for (const std::uint32_t i : list) {
        Four& speed = speeds(bodies.motion[i]);
        Four& before = before_[i].speeds;
        const Four gained = speed - before;
        before = speed + time * rates(bodies.acceleration[i]);
        speed = before + gained;
        manifoldRefresh_.note(speed[2]);
    }
}

void SoftSolver::move(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    integrateMoves(bodies, list, exposure_, h);
}

/// Runs a phase at once, or queues it for the worker team. Contacts of all partitions read
/// kinematic bodies, and only the calling thread solves joints. With either, the team waits after
/// each phase.
void SoftSolver::addPhase(Substeps& run, const Phase& phase) {
    if (run.helpers.alone()) {
        if (phase.pass != nullptr) {
            ContactPassArguments pass = run.pass;
            pass.settings = phase.settings;
            phase.pass(pass);
        } else {
            (this->*phase.work)(run.bodies, groups_[run.level].bound, run.jointPass.h);
        }
        return;
    }
    phases_.push_back(phase);
    if (run.bodies.loads.driven || !jointed_.empty() || !revolutes_.empty()) {
        runPhases(run);
    }
}

/// Runs the queued phases. Each colour of a pass takes two phases of the team: border blocks, then
/// inner blocks. Work on the bodies of a partition takes an even phase: all border impulses must
/// precede it.
void SoftSolver::runPhases(Substeps& run) {
    const BlockPartitions& partitions = groups_[run.level].partitions;
    std::uint32_t phases = 0;
    for (Phase& phase : phases_) {
        phase.firstPhase = phases;
        phases += phase.pass != nullptr ? 2 * partitions.colours() : 2;
    }
    run.helpers.inPhases(phases, [&](std::uint32_t partition, std::uint32_t number) {
        const Phase& phase = *std::prev(
            std::upper_bound(phases_.begin(), phases_.end(), number,
                             [](std::uint32_t at, const Phase& p) { return at < p.firstPhase; }));
        const bool even = number % 2 == 0;
        if (phase.pass != nullptr) {
            const auto blocks =
                partitions.blocks(partition, (number - phase.firstPhase) / 2, !even);
            ContactPassArguments pass = run.pass;
            pass.settings = phase.settings;
            pass.order = blocks.data();
            pass.count = blocks.size();
            phase.pass(pass);
        } else if (even) {
            const auto [first, count] = partitions.bodies(partition);
            (this->*phase.work)(
                run.bodies,
                std::span<const std::uint32_t>(groups_[run.level].bound).subspan(first, count),
                run.jointPass.h);
        }
    });
    phases_.clear();
}

/// Runs a pass over the joints and adds the velocity changes of their bodies to fromJoints_.
template <typename Pass>
void SoftSolver::passJoints(Substeps& run, Pass pass) {
    if (jointed_.empty()) {
        return;
    }
    const Bodies& bodies = run.bodies;
    for (std::size_t k = 0; k < jointed_.size(); ++k) {
        beforeJoints_[k].speeds = speeds(bodies.motion[jointed_[k]]);
    }
    pass();
    for (std::size_t k = 0; k < jointed_.size(); ++k) {
        fromJoints_[k].speeds += speeds(bodies.motion[jointed_[k]]) - beforeJoints_[k].speeds;
    }
}

/// After the warm start: releases impulses that carried a load which is gone.
void SoftSolver::releaseLoads(Substeps& run) {
    if (!run.helpers.alone()) {
        runPhases(run);
    }
    loadRelease_.run(run, groups_[run.level].bound, before_, run.jointPass.h);
}

/// Joint arms rotate within a step, so joints warm start with their own impulses in each substep.
/// Their velocity change in the substep before does not count as that of contacts. That of
/// RevoluteBlocks does, since these are soft: the next pass corrects the small rotation of their
/// arms in one substep.
void SoftSolver::runSubstep(Substeps& run, int substep, int substeps) {
    const bool first = substep == 0;
    const ContactPasses& passes = ContactPasses::best();
    Bodies& bodies = run.bodies;
    JointSet& joints = run.joints;
    JointPass& jointPass = run.jointPass;
    const PassSettings& settings = run.pass.settings;
    if (first) {
        std::fill(fromJoints_.begin(), fromJoints_.end(), Velocity{});
    }
    for (std::size_t k = 0; k < jointed_.size() && !first; ++k) {
        before_[jointed_[k]].speeds += fromJoints_[k].speeds;
        fromJoints_[k] = {};
    }
    addPhase(run, {.work = first ? &SoftSolver::beginVelocities : &SoftSolver::nextVelocities});
    refreshManifolds(run, first);
    passJoints(run, [&] { joints.warmStart(bodies, jointPass); });
    if (first) {
        revolutes_.warmStart(bodies, jointPass);
        addPhase(run, {passes.warmStart, settings});
        releaseLoads(run);
    }
    const auto solveJoints = [&](bool biased) {
        jointPass.biased = biased;
        jointPass.settle = substep + 1 == substeps;
        if (!joints.leaves(jointPass)) {
            passJoints(run, [&] { joints.solve(bodies, jointPass); });
        }
        revolutes_.solve(bodies, jointPass);
    };
    solveJoints(true);
    addPhase(run, {passes.solve, settings});
    addPhase(run, {.work = &SoftSolver::move});
    revolutes_.rotate(bodies);
    solveJoints(false);
    PassSettings relax = settings;
    relax.kept = first ? Real(0) : Real(1);
    relax.left = static_cast<Real>(substeps - substep);
    addPhase(run, {passes.relax, relax});
}

void SoftSolver::runSubsteps(Substeps& run, int substeps) {
    phases_.clear();
    for (int substep = 0; substep < substeps; ++substep) {
        runSubstep(run, substep, substeps);
    }
    if (!run.helpers.alone()) {
        runPhases(run);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
