// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "bodies/bodies.hpp"
#include "contacts/contact_set.hpp"
#include "joints/joint_set.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

void restartCount(SleepState& rest, const Transform& pose);

/// Puts islands of still bodies to sleep, and wakes them [Thesis06, 5.2].
///
/// A body is calm in a step if its kinetic energy is at most what its forces would give it from
/// rest. So no speed threshold is needed. Forces that cancel out count as well, else no floating
/// body could fall asleep:
///
///   m v^2 + I w^2 <= m (sum |F| / m dt)^2 + I (alpha dt)^2          [after Thesis06, eq. 5]
///
/// A calm body must also stay where it was when it became calm. A slowly tipping body (fig. 5.3) is
/// recognised by its increasing speed, however small, and a swinging one by a velocity that still
/// changes where it turns back. Touching bodies form an island. It falls asleep as a whole, once
/// all its bodies have been calm for sleepSteps steps. Its bodies and contacts are then not in the
/// lists of a step.
class SleepSystem {
public:
    /// Sizes the arrays by body, so that no first use costs a step as much as all bodies.
    void makeRoom(const Bodies& bodies);
    /// Wakes the islands that an active body touches. Needs fresh manifolds.
    void wakeTouched(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances);
    /// Wakes the islands that a joint connects to an active body.
    void wakeJointed(Bodies& bodies, ContactSet& contacts, const JointSet& joints);
    /// Wakes the islands that a kinematic body runs into within the step, too fast for contacts.
    /// Continuous collision then pushes them along. Needs the displacements of the step. True if
    /// any woke.
    bool wakeRunOver(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances);
    /// Counts calm steps. True if islands have been calm for long enough for sleepIslands().
    bool updateSleep(Bodies& bodies, const ContactSet& contacts, const JointSet& joints,
                     const StepSettings& settings, const Tolerances& tolerances, Real dt);
    /// Puts these islands to sleep with their contacts.
    void sleepIslands(Bodies& bodies, ContactSet& contacts);
    /// Puts the island of a body to sleep at once. False if something in it or at it keeps it
    /// awake.
    bool putToSleep(Bodies& bodies, ContactSet& contacts, const JointSet& joints,
                    std::uint32_t body);
    /// Takes contacts of sleeping bodies with inactive ones that arrived before this step out of
    /// the list, to the islands.
    void keepArrivals(const Bodies& bodies, ContactSet& contacts);

    /// Restarts the calm count of a body, and wakes its island if it is asleep.
    void wake(Bodies& bodies, ContactSet& contacts, std::uint32_t body);
    /// Wakes the island of a body and all islands that touch it or share a joint with it. For a
    /// body that is removed, teleported or changed.
    void wakeNeighbours(Bodies& bodies, ContactSet& contacts, const JointSet& joints,
                        std::uint32_t body);
    /// The same without a change of the body: what pressed it still does.
    void wakeAround(Bodies& bodies, ContactSet& contacts, const JointSet& joints,
                    std::uint32_t body);
    void wakeAll(Bodies& bodies, ContactSet& contacts);
    /// Wakes the islands that touched one of these bodies, if that body is active now.
    void wakeOn(Bodies& bodies, ContactSet& contacts, std::span<const std::uint32_t> of);
    bool anyAsleep() const { return sleepingIslands_ > 0; }

    /// Visits the contacts of sleeping islands, island by island.
    template <typename Visit>
    void forEachContact(Visit visit) const {
        for (const Island& island : islands_) {
            for (const StoredContact& contact : island.contacts) {
                visit(contact);
            }
        }
    }
    /// Visits the contacts of sleeping islands to which a body belongs or has contacts; some of
    /// them twice.
    template <typename Visit>
    void forEachContactNear(const Bodies& bodies, std::uint32_t body, Visit visit) const {
        const std::uint32_t own = bodies.sleep[body].island;
        if (own != SleepState::kNoIsland) {
            std::for_each(islands_[own].contacts.begin(), islands_[own].contacts.end(), visit);
        }
        if (body >= neighboursOf_.size()) {
            return;
        }
        for (const NeighbourIsland& neighbour : neighbourIslands_[neighboursOf_[body]]) {
            if (!hasWoken(neighbour)) {
                const std::vector<StoredContact>& all = islands_[neighbour.island].contacts;
                std::for_each(all.begin(), all.end(), visit);
            }
        }
    }
    void visitState(StateStream& stream, Bodies& bodies);

private:
    struct Island {
        std::vector<std::uint32_t> bodies; // empty: a free slot
        std::vector<StoredContact> contacts;
        std::uint32_t version = 0; // changes whenever it wakes

        void visitState(StateStream& stream);
    };
    /// An island that has a contact with a body of another island, or with an immovable one. Out of
    /// date once the island has woken.
    struct NeighbourIsland {
        std::uint32_t island;
        std::uint32_t version; // Island::version when the contact was noted
        bool operator==(const NeighbourIsland&) const = default;
    };

    /// Range of the points that support a body, across its acceleration, from its centre of mass.
    struct Base {
        Real least = 0; // m
        Real most = 0;
    };

    void wakeIslands(Bodies& bodies, ContactSet& contacts);
    void noteTouching(Bodies& bodies, ContactSet& contacts, std::uint32_t body);
    void disturb(Bodies& bodies, std::uint32_t body);
    void keepContacts(const Bodies& bodies, std::span<const StoredContact> idle);
    std::vector<NeighbourIsland>& neighboursFor(std::uint32_t body);
    void noteIslandContact(const Bodies& bodies, const Contact& contact, std::uint32_t island);
    bool hasWoken(const NeighbourIsland& neighbour) const {
        return islands_[neighbour.island].version != neighbour.version;
    }
    void putToSleep(Bodies& bodies, std::span<const std::uint32_t> members);
    void countCalm(Bodies& bodies, const StepSettings& settings, const Tolerances& tolerances,
                   Real dt);
    void findCalmIslands(const Bodies& bodies, const ContactSet& contacts, const JointSet& joints,
                         std::uint32_t enough);
    bool followIsland(std::uint32_t start, std::uint32_t search, const Bodies& bodies,
                      const ContactSet& contacts, const JointSet& joints, std::uint32_t enough);
    void findBases(const Bodies& bodies, const ContactSet& contacts);
    Base baseOf(std::uint32_t body, const Bodies& bodies, const ContactSet& contacts) const;
    void holdMoving(Bodies& bodies, std::uint32_t enough, const Tolerances& tolerances, Real dt);

    std::vector<Island> islands_;
    std::size_t sleepingIslands_ = 0;
    std::vector<std::uint32_t> freeIslands_;  // heap, the lowest on top
    std::vector<std::uint32_t> neighboursOf_; // by body: index of its list, 0 of none
    std::vector<std::vector<NeighbourIsland>> neighbourIslands_{1}; // lists; the first stays empty
    std::vector<std::uint32_t> calm_;      // calm for long enough, in order
    std::vector<std::uint32_t> reached_;   // scratch of findCalmIslands
    std::vector<std::uint32_t> reachedBy_; // by body: number of the search; 0: none
    std::vector<std::uint32_t> leastCalm_; // by root: calm steps
    std::vector<Base> bases_;              // of sleepers_
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sleepers_; // root and body
    std::vector<std::uint32_t> members_;                            // of an island, or to be woken
    std::vector<std::uint32_t> woken_;                              // islands: see wakeIslands
    std::vector<StoredContact> returning_;                          // scratch of wakeIslands
};

} // namespace KODO_PRECISION
} // namespace kodo
