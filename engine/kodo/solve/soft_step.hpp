// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/crew.hpp>
#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/integrate.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/joints/joint_set.hpp>
#include <kodo/solve/block_shares.hpp>
#include <kodo/solve/contact_blocks.hpp>
#include <kodo/solve/pin_blocks.hpp>
#include <kodo/solve/settings.hpp>
#include <kodo/solve/settling.hpp>

#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Contacts and joints, in substeps [Catto24]. Each moves velocities by the forces, starts
/// from the impulses of the substep before, makes one pass that pushes overlaps apart like stiff
/// springs, moves the bodies, and makes one pass without that push, which takes its speed out
/// again; more for those that overlap deeply. Substeps are divided while a weight presses on
/// something far lighter, or forces are very large.
///
///   lambda = -m (s v_n + bias) - c lambda_sum,  lambda_sum >= 0;  |friction| <= mu lambda_sum
///
/// The sums are clamped, not the increments, so a later pass may take back what an earlier one
/// overdid, and friction depends neither on restitution nor on the number of passes.
///
/// Arms are fixed for the step, so the contact impulses of a substep change the velocity of a body
/// by as much as they would in the next: it starts from that change, body by body, and only the
/// first substep has to add it up from the contacts.
class SoftStep {
public:
    struct Step {
        const StepSettings& settings;
        const Tolerances& tolerances;
        Real dt; // s
        Crew& crew;
    };

    void solve(Bodies& bodies, ContactSet& contactSet, JointSet& joints, const Step& step);
    /// How often the last step looked at a contact.
    std::size_t visits() const { return visits_; }
    /// Whom contacts are lent to between two steps.
    const ContactBlocks& blocks() const { return blocks_; }
    ContactBlocks& blocks() { return blocks_; }

private:
    /// speeds() at some time, or a change of them; 1/mass goes along and never changes.
    struct Velocity {
        Four speeds{};
    };

    /// What all substeps of a step work on.
    struct Substeps {
        Bodies& bodies;
        JointSet& joints;
        const ContactPassArguments& pass;
        JointPass& jointPass;
        Crew& crew;
    };
    /// One part of a substep: a pass over all blocks, or else work on all bodies that can be
    /// pushed.
    struct Phase {
        ContactPasses::Pass pass = nullptr;
        PassSettings settings{};
        void (SoftStep::*work)(Bodies& bodies, std::span<const std::uint32_t> list,
                               Real h) = nullptr;
        std::uint32_t turn = 0; // its first; see Crew::inTurns
    };

    /// What collect() goes by.
    struct Collecting {
        const Bodies& bodies;
        ContactSet& contactSet;
        const Step& step;
    };

    void collect(const Bodies& bodies, ContactSet& contactSet, const JointSet& joints,
                 const Step& step);
    void collectPiece(const Collecting& run, std::span<const std::uint32_t> places,
                      std::vector<std::uint32_t>& newcomers);
    void noteHold(const Bodies& bodies, const ContactHead& head, Real slop, const Crew& crew);
    void clearMarks(const Bodies& bodies, const JointSet& joints);
    void beginCollecting(const Bodies& bodies, ContactSet& contactSet, const JointSet& joints,
                         const Step& step);
    void takeAnew(const Bodies& bodies, ContactSet& contactSet, std::uint32_t place, bool friction,
                  std::vector<std::uint32_t>& newcomers);
    void giveUpRow(const Bodies& bodies, ContactSet& contactSet, std::uint32_t place);
    void noteCrowd(const Bodies& bodies, const ContactHead& head, const Crew& crew);
    static int refinement(const Bodies& bodies, ContactSet& contactSet, Real hertz,
                          const Tolerances& tolerances);
    void findJointed(const JointSet& joints);
    void solveHeld(Bodies& bodies, ContactSet& contactSet, JointSet& joints, const Step& step);
    bool noneNeedsRow(const Bodies& bodies, ContactSet& contactSet, const StepSettings& settings,
                      const Tolerances& tolerances);
    void moveFree(Bodies& bodies, Real dt);
    template <typename Pass>
    void passJoints(Substeps& run, Pass pass);
    void runSubsteps(Substeps& run, int substeps);
    void runSubstep(Substeps& run, bool first);
    void settle(Substeps& run);
    void beginVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h);
    void nextVelocities(Bodies& bodies, std::span<const std::uint32_t> list, Real h);
    void move(Bodies& bodies, std::span<const std::uint32_t> list, Real h);
    void addPhase(Substeps& run, const Phase& phase);
    void runPhases(Substeps& run);

    ContactBlocks blocks_;
    BlockShares shares_;
    PinBlocks pins_;
    std::vector<Phase> phases_;            // that are yet to be run, by all threads
    std::vector<std::uint32_t> newcomers_; // places of contacts that have no lane yet
    Findings<std::uint32_t> found_;
    std::vector<Hold> holds_;        // by body
    std::vector<std::uint8_t> near_; // by body: marks, from which the holds follow
    std::vector<std::uint8_t> touched_;
    std::vector<std::uint16_t> crowd_; // by body: how many overlap it by four slops
    std::uint8_t crowded_ = 0;         // too many overlap some body
    std::uint8_t anyDeep_ = 0;         // some overlap so deeply that they must settle
    Settling settling_;
    std::size_t visits_ = 0;
    std::vector<Velocity> before_;     // by body: with the forces of the substep, without contacts
    std::vector<std::uint32_t> free_;  // bodies that nothing can push in this step
    std::vector<std::uint32_t> bound_; // and the others
    std::vector<std::uint32_t> jointed_; // bodies, in order; the next two are in the same order
    std::vector<Velocity> fromJoints_;   // in this substep
    std::vector<Velocity> beforeJoints_; // before a pass over the joints
};

} // namespace kodo::inline KODO_PRECISION
