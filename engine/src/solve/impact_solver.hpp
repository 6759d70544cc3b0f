// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "contacts/contact_set.hpp"
#include "solve/contact_blocks.hpp"

#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Impacts with restitution: the collision phase of the step. It uses the velocities before any
/// force acts in the step [Guendelman03; Thesis06, 4.2.2.1]. Bodies at rest have no velocity then,
/// so no speed threshold is needed to end bouncing, and slow impacts are as exact as fast ones.
///
/// Contacts that touch and approach are solved one after the other,
///
///   J = -(1 + e) v_n / (1/m_n),  only while v_n < 0               [Thesis06, eq. 4.9]
///
/// in repeated passes until none approaches. This propagates an impact impulse through a row of
/// bodies and conserves energy for e = 1. Contacts without restitution are solved once, so that
/// soft contacts need not absorb the impact. Both points of a contact are solved at once. An
/// approach that forces alone cause within one step is left to the contact solver, since it belongs
/// to a contact at rest.
class ImpactSolver {
public:
    struct Step {
        const StepSettings& settings;
        const Tolerances& tolerances;
        Real dt; // s
        WorkerTeam& team;
    };

    void solve(Bodies& bodies, ContactSet& contactSet, const ContactBlocks& blocks,
               const Step& step);

private:
    struct Inputs {
        Bodies& bodies;
        ContactSet& contactSet;
        const ContactBlocks& blocks;
        const Step& step;
    };
    bool solveContact(const Inputs& inputs, std::uint32_t slot);

    std::vector<std::uint8_t> wasHit_;    // by body, in this step
    std::vector<std::uint32_t> bouncing_; // slots of contacts with restitution, in order
};

/// Applies one impact impulse to a contact that touches and approaches, and adds it to
/// PointImpulse::impact. True if it did.
bool solveImpact(Bodies& bodies, Contact& contact, const StepSettings& settings,
                 const Tolerances& tolerances, Real dt);

} // namespace KODO_PRECISION
} // namespace kodo
