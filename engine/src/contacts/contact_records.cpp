// SPDX-License-Identifier: MIT
// ContactSet: records of the last step, written from the contacts when they are read.
#include "contacts/contact_set.hpp"

#include <algorithm>
#include <iterator>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Appends the record of a contact with its state written back.
void append(Contact copy, const WriteBack& writeBack, std::vector<CollisionRecord>& out) {
    writeBack(copy);
    recordContact(copy, out);
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

/// Must be called before a contact that is not resident changes its key.
void ContactSet::writeRecords() const {
    records([](Contact&) {});
}

/// Appends the records of the last step for which accept(record) is true, in order. `find(out)`
/// appends those of contacts in the list; it is not called if all records are written.
template <typename Find, typename Accept>
void ContactSet::select(Find find, Accept accept, std::vector<CollisionRecord>& out) const {
    if (!records_.allDue) {
        appendIf(records_.all, out, accept);
        return;
    }
    find(out);
    std::erase_if(out, std::not_fn(accept));
    appendIf(records_.removed, out, accept);
    appendIf(records_.ends, out, accept);
    sortRecords(out);
}

/// Writes the lists of begins and ends.
void ContactSet::writeEvents(const WriteBack& writeBack) const {
    if (!std::exchange(records_.eventsDue, false)) {
        return;
    }
    // First both in `begun`.
    select(
        [&](std::vector<CollisionRecord>& out) {
            for (const std::uint32_t slot : records_.turned) {
                append(contacts_[slot], writeBack, out);
            }
        },
        [](const CollisionRecord& record) { return record.phase != TouchPhase::Persist; },
        records_.begun);
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
    std::vector<CollisionRecord> hits;
    select(
        [&](std::vector<CollisionRecord>& out) {
            if (fastestApproach_ < minSpeed) {
                return;
            }
            for (std::size_t slot = 0; slot < summaries_.size(); ++slot) {
                if (summaries_[slot].approachSpeed >= minSpeed && contacts_[slot].phase) {
                    append(contacts_[slot], writeBack, out);
                }
            }
        },
        [=](const CollisionRecord& record) {
            return record.maxImpulse > 0 && record.approachSpeed >= minSpeed;
        },
        hits);
    return hits;
}

std::vector<CollisionRecord> ContactSet::recordsOf(BodyId body, const WriteBack& writeBack) const {
    std::vector<CollisionRecord> records;
    select(
        [&](std::vector<CollisionRecord>& out) {
            lists().forEach(body.index,
                            [&](std::uint32_t slot) { append(contacts_[slot], writeBack, out); });
        },
        [=](const CollisionRecord& record) { return record.involves(body); }, records);
    return records;
}

} // namespace KODO_PRECISION
} // namespace kodo
