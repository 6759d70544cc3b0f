// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/contacts/contact.hpp>
#include <kodo/solve/contact_block.hpp>

namespace kodo::inline KODO_PRECISION {

/// Writes all that the passes need of a contact into a lane, but for its bodies. The impulses are
/// those that it kept, for so many parts of a substep; what its step sums up begins at 0.
void fillLane(ContactBlock& block, std::size_t lane, const Bodies& bodies, const Contact& contact,
              Real pushSpeed, Real parts);

/// A rolling body is braked with a torque of at most resistance * radius * normal force, where the
/// radius is the distance from its centre to the contact [Thesis06, 4.3.3].
void fillLane(RollingBlock& block, std::size_t lane, const Bodies& bodies, const Contact& contact,
              Real parts);

/// Hands the impulses of a lane back to its contact, which are `parts` times as large there: those
/// that the next step starts from, and what the last one pushed.
void readImpulses(const ContactBlock& block, std::size_t lane, Contact& contact, Real parts);
void readBlows(const ContactBlock& block, std::size_t lane, Contact& contact, Real parts);

/// A lane that pushes nobody.
void clearLane(ContactBlock& block, std::size_t lane);

} // namespace kodo::inline KODO_PRECISION
