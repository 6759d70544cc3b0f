// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/collision_record.hpp>
#include <kodo/settings.hpp>

#include "base/worker_team.hpp"
#include "bodies/bodies.hpp"
#include "contacts/candidate_pairs.hpp"
#include "contacts/contact_store.hpp"
#include "contacts/ghost_collisions.hpp"
#include "contacts/line_side.hpp"
#include "contacts/one_way.hpp"
#include "contacts/step_records.hpp"
#include "contacts/touch_counts.hpp"

#include <optional>
#include <span>
#include <vector>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// All contacts of a World. A step updates the candidate pairs, the contacts in the store, their
/// manifolds, and after the solver what touches; records are written from the store.
class ContactSet {
public:
    const CandidatePairs& candidates() const { return candidates_; }
    CandidatePairs& candidates() { return candidates_; }
    const ContactStore& store() const { return store_; }
    ContactStore& store() { return store_; }
    ContactBlocks& lanes() { return store_.lanes(); }
    std::span<Contact> contacts() { return store_.contacts(); }
    std::span<const Contact> contacts() const { return store_.contacts(); }
    std::span<const ContactSummary> summaries() const { return store_.summaries(); }
    TouchCounts& touchCounts() { return touchCounts_; }

    // Changes between two steps.
    /// A body was added, removed or teleported, or its geometry or filter changed: its bounds are
    /// found at once, its pairs are searched in the next step.
    void bodyChanged(const Bodies& bodies, const Tolerances& tolerances, std::uint32_t body);
    /// The same, but the bounds are found in the next step, too.
    void bodyChanged(std::uint32_t body);
    /// The same for all bodies.
    void bodiesChanged() { stale_ = true; }
    /// Removes the contacts of a body. A contact that touched gets an End in the next records.
    void drop(std::uint32_t body, const Bodies& bodies);
    /// The bodies that touched a body in the last step, awake; may contain duplicates.
    void touchedBy(std::uint32_t body, std::vector<std::uint32_t>& others);
    /// Must be called before the removal of a part; the index of each later part falls by one.
    void partRemoved(std::uint32_t body, std::size_t part, const Bodies& bodies);
    /// A body fell asleep or woke, an immovable body started or stopped, or a joint of the body
    /// began or ceased to forbid contacts.
    void activityChanged(std::uint32_t body) {
        if (activityChanges_.size() < candidates_.bounds().size()) {
            activityChanges_.push_back(body);
        } else { // as a region that moves often between two steps
            pairsStale_ = true;
        }
    }
    /// The bodies of activityChanged() since the last step, with duplicates; empty: any body.
    std::optional<std::span<const std::uint32_t>> activityChanges() const {
        return stale_ || pairsStale_ ? std::nullopt : std::optional(std::span(activityChanges_));
    }
    /// Removes and returns the contacts `of` some bodies with none that is active in a step, in
    /// order. `states`: only those whose bodies together have exactly these of kAsleep and
    /// kOutside; 0: all. Valid until the next call.
    std::span<const StoredContact> takeIdle(const Bodies& bodies, std::span<const std::uint32_t> of,
                                            Flags states = 0);
    /// The same for the contacts of sleeping bodies with inactive ones that arrived, changed or
    /// stopped since the last call.
    std::span<const StoredContact> takeArrivals(const Bodies& bodies);
    /// These bodies began or ceased to be active within the step.
    void addArrivals(std::span<const std::uint32_t> bodies);
    /// Sizes the arrays by body, so that no first use costs a step as much as all bodies.
    void makeRoom(const Bodies& bodies) {
        store_.makeRoom(bodies);
        ghostCollisions_.makeRoom(bodies);
    }
    /// Puts back contacts that takeIdle returned. A contact already in the list stays unchanged.
    void putBack(std::span<const StoredContact> contacts, Bodies& bodies);
    /// True if applyChanges() has nothing to do.
    bool isUpToDate() const {
        return !stale_ && !pairsStale_ && changes_.empty() && activityChanges_.empty() &&
               !store_.anyDetached();
    }
    /// Updates bounds and contacts after changes of bodies; does not search pairs.
    void applyChanges(const Bodies& bodies, const Tolerances& tolerances);

    // Within a step, in this order.
    /// Updates the list before a step of dt: the pairs that may touch within it, in order. Bodies
    /// whose joint excludes a contact do not touch each other, whatever their flags are.
    void updatePairs(Bodies& bodies, const JointLists& joints, const Tolerances& tolerances,
                     Real dt, WorkerTeam& team);
    /// Updates manifolds, separations and approach speeds for a step of dt. Contacts in the passes
    /// whose manifold stays valid are not visited: their lanes are advanced together.
    void updateManifolds(Bodies& bodies, const Tolerances& tolerances, Real dt, WorkerTeam& team);
    /// Hides the ghost collisions of manifolds at the poses that a solver predicts; replaces none.
    void hidePredicted(const Bodies& bodies, const Tolerances& tolerances) {
        ghostCollisions_.hide({bodies, store_, tolerances, 0, liveStale_});
    }
    /// Measures the approach speeds of a body's contacts again, after its velocity has changed.
    void measureApproach(const Bodies& bodies, std::uint32_t body);
    /// m/s, upper bound of the approach speeds; exact after updateManifolds.
    Real fastestApproach() const { return fastestApproach_; }
    /// Slots of the contacts that are not idle, in order. Not valid after a change of the list of
    /// contacts.
    std::span<const std::uint32_t> live();
    /// False if no contact has a sensor.
    bool mayHaveSensors() const { return anySensors_ != 0 || contactsChanged_; }
    /// False if no contact has restitution.
    bool mayBounce() const { return anyBounces_ != 0 || contactsChanged_; }
    /// Marks every contact as not idle for this step.
    void visitAll();
    /// Before a solver that finds manifolds itself: all contacts leave the passes.
    void leavePasses(const Bodies& bodies);
    /// The manifold of a contact was replaced, and its approach speed measured.
    void manifoldChanged(std::uint32_t slot);
    /// Adds the pairs of bodies that the solver moved farther than updatePairs predicted.
    void coverDisplacements(Bodies& bodies, const JointLists& joints, const Tolerances& tolerances,
                            WorkerTeam& team);
    /// Resets contacts whose impulses or positions are not finite, and finds their manifolds again.
    void forgetUnsound(const Bodies& bodies, const Tolerances& tolerances, Real dt);
    /// Determines begin, persist and end of each contact. Contacts whose state does not change are
    /// not visited.
    void finishStepOfContacts(const Bodies& bodies, const Tolerances& tolerances, WorkerTeam& team);

    /// Records of the last step. Reading them does not change the contacts.
    StepRecords& records() const { return records_; }
    StepRecords::Source recordSource(const Bodies& bodies) const {
        return {store_, bodies, fastestApproach_};
    }
    /// Before writing, the contacts must be up to date.
    void visitState(StateStream& stream, const Bodies& bodies);

private:
    /// Of a body since the last step; Bounded: its bounds are up to date.
    enum class Change : std::uint8_t { None, Any, Bounded };

    void freeDetached();
    void takeIdle(std::uint32_t slot, const Bodies& bodies);
    StoredContact takeOut(std::uint32_t slot, const Bodies& bodies);
    void addEnd(const StoredContact& contact);
    void renewChanged(const Bodies& bodies, const Tolerances& tolerances);
    void refreshPairs(Bodies& bodies, const JointLists& joints, WorkerTeam& team);
    /// Contacts were added, removed or moved to other slots.
    void changed() { contactsChanged_ = liveStale_ = true; }
    void findKinds(const Bodies& bodies, WorkerTeam& team);
    void finishContact(std::uint32_t slot, bool touchesInRow, const Tolerances& tolerances,
                       const WorkerTeam& team, std::vector<std::uint32_t>& toggled);

    CandidatePairs candidates_;
    ContactStore store_;
    TouchCounts touchCounts_;
    mutable StepRecords records_;
    GhostCollisions ghostCollisions_;
    OneWayBodies oneWayBodies_;
    LineSides lineSides_;
    std::vector<std::uint32_t> live_;
    ParallelCollector<std::uint32_t> found_;
    std::vector<std::uint32_t> onGround_;                  // slots: argument of ghostCollisions_
    std::vector<StoredContact> idle_;                      // result of takeIdle
    std::vector<std::uint32_t> changes_, activityChanges_; // bodies
    std::vector<std::uint32_t> arrivals_; // bodies with a change since the last takeArrivals
    std::vector<Change> hasChanged_;      // by body: not None if in changes_
    Real fastestApproach_ = 0;
    bool stale_ = false, pairsStale_ = false, liveStale_ = true;
    bool allArrived_ = true;      // instead of arrivals_
    bool contactsChanged_ = true; // in number or slot, or a body became immovable or movable
    std::uint8_t anySensors_ = 0, anyBounces_ = 0; // 0 or 1, from the last findKinds
};

} // namespace KODO_PRECISION
} // namespace kodo
