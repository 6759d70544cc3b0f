// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collision_record.hpp>
#include <kodo/settings.hpp>

#include <span>
#include <vector>

#include "lanes/contact_lane.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// True if a contact that is not in the passes touched in this step.
bool touches(const Contact& contact, const ContactLane& lane, const Tolerances& tolerances);

/// Ends a step for one contact: sets its touch state and phase.
void finishContact(Contact& contact, bool touches);

/// Appends the record of a finished contact, if it has a phase.
void recordContact(const StoredContact& contact, std::vector<CollisionRecord>& out);

/// Sorts records by bodies and parts; of one pair, End comes before Begin.
void sortRecords(std::vector<CollisionRecord>& records);

/// Merges records of removed contacts into those of a step, in order.
void addInOrder(std::span<const CollisionRecord> more, std::vector<CollisionRecord>& records);

/// End record of a contact that has stopped touching.
CollisionRecord endOf(const Contact& contact);

} // namespace KODO_PRECISION
} // namespace kodo
