// SPDX-License-Identifier: MIT
// ContactSet: records of the last step, written from the contacts when they are read.
#include "contacts/contact_set.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Appends the record of a contact; of a resident one with its state written back to a copy.
void append(const Contact& contact, const WriteBack& writeBack, std::vector<CollisionRecord>& out) {
    if (contact.row.resident) {
        Contact copy = contact;
        writeBack(copy);
        recordContact(copy, out);
    } else {
        recordContact(contact, out);
    }
}

template <typename Accept>
void appendIf(std::span<const CollisionRecord> records, std::vector<CollisionRecord>& out,
              Accept accept) {
    std::copy_if(records.begin(), records.end(), std::back_inserter(out), accept);
}

} // namespace

std::span<const CollisionRecord> ContactSet::records(const WriteBack& writeBack) const {
    if (std::exchange(records_.allDue, false)) {
        records_.all.reserve(contacts_.capacity() + records_.removed.size() + records_.ends.size());
        forEachInOrder([&](std::uint32_t slot) {
            if (contacts_[slot].phase) {
                append(contacts_[slot], writeBack, records_.all);
            }
        });
        addInOrder(records_.removed, records_.all);
        addInOrder(records_.ends, records_.all);
    }
    return records_.all;
}

/// Must be called before contacts change their keys. No contact may be resident.
void ContactSet::writeRecords() const {
    records([](Contact&) {});
}

/// Appends the records of the last step for which accept(record) is true, in order. find(slots)
/// lists the contacts that may have one; it is not called if all records are written.
template <typename Find, typename Accept>
void ContactSet::select(Find find, Accept accept, const WriteBack& writeBack,
                        std::vector<CollisionRecord>& out) const {
    if (!records_.allDue) {
        appendIf(records_.all, out, accept);
        return;
    }
    std::vector<std::uint32_t>& slots = records_.slots;
    slots.clear();
    find(slots);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return contacts_[a].key < contacts_[b].key;
    };
    if (!std::is_sorted(slots.begin(), slots.end(), before)) {
        std::sort(slots.begin(), slots.end(), before); // total order: keys are unique
    }
    reserveReusing(out, slots.size());
    for (const std::uint32_t slot : slots) {
        append(contacts_[slot], writeBack, out);
    }
    std::erase_if(out, std::not_fn(accept));
    const std::size_t inOrder = out.size();
    appendIf(records_.removed, out, accept);
    appendIf(records_.ends, out, accept);
    if (out.size() > inOrder) {
        sortRecords(out);
    }
}

/// Writes the lists of begins and ends.
void ContactSet::writeEvents(const WriteBack& writeBack) const {
    if (!std::exchange(records_.eventsDue, false)) {
        return;
    }
    // First both in `begun`.
    select([&](std::vector<std::uint32_t>& slots) { slots = records_.toggled; },
           [](const CollisionRecord& record) { return record.phase != TouchPhase::Persist; },
           writeBack, records_.begun);
    const auto isEnd = [](const CollisionRecord& r) { return r.phase == TouchPhase::End; };
    appendIf(records_.begun, records_.ended, isEnd);
    std::erase_if(records_.begun, isEnd);
}

std::span<const CollisionRecord> ContactSet::begun(const WriteBack& writeBack) const {
    writeEvents(writeBack);
    return records_.begun;
}

std::span<const CollisionRecord> ContactSet::ended(const WriteBack& writeBack) const {
    writeEvents(writeBack);
    return records_.ended;
}

std::vector<CollisionRecord> ContactSet::hits(Real minSpeed, const WriteBack& writeBack) const {
    const auto isHit = [=](const CollisionRecord& record) {
        return record.maxImpulse > 0 && record.approachSpeed >= minSpeed;
    };
    const auto findFast = [&](std::vector<std::uint32_t>& slots) {
        if (fastestApproach_ < minSpeed) {
            return;
        }
        forEachInOrder([&](std::uint32_t slot) {
            const ContactSummary& summary = summaries_[slot];
            if (summary.approachSpeed >= minSpeed && summary.wasTouching) {
                slots.push_back(slot);
            }
        });
    };
    std::vector<CollisionRecord> hits;
    select(findFast, isHit, writeBack, hits);
    return hits;
}

std::vector<CollisionRecord> ContactSet::recordsOf(BodyId body, const WriteBack& writeBack) const {
    const auto findOwn = [&](std::vector<std::uint32_t>& slots) {
        lists().forEach(body.index, [&](std::uint32_t slot) { slots.push_back(slot); });
    };
    std::vector<CollisionRecord> records;
    select(
        findOwn, [=](const CollisionRecord& record) { return record.involves(body); }, writeBack,
        records);
    return records;
}

} // namespace KODO_PRECISION
} // namespace kodo
