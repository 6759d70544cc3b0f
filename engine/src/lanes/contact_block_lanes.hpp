// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include "lanes/contact.hpp"
#include "lanes/contact_block.hpp"
#include "lanes/contact_lane.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Values common to the lanes of a block.
struct LaneRules {
    Real pushSpeed; // m/s
    bool rolling;   // Feature::RollingResistance is on
};

/// Writes the coefficients of a contact into its lane, except its bodies. The sums of the step
/// start at 0.
void fillLane(ContactBlock& block, std::size_t lane, const Bodies& bodies, const Contact& contact,
              const LaneRules& rules);

/// Rolling resistance is a torque of at most resistance * radius * normal force. The radius is the
/// distance from the centre of the body to the contact [Thesis06, 4.3.3].
void fillLane(SurfaceBlock& surface, ContactBlock& block, std::size_t lane, const Bodies& bodies,
              const Contact& contact, const LaneRules& rules);

/// Applies a share of the impulses of a contact in the passes to its bodies.
void applyImpulses(Bodies& bodies, const ContactLanes::Place& at, Real share);
/// Resets a lane so that it applies no impulse.
void clearLane(ContactBlock& block, std::size_t lane);

} // namespace KODO_PRECISION
} // namespace kodo
