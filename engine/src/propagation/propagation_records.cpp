// SPDX-License-Identifier: MIT
// What Propagation leaves in the contacts for their records: whole blows, and their impulses.
#include <algorithm>

#include "propagation/propagation.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

// A row has stopped what it braked by this share of the way at least. A corner that just reaches a
// face comes the next time.
constexpr Real kArrives = Real(1e-4);

/// After the displacements: a point with an impulse has closed its gap, so its blow comes now, and
/// not with the next substep of h (s). True if there is one. An approach that the forces of a
/// substep cause belongs to contacts at rest. Where joints pull too, four passes would leave them
/// open, and a ball on a chain gained energy from a tower.
bool Propagation::findArrivals(const Bodies& bodies, Real h) {
    bool any = false;
    std::uint32_t first = 0;
    for (const std::uint32_t end : rowEnds_) {
        const auto rows = std::span(rows_).subspan(first, end - first);
        const bool held =
            std::any_of(rows.begin(), rows.end(), [](auto& row) { return row.again; });
        bool arrived = false;
        for (PropagationRow& row : held ? rows.first(0) : rows) {
            const RowMasses masses = massesOf(bodies, row);
            const Real forced = h * h *
                                std::max(length(bodies.acceleration[row.a].linear),
                                         length(bodies.acceleration[row.b].linear));
            for (std::size_t i = 0; i < row.count; ++i) {
                PropagationRow::Point& p = row.points[i];
                const Real braked = h * row.impulse[i] * masses.response(p.leverA, p.leverB); // m
                const bool now = p.gap > forced && braked > kArrives * p.gap;
                p.gap = now ? 0 : p.gap;
                arrived = arrived || now;
            }
        }
        for (PropagationRow& row : rows) {
            row.again = row.again || arrived;
        }
        any = any || arrived;
        first = end;
    }
    return any;
}

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
