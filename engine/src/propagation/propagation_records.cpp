// SPDX-License-Identifier: MIT
// What Propagation leaves in the contacts for their records.
#include <algorithm>

#include "propagation/propagation.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Adds the impulses of this substep to the contacts.
void Propagation::store(ContactStore& contacts) {
    for (std::uint32_t slot = 0; slot < contacts.size(); ++slot) {
        const ContactLane lane = contacts.lane(slot);
        lane.clearImpulses();
        for (std::size_t i = 0; i < 2; ++i) {
            lane.largest(i) = std::max(lane.largest(i), lane.impact(i));
            lane.total(0) += std::exchange(lane.impact(i), Real(0));
        }
    }
    for (const PropagationRow& row : rows_) {
        const ContactLane lane = contacts.lane(row.contact);
        lane.friction() = row.friction;
        lane.total(1) += row.friction;
        lane.rolling() = row.rolling;
        for (std::size_t i = 0; i < row.count; ++i) {
            lane.impulse(i) = row.impulse[i];
            lane.largest(i) = std::max(lane.largest(i), row.impulse[i]);
            lane.total(0) += row.impulse[i];
        }
    }
}

/// Called before store(), which adds the impacts to the sums.
void Propagation::findStrongest(ContactStore& store) {
    const std::span<const Contact> contacts = store.contacts();
    const auto compare = [&](std::uint32_t slot, Real impulse) {
        StrongestGroup& strongest = strongest_[slot];
        if (impulse > 0 && impulse >= strongest.impulse) {
            strongest = {impulse, contacts[slot].manifold, contacts[slot].centerA};
            store.lane(slot).updateSeparations(strongest.manifold);
        }
    };
    for (const std::uint32_t slot : struck_) {
        compare(slot, store.lane(slot).impacts());
    }
    for (const PropagationRow& row : rows_) {
        compare(row.contact, row.load());
    }
}

/// A later substep may have found the pair apart again. The record shows where it collided.
void Propagation::restoreStrongest(ContactStore& store) const {
    const std::span<Contact> contacts = store.contacts();
    for (std::uint32_t slot = 0; slot < contacts.size(); ++slot) {
        if (const StrongestGroup& strongest = strongest_[slot]; strongest.impulse > 0) {
            contacts[slot].near = true;
            contacts[slot].manifold = strongest.manifold;
            store.lane(slot).setSeparations(strongest.manifold);
            contacts[slot].centerA = strongest.centerA;
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
