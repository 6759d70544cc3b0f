// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/solve/contact_blocks.hpp>
#include <kodo/solve/settings.hpp>

#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Lets bodies hit each other: the collision half of the step, with the velocities from before any
/// force acts in it [Guendelman03; Thesis06, 4.2.2.1]. What rests has no velocity then, so nothing
/// needs a threshold in m/s to stop bouncing, and a slow hit bounces as exactly as a fast one.
///
/// Contacts that touch and approach are hit one after the other,
///
///   J = -(1 + e) v_n / (1/m_n),  only while v_n < 0               [Thesis06, eq. 4.9]
///
/// again and again until none approaches, which passes a blow on through a row of bodies and
/// neither makes nor loses energy for e = 1. Those without restitution are hit once, so that the
/// blow is not left to springs. Two points of one contact are hit at once. An approach that the
/// forces alone cause within one step is left to the contact half, since it is rest.
class ImpactStage {
public:
    struct Step {
        const StepSettings& settings;
        const Tolerances& tolerances;
        Real dt; // s
        Crew& crew;
    };

    void solve(Bodies& bodies, ContactSet& contactSet, const ContactBlocks& blocks,
               const Step& step);

private:
    std::vector<std::uint8_t> wasHit_; // by body, in this step
};

/// Hits one contact once, if it touches and approaches. True if it did. Adds to what the
/// contact counts as impact.
bool solveImpact(Bodies& bodies, Contact& contact, const StepSettings& settings,
                 const Tolerances& tolerances, Real dt);

} // namespace kodo::inline KODO_PRECISION
