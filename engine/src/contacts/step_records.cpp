// SPDX-License-Identifier: MIT
#include "contacts/step_records.hpp"

#include "base/vector_reuse.hpp"
#include "contacts/contact_report.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <tuple>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

template <typename Accept>
void appendIf(std::span<const CollisionRecord> records, std::vector<CollisionRecord>& out,
              Accept accept) {
    std::copy_if(records.begin(), records.end(), std::back_inserter(out), accept);
}

/// By bodies and parts; of one pair, End comes before Begin.
bool isBefore(const CollisionRecord& first, const CollisionRecord& second) {
    const auto key = [](const CollisionRecord& r) {
        return std::make_tuple(r.a, r.partA, r.b, r.partB, r.phase != TouchPhase::End);
    };
    return key(first) < key(second);
}

} // namespace

void StepRecords::begin() {
    allDue_ = false;
    eventsDue_ = false;
    toggled_.clear();
    turned_.clear();
    removed_.clear();
}

void StepRecords::finish(bool enabled) {
    for (std::vector<CollisionRecord>* list : {&all_, &begun_, &ended_, &ends_}) {
        list->clear();
    }
    if (!nextEnds_.empty()) {
        std::swap(nextEnds_, ends_);
        nextEnds_.reserve(ends_.capacity()); // the two vectors alternate
    }
    allDue_ = enabled;
    eventsDue_ = enabled;
}

void StepRecords::keep(const StoredContact& contact) {
    if (allDue_) {
        write(contact, removed_);
    }
}

void StepRecords::turned(const ContactKey& key, Vec2 less) {
    if (less != Vec2{}) {
        auto at = std::lower_bound(turned_.begin(), turned_.end(), Turned{key, less});
        if (at == turned_.end() || at->key != key) {
            at = turned_.insert(at, {key, {}});
        }
        at->less += less;
    }
}

/// Appends the record of a finished contact, if it has a phase.
void StepRecords::write(const StoredContact& contact, std::vector<CollisionRecord>& out) const {
    const auto at = std::lower_bound(turned_.begin(), turned_.end(), Turned{contact.key, {}});
    const bool found = at != turned_.end() && at->key == contact.key;
    recordContact(contact, out, found ? at->less : Vec2{});
}

void StepRecords::addEnd(const Contact& contact) {
    nextEnds_.push_back(endOf(contact));
}

std::span<const CollisionRecord> StepRecords::all(const Source& source) {
    if (allDue_) {
        list(source, all_);
        allDue_ = false;
    }
    return all_;
}

/// Appends all records, which are due.
void StepRecords::list(const Source& source, std::vector<CollisionRecord>& records) {
    const auto findAll = [&](std::vector<std::uint32_t>& slots) {
        source.store.forEachInOrder([&](std::uint32_t slot) {
            if (source.store.contacts()[slot].phase) {
                slots.push_back(slot);
            }
        });
    };
    select(
        findAll, [](const CollisionRecord&) { return true; }, source, records);
}

/// Appends the records of the last step for which accept(record) is true, in order. find(slots)
/// lists the contacts that may have one; it is not called if all records are written.
template <typename Find, typename Accept>
void StepRecords::select(Find find, Accept accept, const Source& source,
                         std::vector<CollisionRecord>& out) {
    if (!allDue_) {
        appendIf(all_, out, accept);
        return;
    }
    slots_.clear();
    find(slots_);
    const std::span<const Contact> contacts = source.store.contacts();
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return contacts[a].key < contacts[b].key;
    };
    if (!std::is_sorted(slots_.begin(), slots_.end(), before)) {
        std::sort(slots_.begin(), slots_.end(), before); // total order: keys are unique
    }
    reserveReusing(out, slots_.size());
    for (const std::uint32_t slot : slots_) {
        write(source.store.copyOf(slot, source.bodies), out);
    }
    std::erase_if(out, std::not_fn(accept));
    const std::size_t inOrder = out.size();
    appendIf(removed_, out, accept);
    appendIf(ends_, out, accept);
    if (out.size() > inOrder) {
        std::sort(out.begin(), out.end(), isBefore); // total order: a pair has End, Begin, or both
    }
}

/// Writes the lists of begins and ends.
void StepRecords::writeEvents(const Source& source) {
    if (!std::exchange(eventsDue_, false)) {
        return;
    }
    // First both in begun_.
    select([&](std::vector<std::uint32_t>& slots) { slots = toggled_; },
           [](const CollisionRecord& record) { return record.phase != TouchPhase::Persist; },
           source, begun_);
    const auto isEnd = [](const CollisionRecord& r) { return r.phase == TouchPhase::End; };
    appendIf(begun_, ended_, isEnd);
    std::erase_if(begun_, isEnd);
}

std::span<const CollisionRecord> StepRecords::begun(const Source& source) {
    writeEvents(source);
    return begun_;
}

std::span<const CollisionRecord> StepRecords::ended(const Source& source) {
    writeEvents(source);
    return ended_;
}

std::vector<CollisionRecord> StepRecords::hits(Real minSpeed, const Source& source) {
    const auto isHit = [=](const CollisionRecord& record) {
        return record.maxImpulse > 0 && record.approachSpeed >= minSpeed;
    };
    const auto findFast = [&](std::vector<std::uint32_t>& slots) {
        if (source.fastestApproach < minSpeed) {
            return;
        }
        const std::span<const ContactSummary> summaries = source.store.summaries();
        source.store.forEachInOrder([&](std::uint32_t slot) {
            if (summaries[slot].wasTouching && source.store.approachSpeed(slot) >= minSpeed) {
                slots.push_back(slot);
            }
        });
    };
    std::vector<CollisionRecord> hits;
    select(findFast, isHit, source, hits);
    return hits;
}

std::vector<CollisionRecord> StepRecords::of(BodyId body, const Source& source) {
    const auto findOwn = [&](std::vector<std::uint32_t>& slots) {
        source.store.lists().forEach(body.index,
                                     [&](std::uint32_t slot) { slots.push_back(slot); });
    };
    std::vector<CollisionRecord> records;
    select(
        findOwn, [=](const CollisionRecord& record) { return record.involves(body); }, source,
        records);
    return records;
}

} // namespace KODO_PRECISION
} // namespace kodo
