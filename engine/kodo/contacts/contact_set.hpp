// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/assert.hpp>
#include <kodo/base/crew.hpp>
#include <kodo/base/disorder.hpp>
#include <kodo/base/refill.hpp>
#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/broad/pair_finder.hpp>
#include <kodo/contacts/collision_record.hpp>
#include <kodo/contacts/contact.hpp>
#include <kodo/contacts/contact_report.hpp>
#include <kodo/contacts/part_bounds.hpp>
#include <kodo/contacts/seams.hpp>

#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Whom contacts are lent to from step to step.
struct ContactKeeper {
    /// By row, and up to date with the poses that the step begins with; empty if nothing is lent.
    std::span<const Carried> carried;
    /// Gives a contact back, if it is lent. Several threads call it.
    const std::function<void(Contact&)>& reclaim;
};

/// All contacts of a World, with the bounds they are found by.
class ContactSet {
public:
    /// A body came, went, jumped, or changed its form or filter: look at its pairs again.
    void bodyChanged(std::uint32_t body);
    /// Many of them: look at all.
    void bodiesChanged() { stale_ = true; }
    /// Forgets the contacts of one body, to each of which it calls fetch(contact) before. Those
    /// that touched end in the next record.
    void drop(std::uint32_t body, const std::function<void(Contact&)>& fetch);

    /// A part of a body is about to go; those behind it move up by one.
    void partRemoved(std::uint32_t body, std::size_t part);
    /// A body fell asleep or woke up, or a locked one began or ceased to move.
    void activityChanged(std::uint32_t body) { stirred_.push_back(body); }
    /// Many of them.
    void activityChanged() { pairsStale_ = true; }

    /// Takes out the contacts between bodies that take no part in a step, in order. Valid until the
    /// next call.
    std::span<const Contact> takeIdle(const Bodies& bodies);
    /// Puts contacts back that takeIdle once gave. One that is in the list by now stays as it is.
    void putBack(std::span<const Contact> contacts, Bodies& bodies);

    /// Brings all that follows from the bodies up to date with them, but for the pairs.
    void applyChanges(const Bodies& bodies, const Tolerances& tolerances);
    /// Brings the list up to date before a step of dt: the pairs that may meet within it, in order.
    void updatePairs(const Bodies& bodies, const Tolerances& tolerances, Real dt, Crew& crew);
    /// Pairs of bodies, in order, that may not touch although their flags say so: jointed ones.
    void setApart(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);
    /// Finds where the pairs touch, now, and how fast they approach. Of those that are lent and go
    /// on as they are, only the heads are told.
    void updateManifolds(const Bodies& bodies, const Tolerances& tolerances,
                         const ContactKeeper& keeper, Crew& crew);
    /// Measures the approach again, since bodies have got other speeds. Nothing may be lent.
    void measureApproach(const Bodies& bodies);
    /// m/s, of those that updateManifolds looked at.
    Real fastestApproach() const { return fastestApproach_; }
    /// Adds the pairs of bodies that the solver sent farther than updatePairs could foresee.
    void coverMoves(const Bodies& bodies, const Tolerances& tolerances, Crew& crew);

    /// Contacts with an impulse or a place that is not finite start anew, where their bodies are.
    void forgetUnsound(const Bodies& bodies, const Tolerances& tolerances);

    /// Of all parts, by the proxies of contacts.
    const PartBounds& bounds() const { return bounds_; }
    /// What looks for the pairs.
    PairFinder& pairFinder() { return finder_; }
    const PairFinder& pairFinder() const { return finder_; }

    /// In an order of their own, which does not change within a step while no pair comes or goes.
    std::span<Contact> contacts() { return contacts_; }
    std::span<const Contact> contacts() const { return contacts_; }
    /// Of each contact, in the same order.
    std::span<const ContactHead> heads() const { return heads_; }
    /// Calls visit(contact) for all of them in the order of their keys, which is that of bodies.
    template <typename Visit>
    void forEachInOrder(Visit visit) {
        for (const Place& place : order_) {
            visit(contacts_[place.slot]);
        }
    }
    /// Places of those that anything may come of in this step, in order; the others are far apart
    /// and were before. To be asked for anew after the list of contacts may have changed.
    std::span<const std::uint32_t> live();
    /// Something may come of all of them in this step: who asks for more than live() brings them
    /// into contact by itself.
    void lookAtAll();
    /// To be called by who then found manifolds by itself.
    void noteManifolds();
    /// False if no contact is a sensor's.
    bool mayHaveSensors() const { return anySensors_ != 0 || contactsChanged_; }
    /// False if no contact bounces.
    bool mayBounce() const { return anyBounces_ != 0 || contactsChanged_; }
    /// The solver gave a contact a row, or took it, or gave the contact back. Several threads call
    /// it.
    void noteRow(std::uint32_t place) {
        heads_[place].row = contacts_[place].row.index;
        heads_[place].kept = contacts_[place].isKept();
    }
    /// Sums up a step. `touched` tells by row whether the contact of a row touched, and last, what
    /// holds of no row: false. Contacts that go on as they were are left alone, as most of a pile.
    void sumUp(std::span<const std::uint8_t> touched, const Tolerances& tolerances, Crew& crew);
    /// Bodies for which isTouched may have changed since clearTouchChanges, some more than once.
    std::span<const std::uint32_t> touchChanges() const { return touchChanges_; }
    void clearTouchChanges() { touchChanges_.clear(); }
    /// Does a contact touch the body, as summed up last?
    bool isTouched(std::uint32_t body) const { return touches_[body] > 0; }
    /// The last of a step: what is recorded from now on belongs to the next.
    void finishStep(bool wantRecords) {
        records_.clear();
        endedInStep_.clear();
        if (!ended_.empty()) {
            std::swap(ended_, endedInStep_);
            ended_.reserve(endedInStep_.capacity()); // the two take turns
        }
        recordsDue_ = wantRecords;
    }
    /// Of the last step, in order. They are written when they are first asked for, or before a
    /// contact goes, so that those who ask for none pay for none. current(contact) is a contact
    /// that is not lent.
    template <typename Current>
    std::span<const CollisionRecord> records(Current current) const {
        if (std::exchange(recordsDue_, false)) {
            records_.reserve(contacts_.capacity() + dropped_.size() + endedInStep_.size());
            for (const Place& place : order_) {
                if (contacts_[place.slot].phase) {
                    recordContact(current(contacts_[place.slot]), records_);
                }
            }
            addInOrder(dropped_, records_);
            addInOrder(endedInStep_, records_);
        }
        return records_;
    }

private:
    friend class SnapshotFields;
    static constexpr std::size_t kContactsAPiece = 128;
    static constexpr std::uint32_t kOneLess = ~std::uint32_t{}; // added to a count, since it wraps

    /// Some contacts, and the end of those that one thread goes through.
    struct Piece {
        std::size_t first;
        std::size_t last; // the one behind them
        std::size_t end;
    };
    /// Where a contact is, by the bounds of its parts, which are in the order of keys.
    struct Place {
        BoundsPair pair;
        std::uint32_t slot;
    };
    /// A pair that has come or gone, and where it is in order_ or goes before.
    struct News {
        BoundsPair pair;
        std::uint32_t at;
        bool comes;
    };

    void writeRecords() const;
    void noteEnd(const Contact& contact);
    void countTouch(const Contact& contact, bool touches);
    void countTouches(const Bodies& bodies);
    void renew(const Bodies& bodies, const Tolerances& tolerances);
    void renewChanged(const Bodies& bodies, const Tolerances& tolerances);
    void orderContacts();
    void renewHead(std::uint32_t slot);
    void renewPlaces();
    void refreshPairs(const Bodies& bodies, Crew& crew);
    void findPairs(const Bodies& bodies, Crew& crew);
    void findNews(Crew& crew);
    void mergePairs(const Bodies& bodies, Crew& crew);
    void dismiss(Contact& gone, const Bodies& bodies);
    void addContacts(const Bodies& bodies, Crew& crew);
    void changed();
    void noteKinds(const Bodies& bodies, Crew& crew);
    bool boundsMeet(std::size_t i, const Tolerances& tolerances) const;
    bool staysKept(std::size_t i, const Tolerances& tolerances, std::span<const Carried> carried);
    void updatePiece(const Bodies& bodies, const Tolerances& tolerances,
                     const ContactKeeper& keeper, const Piece& piece);
    Real listLive(std::size_t first, std::size_t last, std::vector<std::uint32_t>& found) const;
    void updateManifold(const Bodies& bodies, const Tolerances& tolerances, std::size_t i,
                        const ContactKeeper& keeper);
    template <typename Gone>
    void eraseIf(Gone gone);
    void fillHoles();
    void sortContacts();
    bool isTrue(std::uint32_t place) const;
    void finishContact(std::uint32_t place, bool touchesInRow, const Tolerances& tolerances,
                       const Crew& crew, std::vector<std::uint32_t>& changes);

    PartBounds bounds_;
    std::vector<BoundsPair> pairs_;
    PairFinder finder_;
    Seams seams_;
    std::vector<Contact> contacts_;
    std::vector<Place> order_;    // of the contacts, by key
    std::vector<Place> newOrder_; // spare, so that merging allocates nothing
    std::vector<News> news_;      // while merging
    Findings<News> newsFound_;
    std::vector<std::uint32_t> holes_; // slots whose contact is gone, while merging
    std::vector<std::uint32_t> added_; // places in the order whose contact is new, while merging
    std::vector<ContactHead> heads_;
    std::vector<std::uint32_t> live_;
    Findings<std::uint32_t> found_;
    std::vector<std::uint32_t> onGround_; // places: while seams are linked
    std::vector<std::uint32_t> slots_;    // where the contacts of the last slots went
    std::vector<Contact> idle_;           // that takeIdle gave
    // Of the last step, of contacts that have gone with their bodies since.
    std::vector<CollisionRecord> dropped_;
    std::vector<std::uint32_t> changes_;   // bodies: see bodyChanged
    std::vector<std::uint8_t> hasChanged_; // by body: is it one of these?
    std::vector<std::uint32_t> stirred_;   // bodies, some perhaps twice: see activityChanged
    std::vector<std::uint32_t> touches_;   // by body: how many contacts touch it, as summed up last
    std::vector<std::uint32_t> touchChanges_;
    // Of contacts that ended because they lost a body or the nearness of their parts.
    std::vector<CollisionRecord> ended_;       // since the last step
    std::vector<CollisionRecord> endedInStep_; // before it
    mutable std::vector<CollisionRecord> records_;
    mutable bool recordsDue_ = false;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> apart_;
    Real fastestApproach_ = 0;
    Disorder disorder_; // of the contacts, which are best off in the order of their keys
    bool stale_ = true;
    bool pairsStale_ = true;
    bool contactsChanged_ = true; // in number, in place, or in what is locked
    bool liveStale_ = true;
    std::uint8_t anySensors_ = 0; // when contacts changed last
    std::uint8_t anyBounces_ = 0; // likewise
};

} // namespace kodo::inline KODO_PRECISION
