// SPDX-License-Identifier: MIT
#pragma once

#include "base/pair_lists.hpp"
#include "base/reorder_policy.hpp"
#include "base/worker_team.hpp"
#include "contacts/candidate_pairs.hpp"

#include <span>
#include <vector>

#include "lanes/contact_blocks.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Contacts by slot, their order by key, and the contacts of each body. A slot stays valid until
/// freeDetached(), merge(), sort() or order().
class ContactStore {
public:
    std::size_t size() const { return contacts_.size(); }
    std::size_t capacity() const { return contacts_.capacity(); }
    std::span<Contact> contacts() { return contacts_; }
    std::span<const Contact> contacts() const { return contacts_; }
    std::span<ContactSummary> summaries() { return summaries_; }
    std::span<const ContactSummary> summaries() const { return summaries_; }
    ContactEntry entry(std::uint32_t slot) { return {contacts_[slot], summaries_[slot], slot}; }
    ContactList all() { return {contacts_, summaries_}; }
    ContactBlocks& lanes() { return lanes_; }
    const ContactBlocks& lanes() const { return lanes_; }
    /// The home of the numbers of a contact.
    ContactLane lane(std::uint32_t slot) { return lanes_.lane(slot, summaries_[slot]); }
    /// The same, to be read alone.
    ContactLane read(std::uint32_t slot) const { return lanes_.read(slot, summaries_[slot]); }
    /// m, of the first point.
    Real separation(std::uint32_t slot) const { return read(slot).separation(0); }
    Real approachSpeed(std::uint32_t slot) const { return read(slot).approachSpeed(); }
    ContactNumbers numbers(std::uint32_t slot) const { return read(slot).numbers(); }
    /// Copy of a contact with its numbers, and with separations and centerA up to date.
    StoredContact copyOf(std::uint32_t slot, const Bodies& bodies) const;
    /// Must be called before a change of a contact within a step: the next step visits it.
    Contact& change(std::uint32_t slot, const Bodies& bodies);
    /// Takes a contact out of the passes.
    void leavePasses(std::uint32_t slot, const Bodies& bodies);
    /// Lists all slots in the order of keys.
    std::span<const std::uint32_t> slotsInOrder();
    /// Replaces all contacts by those of a snapshot; order() must follow.
    void assign(std::span<const StoredContact> contacts);
    /// Calls visit(slot) for all contacts in the order of their keys. Results may depend on this
    /// order, but not on that of the slots: other islands change it.
    template <typename Visit>
    void forEachInOrder(Visit visit) const {
        const bool anyGone = !gone_.empty();
        for (const Place& place : order_) {
            if (!anyGone || !summaries_[place.slot].gone) {
                visit(place.slot);
            }
        }
    }
    /// Slot of the contact at an index in the order of keys.
    std::uint32_t slotAt(std::size_t index) const { return order_[index].slot; }
    /// Sorts slots in the order of the keys of their contacts. Not valid after a change of bodies.
    void sortByKey(std::span<std::uint32_t> slots) const;
    /// Sizes the array by body, so that no first use costs a step as much as all bodies.
    void makeRoom(const Bodies& bodies) {
        lists_.makeRoom(bodies.size(), bodies.record.capacity());
    }
    /// Slots of the contacts of each body.
    const PairLists& lists() const { return lists_; }

    /// Takes a contact out of the lists of its bodies. Its slot stays in use until freeDetached().
    void detach(std::uint32_t slot);
    bool anyDetached() const { return !gone_.empty(); }
    /// Frees the slots of detached contacts. False if there are none.
    bool freeDetached();
    /// Removes the slots that the last freeDetached() freed from a list, and renumbers those that
    /// moved.
    void renumber(std::vector<std::uint32_t>& slots) const;

    /// Compares the contacts with the result of a search: false if they agree.
    bool findChanges(const CandidatePairs& candidates, WorkerTeam& team);
    /// Calls visit(slot) for each contact that the next merge() removes.
    template <typename Visit>
    void forEachRemoved(Visit visit) const {
        for (const Change& change : changes_) {
            if (!change.isNew) {
                visit(order_[change.at].slot);
            }
        }
    }
    /// Adds and removes what findChanges() found.
    void merge(const CandidatePairs& candidates, Bodies& bodies, WorkerTeam& team);
    /// Adds contacts that are not in the store, and returns their slots. Valid until the next call.
    std::span<const std::uint32_t> putBack(std::span<const StoredContact> contacts,
                                           const PartBounds& bounds);

    /// Counts a step. True if the contacts should be sorted.
    bool countStep() { return reorderPolicy_.countStep(contacts_.size()); }
    /// Sorts the contacts by key, so that a loop over them reads bodies in sequence. False if they
    /// were in order.
    bool sort();
    /// Rebuilds everything but the contacts.
    void order(const PartBounds& bounds);
    /// Describes all contacts again, after their bodies or the indices of bounds have changed.
    void describe(const Bodies& bodies, const PartBounds& bounds);
    /// The same for the contacts of one body.
    void describe(std::uint32_t body, const Bodies& bodies, const PartBounds& bounds);
    /// Describes all contacts in their summaries, and finds the indices of their bounds.
    void renewPlaces(const PartBounds& bounds);
    /// The indices of bounds have changed: see PartBounds::indexNow.
    void renumberBounds(const PartBounds& bounds);
    /// The keys of contacts have changed, but not their order. refreshPlaces() must follow.
    void partsChanged() { placesStale_ = true; }
    void refreshPlaces();
    void visitState(StateStream& stream, const Bodies& bodies, const PartBounds& bounds);

private:
    static constexpr std::size_t kContactsPerPiece = 128;
    /// Slot of a contact. PartBounds::isBefore() compares pairs of bounds as their contact keys.
    struct Place {
        BoundsPair pair;
        std::uint32_t slot;
    };
    /// A pair that is added or removed.
    struct Change {
        BoundsPair pair;
        std::uint32_t at; // index in order_: of the removed pair, or before which it is inserted
        bool isNew;
    };

    void listAll();
    void fillHoles();
    void addContacts(const CandidatePairs& candidates, Bodies& bodies, WorkerTeam& team);
    std::uint32_t append(const StoredContact& contact, const PartBounds& bounds);
    void insertAppended();
    void moveContact(std::uint32_t from, std::uint32_t to);
    void renewSummary(std::uint32_t slot, const PartBounds& bounds);

    std::vector<Contact> contacts_;
    std::vector<ContactSummary> summaries_;
    ContactBlocks lanes_;
    std::vector<Place> order_;        // of the contacts, by key
    std::vector<Place> newOrder_;     // scratch: merging allocates nothing
    PairLists lists_;                 // by body
    std::vector<std::uint32_t> gone_; // slots of detached contacts, until freeDetached()
    std::vector<Change> changes_;     // while merging
    ParallelCollector<Change> changesFound_;
    // While merging: slots of removed contacts, and indices in order_ of new ones.
    std::vector<std::uint32_t> holes_, added_;
    std::vector<std::uint8_t> addedIsDeep_; // by index in added_: see BodyRecord::crowdRank
    std::vector<std::uint32_t> movedTo_;    // by slot beyond the end, of the last fillHoles
    std::vector<std::uint32_t> slots_;      // scratch and result of putBack and slotsInOrder
    ReorderPolicy reorderPolicy_;
    bool placesStale_ = false; // pairs of bounds in order_
};

} // namespace KODO_PRECISION
} // namespace kodo
