// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/collision_record.hpp>
#include <kodo/contacts/contact.hpp>

#include <span>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Did two that have no lane in the solver touch in this step?
bool touches(const Contact& contact, const Tolerances& tolerances);

/// Ends a step for one contact: did it touch, and in which phase?
void finishContact(Contact& contact, bool touches);

/// Appends what a finished contact did in its step, if it did anything. Its impulses must not be
/// lent.
void recordContact(const Contact& contact, std::vector<CollisionRecord>& out);

/// Puts more records, of contacts that are gone, among those of a step, in order.
void addInOrder(std::span<const CollisionRecord> more, std::vector<CollisionRecord>& records);

/// The last record of a contact that touched and does so no more.
CollisionRecord endOf(const Contact& contact);

} // namespace kodo::inline KODO_PRECISION
