// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collision_record.hpp>
#include <kodo/settings.hpp>

#include <vector>

#include "lanes/contact_lane.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// True if a contact that is not in the passes touched in this step.
bool touches(const Contact& contact, const ContactLane& lane, const Tolerances& tolerances);

/// Ends a step for one contact: sets its touch state and phase.
void finishContact(Contact& contact, bool touches);

/// Appends the record of a finished contact, if it has a phase. `turned`: see StepRecords::turned.
void recordContact(const StoredContact& contact, std::vector<CollisionRecord>& out,
                   Vec2 turned = {});

/// End record of a contact that has stopped touching.
CollisionRecord endOf(const Contact& contact);

} // namespace KODO_PRECISION
} // namespace kodo
