// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collision_record.hpp>
#include <kodo/settings.hpp>

#include "contacts/contact_store.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Records of the last step. A step only notes what began and ended; the records are written when
/// they are first read. Lists of begins and ends then cost what began and ended, the list of all
/// costs all touching contacts. All lists are in the order of bodies and parts, and agree.
class StepRecords {
public:
    /// The contacts of the step.
    struct Source {
        const ContactStore& store;
        const Bodies& bodies;
        Real fastestApproach; // m/s
    };

    std::span<const CollisionRecord> all(const Source& source);
    std::span<const CollisionRecord> begun(const Source& source);
    std::span<const CollisionRecord> ended(const Source& source);
    /// Those with an impulse and an approach speed of at least minSpeed (m/s).
    std::vector<CollisionRecord> hits(Real minSpeed, const Source& source);
    std::vector<CollisionRecord> of(BodyId body, const Source& source);

    /// Starts a step: lists that were not read until now are not written any more.
    void begin();
    void finish(bool enabled);
    /// Keeps the record of a contact that is about to be removed.
    void keep(const StoredContact& contact);
    /// The normal of a contact with impulses changes within the step. `less`: their sums along the
    /// old normal minus those along the new one (N s).
    void turned(const ContactKey& key, Vec2 less);
    /// A touching contact was removed: it gets an End record in the next step.
    void addEnd(const Contact& contact);
    /// Slots of the contacts that began or ended in the last step.
    std::vector<std::uint32_t>& toggled() { return toggled_; }
    void visitState(StateStream& stream, const Source& source);

private:
    struct Turned {
        ContactKey key;
        Vec2 less; // N s
        bool operator<(const Turned& other) const { return key < other.key; }
    };
    void list(const Source& source, std::vector<CollisionRecord>& records);
    template <typename Find, typename Accept>
    void select(Find find, Accept accept, const Source& source, std::vector<CollisionRecord>& out);
    void writeEvents(const Source& source);
    void write(const StoredContact& contact, std::vector<CollisionRecord>& out) const;

    bool allDue_ = false;    // all_ is not written yet; it follows from the contacts
    bool eventsDue_ = false; // begun_ and ended_ are not written yet
    std::vector<std::uint32_t> toggled_;
    std::vector<Turned> turned_; // in the order of keys
    std::vector<CollisionRecord> all_;
    std::vector<CollisionRecord> begun_;
    std::vector<CollisionRecord> ended_;
    std::vector<CollisionRecord> removed_;  // of contacts removed since the step, while allDue_
    std::vector<CollisionRecord> ends_;     // End records of contacts removed by or before the step
    std::vector<CollisionRecord> nextEnds_; // End records of contacts removed since
    std::vector<std::uint32_t> slots_;      // scratch: of contacts whose records are written
};

} // namespace KODO_PRECISION
} // namespace kodo
