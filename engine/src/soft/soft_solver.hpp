// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "bodies/integrate.hpp"
#include "joints/step_input.hpp"

#include <array>
#include <span>
#include <vector>

#include "impacts/departure.hpp"
#include "impacts/impact_solver.hpp"
#include "lanes/block_partitions.hpp"
#include "lanes/contact_blocks.hpp"
#include "soft/load_release.hpp"
#include "soft/manifold_refresh.hpp"
#include "soft/refinement.hpp"
#include "soft/revolute_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Impacts, then contacts and joints in substeps [Catto24]. Each substep integrates the forces and
/// warm starts with the impulses of the substep before. A biased pass separates overlaps as soft
/// contacts, and the bodies move. A relax pass without bias then removes the velocity that the bias
/// added; deep overlaps get more relax passes. Large mass ratios and very large forces divide the
/// substeps of their islands further; see Refinement.
///
///   lambda = -m (s v_n + bias) - c lambda_sum,  lambda_sum >= 0;  |friction| <= mu lambda_sum
///
/// The sums are clamped, not the increments. So a later pass may take back what an earlier one
/// overdid, and friction depends neither on restitution nor on the number of passes.
///
/// Contact arms are fixed for the step. So the contact impulses of a substep change the velocity of
/// a body by the same amount in the next one. Warm starting applies that change body by body; only
/// the first substep sums it over the contacts.
class SoftSolver {
public:
    /// Sizes the arrays by body, so that no first use costs a step as much as all bodies.
    void makeRoom(const Bodies& bodies);
    void solve(const StepInput& step);

private:
    using Velocity = LoadRelease::Velocity;

    /// What is solved with substeps of one length: the islands of one level of Refinement.
    struct Group {
        std::vector<std::uint32_t>
            bound; // awake bodies with contacts or joints, and kinematic ones
        BlockPartitions partitions;
    };
    /// Inputs of all substeps of a group.
    struct Substeps : StepInput {
        std::uint32_t level;
        ContactPassArguments pass;
        JointPass& jointPass;
        Real pushSpeed; // m/s
        WorkerTeam& helpers;
    };
    /// A part of a substep: a pass over all blocks, or work on all bodies of the group.
    struct Phase {
        ContactPasses::Pass pass = nullptr;
        PassSettings settings{};
        void (SoftSolver::*work)(Bodies& bodies, std::span<const std::uint32_t> list,
                                 Real h) = nullptr;
        std::uint32_t firstPhase = 0; // number in WorkerTeam::inPhases
    };

    void collect(const StepInput& step);
    void findDepartures(const StepInput& step);
    void collectPiece(const StepInput& step, std::span<const std::uint32_t> places,
                      std::vector<std::uint32_t>& newcomers);
    void markExposure(const StepInput& step, std::uint32_t place, bool leaves);
    void clearOverlapCounts(ContactSet& contactSet);
    void clearMarks(const Bodies& bodies, const JointSet& joints);
    void beginCollecting(const StepInput& step);
    void takeNewcomer(const Bodies& bodies, ContactSet& contactSet, std::uint32_t place,
                      bool friction, std::vector<std::uint32_t>& newcomers);
    void refine(const Bodies& bodies, ContactSet& contactSet);
    void countOverlap(const Bodies& bodies, const ContactSummary& summary, const WorkerTeam& team);
    void limitOverlaps(Bodies& bodies, ContactSet& contactSet);
    void findJointed(const JointSet& joints);
    void solveHeld(const StepInput& step);
    bool noneNeedsRow(const Bodies& bodies, ContactSet& contactSet, const StepSettings& settings,
                      const Tolerances& tolerances);
    void moveFree(Bodies& bodies, Real dt);
    void solveGroup(const StepInput& step, std::uint32_t level);
    void splitGroups(const Bodies& bodies);
    void moveKinematic(Bodies& bodies, Real dt);
    template <typename Pass>
    void passJoints(Substeps& run, Pass pass);
    void runSubsteps(Substeps& run, int substeps);
    void runSubstep(Substeps& run, int substep, int substeps);
    void preparePasses(Substeps& run);
    void refreshManifolds(Substeps& run, bool first);
    void releaseLoads(Substeps& run);
    void beginVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h);
    void nextVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h);
    void move(Bodies& bodies, std::span<const std::uint32_t> list, Real h);
    void addPhase(Substeps& run, const Phase& phase);
    void runPhases(Substeps& run);

    ImpactSolver impacts_;
    Refinement refinement_;
    std::array<Group, Refinement::kLevels> groups_; // by level
    RevoluteBlocks revolutes_;
    LoadRelease loadRelease_;
    ManifoldRefresh manifoldRefresh_;
    std::vector<Phase> phases_;            // queued for the worker team
    std::vector<std::uint32_t> newcomers_; // indices of contacts that need a lane
    ParallelCollector<std::uint32_t> found_;
    std::vector<Departure> departures_;     // by slot, of contacts with restitution
    std::vector<ContactExposure> exposure_; // by body
    std::vector<std::uint8_t> near_;        // by body: marks that determine exposure_
    std::vector<std::uint8_t> touched_;
    std::vector<std::uint16_t> overlapCount_; // by body: number of overlaps beyond four slops
    std::uint8_t anyCrowded_ = 0;             // some body has too many of these
    std::vector<Velocity> before_;    // by body: with the forces of the substep, without contacts
    std::vector<std::uint32_t> free_; // bodies without contacts and joints in this step
    std::vector<std::uint32_t> kinematic_; // moving kinematic bodies with contacts or joints
    std::vector<std::uint32_t> jointed_;   // bodies in order; index the next two
    std::vector<Velocity> fromJoints_;     // velocity change in this substep
    std::vector<Velocity> beforeJoints_;   // velocity before a pass over the joints
};

} // namespace KODO_PRECISION
} // namespace kodo
