// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collision_record.hpp>
#include <kodo/settings.hpp>

#include "base/assert.hpp"
#include "base/reorder_policy.hpp"
#include "base/vector_reuse.hpp"
#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"
#include "broad/pair_finder.hpp"
#include "contacts/contact.hpp"
#include "contacts/contact_lists.hpp"
#include "contacts/ghost_collisions.hpp"
#include "contacts/part_bounds.hpp"
#include "contacts/step_records.hpp"
#include "contacts/still_parts.hpp"

#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Solver-side storage of the contacts that persist across steps.
struct SolverStorage {
    /// By row, for the poses at the start of the step; empty if no contact is resident.
    std::span<const Carried> carried;
    /// Writes the state of a resident contact back to it. Called from several threads.
    const std::function<void(Contact&)>& evict;
};

/// All contacts of a World, and the bounds from which they are found.
class ContactSet {
public:
    /// A body was added, removed or teleported, or its geometry or filter changed: its pairs are
    /// searched again.
    void bodyChanged(std::uint32_t body);
    /// The same for all bodies.
    void bodiesChanged() { stale_ = true; }
    /// Removes the contacts of a body; calls writeBack(contact) before each removal. A contact that
    /// touched gets an End in the next records.
    void drop(std::uint32_t body, const WriteBack& writeBack);
    /// The bodies that touched a body in the last step, awake; may contain duplicates.
    void touchedBy(std::uint32_t body, std::vector<std::uint32_t>& others);

    /// Must be called before the removal of a part; the index of each later part falls by one.
    void partRemoved(std::uint32_t body, std::size_t part);
    /// A body fell asleep or woke, or an immovable body started or stopped; or any of all bodies.
    void activityChanged(std::uint32_t body) { activityChanges_.push_back(body); }
    void activityChanged() { pairsStale_ = true; }

    /// Removes and returns the contacts between bodies that are not active in a step, in order:
    /// all, or those `of` some bodies; calls writeBack(contact) before. Valid until the next call.
    std::span<const Contact> takeIdle(const Bodies& bodies, const WriteBack& writeBack);
    std::span<const Contact> takeIdle(const Bodies& bodies, std::span<const std::uint32_t> of,
                                      const WriteBack& writeBack);
    /// Puts back contacts that takeIdle returned. A contact already in the list stays unchanged.
    void putBack(std::span<const Contact> contacts, Bodies& bodies);

    /// Updates bounds and contacts after changes of bodies; does not search pairs.
    void applyChanges(const Bodies& bodies, const Tolerances& tolerances);
    /// Updates the list before a step of dt: the pairs that may touch within it, in order.
    void updatePairs(const Bodies& bodies, const Tolerances& tolerances, Real dt, WorkerTeam& team);
    /// Pairs of jointed bodies, in order, that must not touch whatever their flags say.
    void setExcludedPairs(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);
    /// Updates manifolds and approach speeds. Of a resident contact whose manifold is kept, only
    /// the summary is updated.
    void updateManifolds(const Bodies& bodies, const Tolerances& tolerances,
                         const SolverStorage& keeper, WorkerTeam& team);
    /// Measures all approach speeds again, after velocities have changed. No contact may be
    /// resident.
    void measureApproach(const Bodies& bodies);
    /// m/s, upper bound of the approach speeds; exact after updateManifolds and measureApproach.
    Real fastestApproach() const { return fastestApproach_; }
    /// Adds the pairs of bodies that the solver moved farther than updatePairs predicted.
    void coverDisplacements(const Bodies& bodies, const Tolerances& tolerances, WorkerTeam& team);

    /// Resets contacts whose impulses or positions are not finite, and finds their manifolds again.
    void forgetUnsound(const Bodies& bodies, const Tolerances& tolerances);

    /// Indexed by ContactSummary::proxies.
    const PartBounds& bounds() const { return bounds_; }
    PairFinder& pairFinder() { return finder_; }
    const PairFinder& pairFinder() const { return finder_; }

    /// By slot: constant within a step while no pair is added or removed.
    std::span<Contact> contacts() { return contacts_; }
    std::span<const Contact> contacts() const { return contacts_; }
    std::span<const ContactSummary> summaries() const { return summaries_; }
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
    /// Sorts slots in the order of the keys of their contacts. Not valid after a change of bodies.
    void sortByKey(std::span<std::uint32_t> slots) const;
    /// Slots of the contacts of each body.
    const ContactLists& lists() const;
    /// Slots of the contacts that are not idle, in order. Not valid after a change of the list of
    /// contacts.
    std::span<const std::uint32_t> live();
    /// Marks every contact as not idle for this step, for a solver that finds manifolds itself.
    void visitAll();
    /// Updates the summaries after such a solver.
    void noteManifolds();
    /// False if no contact has a sensor.
    bool mayHaveSensors() const { return anySensors_ != 0 || contactsChanged_; }
    /// False if no contact has restitution.
    bool mayBounce() const { return anyBounces_ != 0 || contactsChanged_; }
    /// After the solver assigned or released a row, or evicted the contact. On any thread.
    void noteRow(std::uint32_t place) { summaries_[place].noteRow(contacts_[place]); }
    void noteContact(std::uint32_t place) { summaries_[place].note(contacts_[place]); }
    /// Determines begin, persist and end of each contact. `touched` says by row whether the contact
    /// touched; its last element, for contacts without a row, is false. Contacts whose state does
    /// not change are not visited.
    void finishStepOfContacts(std::span<const std::uint8_t> touched, const Tolerances& tolerances,
                              WorkerTeam& team);
    /// Bodies whose isTouched may have changed since clearTouchChanges; may contain duplicates.
    std::span<const std::uint32_t> touchChanges() const { return touchChanges_; }
    void clearTouchChanges() { touchChanges_.clear(); }
    bool isTouched(std::uint32_t body) const { return touches_[body] > 0; }
    void finishStep(bool wantRecords) { records_.finish(wantRecords); }
    // Records of the last step, in order. Each function writes back the contacts of its own records
    // alone. All agree with records(), which has all of them.
    std::span<const CollisionRecord> records(const WriteBack& writeBack) const;
    std::span<const CollisionRecord> begun(const WriteBack& writeBack) const;
    std::span<const CollisionRecord> ended(const WriteBack& writeBack) const;
    /// Those with an impulse and an approach speed of at least minSpeed (m/s).
    std::vector<CollisionRecord> hits(Real minSpeed, const WriteBack& writeBack) const;
    std::vector<CollisionRecord> recordsOf(BodyId body, const WriteBack& writeBack) const;

private:
    friend class SnapshotFields;
    static constexpr std::size_t kContactsPerPiece = 128;
    static constexpr std::uint32_t kOneLess = ~std::uint32_t{}; // -1, added to unsigned counts
    struct Piece { // of the contacts; `end` is that of the whole range of the thread
        std::size_t first, last, end;
    };
    /// Slot of a contact. Pairs of bounds are in the order of the contact keys.
    struct Place {
        BoundsPair pair;
        std::uint32_t slot;
    };
    /// A pair that is added or removed.
    struct PairChange {
        BoundsPair pair;
        std::uint32_t at; // index in order_: of the removed pair, or before which it is inserted
        bool isNew;
    };

    void settle();
    void detach(std::uint32_t slot);
    void takeIdle(std::uint32_t slot, const WriteBack& writeBack);
    void takeOut(Contact& contact, const WriteBack& writeBack);
    std::uint32_t appendSlot(const Contact& contact, Bodies& bodies);
    void insertPlaces();
    void writeRecords() const;
    void writeEvents(const WriteBack& writeBack) const;
    template <typename Find, typename Accept>
    void select(Find find, Accept accept, const WriteBack& writeBack,
                std::vector<CollisionRecord>& out) const;
    void noteEnd(const Contact& contact);
    void countTouch(const Contact& contact, bool touches);
    void countTouches(const Bodies& bodies);
    void renew(const Bodies& bodies, const Tolerances& tolerances);
    void renewChanged(const Bodies& bodies, const Tolerances& tolerances);
    void orderContacts();
    void renewSummary(std::uint32_t slot);
    void renewPlaces(), renumberPairs(), compactBounds();
    void refreshPairs(const Bodies& bodies, WorkerTeam& team);
    void findPairs(const Bodies& bodies, WorkerTeam& team);
    template <typename Accept>
    void findPairsOfMovers(const Bodies& bodies, Accept accept, WorkerTeam& team);
    void findPairChanges(WorkerTeam& team);
    void mergePairs(const Bodies& bodies, WorkerTeam& team);
    void release(std::uint32_t slot, const Bodies& bodies);
    void addContacts(const Bodies& bodies, WorkerTeam& team);
    void changed();
    void noteKinds(const Bodies& bodies, WorkerTeam& team);
    bool boundsMeet(std::size_t i, const Tolerances& tolerances) const;
    bool staysKept(std::size_t i, const Tolerances& tolerances, std::span<const Carried> carried);
    void updatePiece(const Bodies& bodies, const Tolerances& tolerances,
                     const SolverStorage& keeper, const Piece& piece);
    Real listLive(std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) const;
    void updateManifold(const Bodies& bodies, const Tolerances& tolerances, std::size_t i,
                        const SolverStorage& keeper);
    template <typename Gone>
    void eraseIf(Gone gone);
    void fillHoles();
    void sortContacts();
    void noteManifold(std::size_t slot);
    bool summaryAgrees(std::uint32_t place) const;
    void finishContact(std::uint32_t place, bool touchesInRow, const Tolerances& tolerances,
                       const WorkerTeam& team, std::vector<std::uint32_t>& toggled);

    PartBounds bounds_;
    std::vector<BoundsPair> pairs_;
    PairFinder finder_;
    StillParts still_;
    MovingParts movers_;
    GhostCollisions ghostCollisions_;
    std::vector<Contact> contacts_;
    std::vector<Place> order_;            // of the contacts, by key
    mutable ContactLists lists_;          // by body; see lists()
    std::vector<std::uint32_t> gone_;     // slots of detached contacts, until settle()
    std::vector<Place> newOrder_;         // scratch: merging allocates nothing
    std::vector<PairChange> pairChanges_; // while merging
    ParallelCollector<PairChange> changesFound_;
    // While merging: slots of removed contacts, and indices in order_ of new ones.
    std::vector<std::uint32_t> holes_, added_;
    std::vector<ContactSummary> summaries_;
    std::vector<std::uint32_t> live_;
    ParallelCollector<std::uint32_t> found_;
    std::vector<std::uint32_t> onGround_; // slots: argument of GhostCollisions::link
    std::vector<std::uint32_t> slots_;    // scratch of fillHoles and putBack
    std::vector<Contact> idle_;           // result of takeIdle
    std::vector<std::uint32_t> changes_,
        activityChanges_;                  // bodies: see bodyChanged and activityChanged
    std::vector<std::uint8_t> hasChanged_; // by body: 1 if in changes_
    std::vector<std::uint32_t> touches_;   // by body: see isTouched; the number of such contacts
    std::vector<std::uint32_t> touchChanges_;
    mutable StepRecords records_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> excludedPairs_;
    Real fastestApproach_ = 0;
    ReorderPolicy reorderPolicy_; // of the contacts; order of keys: bodies are read in sequence
    bool stale_ = true, pairsStale_ = true, liveStale_ = true;
    bool placesStale_ = false;    // pairs of bounds in order_, after a change of part numbers
    bool contactsChanged_ = true; // in number or slot, or a body became immovable or movable
    std::uint8_t anySensors_ = 0, anyBounces_ = 0; // 0 or 1, from the last noteKinds
};

} // namespace KODO_PRECISION
} // namespace kodo
