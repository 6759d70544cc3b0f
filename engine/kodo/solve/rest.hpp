// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/base/disjoint_sets.hpp>
#include <kodo/bodies/bodies.hpp>
#include <kodo/bodies/tolerances.hpp>
#include <kodo/contacts/contact_set.hpp>
#include <kodo/joints/joint_set.hpp>
#include <kodo/solve/settings.hpp>

#include <utility>
#include <vector>

namespace kodo::inline KODO_PRECISION {

/// Puts bodies to rest that have come to lie still, and wakes them again [Thesis06, 5.2].
///
/// A body is calm in a step in which it has less kinetic energy than the forces on it would give it
/// from a standstill, so there is no threshold in m/s. Forces that cancel out count too, or nothing
/// could come to rest afloat:
///
///   m v^2 + I w^2 <= m (sum |F| / m dt)^2 + I (alpha dt)^2          [after Thesis06, eq. 5]
///
/// and has not crept away from where it began to be calm. A slowly tipping body (fig. 5.3) is told
/// by the one corner that it stands on while it gains speed, however little. Bodies that touch form
/// an island, and rest only together, once all of them have been calm for restSteps steps; then
/// they and their contacts leave the lists that a step works on.
class RestStage {
public:
    /// Wakes the islands that something active touches. To be called with fresh manifolds.
    void wakeTouched(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances);
    /// Wakes the islands that a joint ties to something active.
    void wakeJointed(Bodies& bodies, ContactSet& contacts, const JointSet& joints);
    /// Wakes the islands that something locked runs into within the step, too fast for contacts, so
    /// that the sweep can push them along. To be called when the motions are known. True if any
    /// did.
    bool wakeRunOver(Bodies& bodies, ContactSet& contacts, const Tolerances& tolerances);
    /// Counts calm steps. True if some islands have been calm for long enough to settle().
    bool findRest(Bodies& bodies, const ContactSet& contacts, const JointSet& joints,
                  const StepSettings& settings, const Tolerances& tolerances, Real dt);
    /// Puts them to rest, with their contacts, which must not be lent.
    void settle(Bodies& bodies, ContactSet& contacts);

    /// Wakes the island of one body, if it rests.
    void wake(Bodies& bodies, ContactSet& contacts, std::uint32_t body);
    /// Wakes the island of one body and every island that touches it or is tied to it: it goes,
    /// jumps or changes.
    void disturb(Bodies& bodies, ContactSet& contacts, const JointSet& joints, std::uint32_t body);
    void wakeAll(Bodies& bodies, ContactSet& contacts);
    bool anyResting() const { return restingIslands_ > 0; }

    /// The contacts of what rests, island by island.
    template <typename Visit>
    void forEachContact(Visit visit) const {
        for (const Island& island : islands_) {
            for (const Contact& contact : island.contacts) {
                visit(contact);
            }
        }
    }

private:
    friend class SnapshotFields;

    struct Island {
        std::vector<std::uint32_t> bodies; // empty: a free slot
        std::vector<Contact> contacts;
    };

    void wakeIsland(Bodies& bodies, ContactSet& contacts, std::uint32_t island);
    void countLeaning(const Contact& contact, bool leans);
    void putToRest(Bodies& bodies, std::span<const std::uint32_t> members);
    bool countCalm(Bodies& bodies, const StepSettings& settings, const Tolerances& tolerances,
                   Real dt);
    void joinTouching(const Bodies& bodies, const ContactSet& contacts, const JointSet& joints);
    void countSupports(const Bodies& bodies, const ContactSet& contacts, const JointSet& joints);
    void restartTipping(Bodies& bodies, Real dt);

    std::vector<Island> islands_;
    std::size_t restingIslands_ = 0;
    std::vector<std::uint32_t> leaning_;   // by body: how many contacts of islands touch it
    DisjointSets touching_;                // of bodies that are awake
    std::vector<std::uint32_t> leastCalm_; // by root
    std::vector<std::uint32_t> supports_;  // points that each body touches something with
    std::vector<std::pair<std::uint32_t, std::uint32_t>> resting_; // root and body
    std::vector<std::uint32_t> members_;                           // of one island, or to be woken
    std::vector<Contact> standing_; // of bodies that neither rest nor take part
};

} // namespace kodo::inline KODO_PRECISION
