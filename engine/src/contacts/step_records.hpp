// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collision_record.hpp>

#include "contacts/contact.hpp"
#include "contacts/contact_report.hpp"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Writes the state of a resident contact back to the contact, or to a copy of it.
using WriteBack = std::function<void(Contact&)>;

/// Records of the last step. A step only notes what began and ended; the records are written when
/// they are first read. `begun` and `ended` then cost what began and ended, `all` costs all
/// touching contacts. All lists are in the order of bodies and parts.
struct StepRecords {
    bool allDue = false;    // `all` is not written yet; it follows from the contacts
    bool eventsDue = false; // `begun` and `ended` are not written yet

    std::vector<std::uint32_t> toggled; // slots of contacts that began or ended in the last step
    std::vector<CollisionRecord> all;
    std::vector<CollisionRecord> begun;
    std::vector<CollisionRecord> ended;
    std::vector<CollisionRecord> removed;  // of contacts removed since the step, while allDue
    std::vector<CollisionRecord> ends;     // End records of contacts removed by or before the step
    std::vector<CollisionRecord> nextEnds; // End records of contacts removed since
    std::vector<std::uint32_t> slots;      // scratch: of contacts whose records are written

    /// Starts a step: lists that were not read until now are not written any more.
    void begin() {
        allDue = false;
        eventsDue = false;
        toggled.clear();
        removed.clear();
    }
    void finish(bool enabled) {
        for (std::vector<CollisionRecord>* list : {&all, &begun, &ended, &ends}) {
            list->clear();
        }
        if (!nextEnds.empty()) {
            std::swap(nextEnds, ends);
            nextEnds.reserve(ends.capacity()); // the two vectors alternate
        }
        allDue = enabled;
        eventsDue = enabled;
    }
    /// Keeps the record of a contact that is about to be removed. It must not be resident.
    void keep(const Contact& contact) {
        if (allDue) {
            recordContact(contact, removed);
        }
    }
};

} // namespace KODO_PRECISION
} // namespace kodo
