// SPDX-License-Identifier: MIT
// What Propagation leaves in the contacts for their records.
#include <algorithm>

#include "propagation/propagation.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Adds the impulses of this substep to the contacts.
void Propagation::store(std::span<Contact> contacts) {
    for (Contact& contact : contacts) {
        contact.carried = false;
        contact.row = {}; // not in a lane of the soft solver
        contact.hasStepImpulses = true;
        contact.friction = 0;
        contact.rolling = 0;
        for (PointImpulse& impulse : contact.impulse) {
            impulse.largest = std::max(impulse.largest, impulse.impact);
            contact.total += impulse.impact;
            impulse.impact = 0;
            impulse.normal = 0;
        }
    }
    for (const PropagationRow& row : rows_) {
        Contact& contact = contacts[row.contact];
        contact.friction = row.friction;
        contact.rolling = row.rolling;
        for (std::size_t i = 0; i < row.count; ++i) {
            PointImpulse& impulse = contact.impulse[i];
            impulse.normal = row.impulse[i];
            impulse.largest = std::max(impulse.largest, impulse.normal);
            contact.total += impulse.normal;
        }
    }
}

/// Called before store(), which adds the impacts to the sums.
void Propagation::noteStrongest(std::span<const Contact> contacts) {
    const auto note = [&](std::uint32_t slot, Real impulse) {
        StrongestGroup& strongest = strongest_[slot];
        if (impulse > 0 && impulse >= strongest.impulse) {
            strongest = {impulse, contacts[slot].manifold, contacts[slot].centerA};
        }
    };
    for (const std::uint32_t slot : struck_) {
        note(slot, contacts[slot].impulse[0].impact + contacts[slot].impulse[1].impact);
    }
    for (const PropagationRow& row : rows_) {
        note(row.contact, row.load());
    }
}

/// A later substep may have found the pair apart again. The record shows where it collided.
void Propagation::restoreStrongest(std::span<Contact> contacts) const {
    for (std::size_t slot = 0; slot < contacts.size(); ++slot) {
        if (const StrongestGroup& strongest = strongest_[slot]; strongest.impulse > 0) {
            contacts[slot].near = true;
            contacts[slot].manifold = strongest.manifold;
            contacts[slot].centerA = strongest.centerA;
        }
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
