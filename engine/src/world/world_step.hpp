// SPDX-License-Identifier: MIT
#pragma once

#include "world/world_impl.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// One step of a World: what it reads and writes, and its stages.
class WorldStep : StepInput {
public:
    /// The list of awake bodies must be up to date: see WorldImpl::updateAwake.
    WorldStep(WorldImpl& world, const StepInput& input) : StepInput(input), world_(world) {}
    /// All stages. The listener, if any, has entered the first one.
    void run(StageListener* listener);

private:
    void forAwake(void (*move)(Bodies&, std::span<const std::uint32_t>));
    void makeRoom();
    void wakeIslands(bool arrivals);
    void gatherForces();
    void solve();
    // A solver that is left out does not compile.
    SoftSolver& solverOf(const SoftSettings&) { return world_.softSolver_; }
    Propagation& solverOf(const PropagationSettings&) { return world_.propagation_; }
    void runContinuous();
    void finishMoves();
    void recordCollisions();
    void breakJoints();
    void freezeUnsoundForces();
    /// True if any body is awake while an island sleeps.
    bool canWake() const { return world_.sleep_.anyAsleep() && !bodies.awake.empty(); }
    bool allSound();
    void freezeUnsoundMotion();

    WorldImpl& world_;
};

} // namespace KODO_PRECISION
} // namespace kodo
