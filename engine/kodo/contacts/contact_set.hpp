// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/broad/sort_and_sweep.hpp>
#include <kodo/contacts/collision_record.hpp>
#include <kodo/contacts/contact.hpp>
#include <kodo/contacts/seams.hpp>

#include <span>
#include <utility>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// All contacts of a World, ordered by key, with the bounds they are found by.
class ContactSet {
public:
    /// A body came, went, jumped, or changed its form or filter: look at all of them again.
    void bodiesChanged() { stale_ = true; }
    /// Forgets the contacts of one body. Those that touched end in the next record.
    void drop(std::uint32_t body);

    /// A part of a body is about to go; those behind it move up by one.
    void partRemoved(std::uint32_t body, std::size_t part);
    /// Some body fell asleep, woke up, or a locked one began or ceased to move.
    void activityChanged() { pairsStale_ = true; }

    /// Takes out the contacts between bodies that take no part in a step, in order.
    std::vector<Contact> takeIdle(const Bodies& bodies);
    /// Puts contacts back that takeIdle once gave. One that is in the list by now stays as it is.
    void putBack(std::span<const Contact> contacts);

    /// Brings the list up to date before a step of dt: the pairs that may meet within it, in order.
    void updatePairs(const Bodies& bodies, const Tolerances& tolerances, Real dt);
    /// Pairs of bodies, in order, that may not touch although their flags say so: jointed ones.
    void setApart(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);
    /// Finds where the pairs touch, now, and how fast they approach.
    void updateManifolds(const Bodies& bodies, const Tolerances& tolerances);
    /// Adds the pairs of bodies that the solver sent farther than updatePairs could foresee.
    void coverMoves(const Bodies& bodies, const Tolerances& tolerances);

    /// Contacts whose impulses are not finite start anew.
    void forgetUnsoundImpulses();

    std::span<Contact> contacts() { return contacts_; }
    std::span<const Contact> contacts() const { return contacts_; }

    /// The records of contacts that ended because they lost a body, until clearEnded().
    std::span<const CollisionRecord> ended() const { return ended_; }
    void clearEnded() { ended_.clear(); }
    void noteEnd(const Contact& contact);

private:
    friend class SnapshotFields;

    struct Proxy {
        std::uint32_t body;
        std::uint16_t part;
    };

    void rebuildProxies(const Bodies& bodies);
    const Convex& outline(const Bodies& bodies, std::size_t proxy) const;
    void findPairs(const Bodies& bodies);
    void mergePairs(const Bodies& bodies);
    Contact makeContact(const Bodies& bodies, BoundsPair pair) const;

    std::vector<Proxy> proxies_;            // one for each part of each body, in order
    std::vector<std::uint32_t> firstProxy_; // by body
    std::vector<Aabb> tight_;               // where it is
    std::vector<Aabb> grown_;               // where it may be until its pairs are looked for again
    std::vector<BoundsPair> pairs_;
    SortAndSweep sortAndSweep_;
    Seams seams_;
    std::vector<Contact> contacts_;
    std::vector<Contact> previous_; // spare, so that merging allocates nothing
    std::vector<CollisionRecord> ended_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> apart_;
    bool stale_ = true;
    bool pairsStale_ = true;
};

/// Sums up a step for one contact: did it touch, and how hard.
void finishContact(Contact& contact, const Tolerances& tolerances);

/// Appends what one contact did in this step, if it did anything.
void recordContact(const Contact& contact, std::vector<CollisionRecord>& out);

} // namespace kodo::inline KODO_PRECISION
