// SPDX-License-Identifier: MIT
#pragma once

#include "base/disjoint_sets.hpp"
#include "bodies/bodies.hpp"
#include "joints/step_input.hpp"

#include <utility>
#include <vector>

#include "impacts/impact.hpp"
#include "impacts/simultaneous_impacts.hpp"
#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Impacts with restitution: the collision phase of the step. It uses the velocities before any
/// force acts in the step [Guendelman03; Thesis06, 4.2.2.1]. Bodies at rest have no velocity then,
/// so no speed threshold is needed to end bouncing, and slow impacts are as exact as fast ones.
///
/// Rounds of simultaneous impacts follow each other until no contact approaches. In a round all
/// contacts that touch and approach are hit at once. One that shares no body with another gets
///
///   J = -(1 + e) v_n / (1/m_n)                                    [Thesis06, eq. 4.9]
///
/// and the others see SimultaneousImpacts. So an impulse passes through a row of bodies, energy is
/// conserved for e = 1, and the result does not depend on the order of contacts: a symmetric scene
/// stays symmetric. A pass solves each contact at most once. Contacts without restitution take part
/// in the first pass alone, so that soft contacts need not absorb the impact. An approach that
/// forces alone cause within one step is left to the contact solver, since it belongs to a contact
/// at rest.
class ImpactSolver {
public:
    /// Sizes the arrays by body, so that no first use costs a step as much as all bodies.
    void makeRoom(const Bodies& bodies) {
        resizeByBody(lastHit_, bodies); // all 0 between steps
        sets_.reserve(bodies.record.capacity());
        sets_.resize(bodies.size());
    }
    void solve(const StepInput& step);

private:
    struct Inputs : StepInput {
        Real restSpeed; // m/s; no slower contact has an impact
    };
    /// A contact that may have an impact in this step, and the results of its rounds.
    struct Candidate {
        std::uint32_t slot;
        std::uint32_t bodyA;
        std::uint32_t bodyB;
        std::uint32_t lastPass = 0; // that solved it; 0: none
        // Of the last check; 0: none since it was solved. From the beginning 1 if it was slow, as
        // measured before the solver.
        std::uint32_t round;
        bool approaches = false; // in that check
        bool bounces;
    };
    static bool wasFast(const Inputs& inputs, std::uint32_t slot);
    static Impact impactOf(const Inputs& inputs, std::uint32_t slot);
    void listCandidates(const Inputs& inputs);
    bool approachesNow(const Inputs& inputs, Candidate& candidate) const;
    bool solvePass(const Inputs& inputs, std::uint32_t pass);
    void solveRound(const Inputs& inputs, std::uint32_t pass);
    void solveGroup(const Inputs& inputs);

    std::uint32_t round_ = 0;                // in this step, from 1 on
    std::vector<std::uint32_t> lastHit_;     // by body: the last round that hit it; 0: none
    std::vector<std::uint32_t> hitBodies_;   // of this step
    std::vector<Candidate> candidates_;      // in the order of keys
    std::vector<std::uint32_t> approaching_; // of this round: indices of candidates, in order
    std::vector<std::pair<std::uint32_t, std::uint32_t>> grouped_; // root; candidate
    std::vector<std::uint32_t> group_;                             // slots that are solved together
    std::vector<Impact> hits_;                                     // the same contacts
    DisjointSets sets_;                                            // of movable bodies
    SimultaneousImpacts together_;
};

/// Applies one impact impulse to a contact that touches and approaches, and adds it to
/// ContactLane::impact. True if it did.
bool solveImpact(Bodies& bodies, Contact& contact, const ContactLane& lane,
                 const StepSettings& settings, const Tolerances& tolerances, Real dt);

} // namespace KODO_PRECISION
} // namespace kodo
