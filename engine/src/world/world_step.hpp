// SPDX-License-Identifier: MIT
#pragma once

#include "world/world_impl.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// One step of a World: what it reads and writes, and its stages.
class WorldStep {
public:
    /// The list of awake bodies must be up to date: see WorldImpl::updateAwake.
    WorldStep(WorldImpl& world, Real dt, Executor* executor);
    /// All stages. The listener, if any, has entered the first one.
    void run(StageListener* listener);

private:
    void forAwake(void (*work)(Bodies&, std::span<const std::uint32_t>));
    void makeRoom();
    void wakeIslands(bool arrivals);
    bool updateAwake();
    void gatherForces();
    void solve(const StepInput& input);
    void runContinuous(const StepInput& input);
    void finishMoves();
    void recordCollisions();
    void breakJoints();
    void freezeUnsoundForces();
    /// True if any body is awake while an island sleeps.
    bool canWake() const { return sleep_.anyAsleep() && !bodies_.awake.empty(); }
    bool allSound();
    void freezeUnsoundMotion();

    const StepSettings& settings_;
    const Tolerances& tolerances_;
    const std::vector<FieldEntry>& fields_;
    Bodies& bodies_;
    ContactSet& contacts_;
    JointSet& joints_;
    SleepSystem& sleep_;
    Region& region_;
    ImpactSolver& impacts_;
    SoftSolver& softSolver_;
    Propagation& propagation_;
    ContinuousCollision& continuous_;
    std::vector<BrokenJoint>& broken_;
    std::vector<BodyId>& frozen_;
    std::size_t& roomFor_;
    std::size_t& contactVisits_;
    std::uint64_t stepCount_;
    Real dt_;
    WorkerTeam team_;
};

} // namespace KODO_PRECISION
} // namespace kodo
