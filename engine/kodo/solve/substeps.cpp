// SPDX-License-Identifier: MIT
// What the soft step does in its substeps, alone or with help.
#include <kodo/bodies/integrate.hpp>
#include <kodo/solve/soft_step.hpp>

#include <algorithm>
#include <iterator>

namespace kodo::inline KODO_PRECISION {

/// Forces begin to act.
void SoftStep::beginVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    integrateVelocities(bodies, list, h);
    for (const std::uint32_t i : list) {
        before_[i].speeds = speeds(bodies.motion[i]);
    }
}

/// From one substep to the next, which begins with the forces and with what the contacts gave.
void SoftStep::nextVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    const Four time{h, h, h, 0};
    for (const std::uint32_t i : list) {
        Four& speed = speeds(bodies.motion[i]);
        Four& before = before_[i].speeds;
        const Four gained = speed - before;
        before = speed + time * rates(bodies.acceleration[i]);
        speed = before + gained;
    }
}

void SoftStep::move(Bodies& bodies, std::span<const std::uint32_t> list, Real h) {
    integrateMoves(bodies, list, holds_, h);
}

/// Runs a phase at once, or with helpers as one of many that follow each other. What is locked and
/// moves is read by contacts of every share, and what joints hold is pushed by the caller alone, so
/// where there are such bodies the helpers wait after each phase.
void SoftStep::addPhase(Substeps& run, const Phase& phase) {
    if (run.crew.alone()) {
        if (phase.pass != nullptr) {
            ContactPassArguments pass = run.pass;
            pass.settings = phase.settings;
            phase.pass(pass);
        } else {
            (this->*phase.work)(run.bodies, bound_, run.jointPass.h);
        }
        return;
    }
    phases_.push_back(phase);
    if (run.bodies.loads.driven || !jointed_.empty() || !pins_.empty()) {
        runPhases(run);
    }
}

/// Runs what was put off. Each share works on its own bodies, in an even turn, since those that are
/// common must have got their pushes before; and each colour of a pass takes two turns.
void SoftStep::runPhases(Substeps& run) {
    std::uint32_t turns = 0;
    for (Phase& phase : phases_) {
        phase.turn = turns;
        turns += phase.pass != nullptr ? 2 * shares_.colours() : 2;
    }
    run.crew.inTurns(turns, [&](std::uint32_t share, std::uint32_t turn) {
        const Phase& phase = *std::prev(
            std::upper_bound(phases_.begin(), phases_.end(), turn,
                             [](std::uint32_t at, const Phase& p) { return at < p.turn; }));
        const bool even = turn % 2 == 0;
        if (phase.pass != nullptr) {
            const auto blocks = shares_.blocks(share, (turn - phase.turn) / 2, !even);
            ContactPassArguments pass = run.pass;
            pass.settings = phase.settings;
            pass.order = blocks.data();
            pass.count = blocks.size();
            phase.pass(pass);
        } else if (even) {
            const auto [first, count] = shares_.bodies(share);
            (this->*phase.work)(run.bodies,
                                std::span<const std::uint32_t>(bound_).subspan(first, count),
                                run.jointPass.h);
        }
    });
    phases_.clear();
}

/// Runs a pass over the joints and adds up what it gives to their bodies.
template <typename Pass>
void SoftStep::passJoints(Substeps& run, Pass pass) {
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

/// The passes that take the speed of deep pushes out again: as a rule few, so the caller makes them
/// alone.
void SoftStep::settle(Substeps& run) {
    if (!settling_.empty()) {
        runPhases(run);
        settling_.settle(run.pass);
    }
}

/// The arms of joints do turn within a step, so they start from their own impulses in each substep,
/// and what they gave in the last one does not count as what the contacts gave. With lent pins,
/// which are springs, it does: by how little their arms turn in one substep, the next pass mends.
void SoftStep::runSubstep(Substeps& run, bool first) {
    const ContactPasses& passes = ContactPasses::best();
    Bodies& bodies = run.bodies;
    JointSet& joints = run.joints;
    JointPass& jointPass = run.jointPass;
    const PassSettings& settings = run.pass.settings;
    if (first) {
        before_.resize(bodies.size());
        std::fill(fromJoints_.begin(), fromJoints_.end(), Velocity{});
    }
    for (std::size_t k = 0; k < jointed_.size() && !first; ++k) {
        before_[jointed_[k]].speeds += fromJoints_[k].speeds;
        fromJoints_[k] = {};
    }
    addPhase(run, {.work = first ? &SoftStep::beginVelocities : &SoftStep::nextVelocities});
    passJoints(run, [&] { joints.warmStart(bodies, jointPass); });
    if (first) {
        pins_.warmStart(bodies, jointPass);
        addPhase(run, {passes.warmStart, settings});
    }
    const auto solveJoints = [&](bool biased) {
        jointPass.biased = biased;
        passJoints(run, [&] { joints.solve(bodies, jointPass); });
        pins_.solve(bodies, jointPass);
    };
    solveJoints(true);
    addPhase(run, {passes.solve, settings});
    addPhase(run, {.work = &SoftStep::move});
    pins_.turn(bodies);
    solveJoints(false);
    settle(run);
    PassSettings relax = settings;
    relax.kept = first ? Real(0) : Real(1);
    addPhase(run, {passes.relax, relax});
}

void SoftStep::runSubsteps(Substeps& run, int substeps) {
    phases_.clear();
    for (int substep = 0; substep < substeps; ++substep) {
        runSubstep(run, substep == 0);
    }
    if (!run.crew.alone()) {
        runPhases(run);
    }
}

} // namespace kodo::inline KODO_PRECISION
