// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "contacts/contact.hpp"

#include "lanes/contact_block.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Values common to the lanes of a block.
struct LaneRules {
    Real pushSpeed; // m/s
    Real parts;     // of a substep
    Shared shared;
};

/// Writes the coefficients of a contact into a lane, except its bodies. The impulses are those of
/// the contact divided by the parts of a substep. The sums of the step start at 0.
void fillLane(ContactBlock& block, std::size_t lane, const Bodies& bodies, const Contact& contact,
              const LaneRules& rules);

/// Rolling resistance is a torque of at most resistance * radius * normal force. The radius is the
/// distance from the centre of the body to the contact [Thesis06, 4.3.3].
void fillLane(RollingBlock& block, std::size_t lane, const Bodies& bodies, const Contact& contact,
              const LaneRules& rules);

/// Write the impulses of a lane back to its contact, times `parts`. The first function writes those
/// for the warm start of the next step, the second those of the last step.
void readImpulses(const ContactBlock& block, std::size_t lane, Contact& contact, Real parts);
void readImpactImpulses(const ContactBlock& block, std::size_t lane, Contact& contact, Real parts);

/// Resets a lane so that it applies no impulse.
void clearLane(ContactBlock& block, std::size_t lane);

} // namespace KODO_PRECISION
} // namespace kodo
