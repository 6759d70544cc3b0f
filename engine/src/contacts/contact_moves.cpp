// SPDX-License-Identifier: MIT
// ContactStore: contacts that change, leave the passes, or move to another slot with their numbers.
#include "contacts/contact_store.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

StoredContact ContactStore::copyOf(std::uint32_t slot, const Bodies& bodies) const {
    StoredContact copy{contacts_[slot], numbers(slot), summaries_[slot].row};
    if (summaries_[slot].kept) { // since the last visit the bodies have moved
        copy.centerA = bodies.start[copy.key.bodyA];
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(copy.manifold.count); ++i) {
        copy.manifold.points[i].separation = copy.numbers.separation[i];
    }
    return copy;
}

Contact& ContactStore::change(std::uint32_t slot, const Bodies& bodies) {
    Contact& contact = contacts_[slot];
    if (std::exchange(summaries_[slot].kept, false)) { // not visited in this step
        contact.centerA = bodies.start[contact.key.bodyA];
        lane(slot).clearStep();
    }
    lane(slot).updateSeparations(contact.manifold);
    return contact;
}

void ContactStore::leavePasses(std::uint32_t slot, const Bodies& bodies) {
    change(slot, bodies).filled = false;
    lanes_.leave(entry(slot));
    summaries_[slot].row = {};
}

std::span<const std::uint32_t> ContactStore::slotsInOrder() {
    slots_.clear();
    forEachInOrder([&](std::uint32_t slot) { slots_.push_back(slot); });
    return slots_;
}

void ContactStore::assign(std::span<const StoredContact> contacts) {
    contacts_.assign(contacts.begin(), contacts.end());
    summaries_.assign(contacts.size(), {});
    lanes_ = {};
    lanes_.resize(contacts.size());
    for (std::uint32_t slot = 0; slot < contacts.size(); ++slot) {
        summaries_[slot].row = contacts[slot].row;
        lanes_.waiting(slot) = contacts[slot].numbers;
    }
}

/// Moves a contact to a slot that another one has left.
void ContactStore::moveContact(std::uint32_t from, std::uint32_t to) {
    contacts_[to] = contacts_[from];
    summaries_[to] = summaries_[from];
    if (!summaries_[to].inPasses()) {
        lanes_.waiting(to) = lanes_.waiting(from).numbers();
    }
}

/// Follows each cycle of the permutation with one contact as temporary.
bool ContactStore::sort() {
    reorderPolicy_ = {};
    bool moved = false;
    for (std::uint32_t start = 0; start < order_.size(); ++start) {
        if (order_[start].slot == start) {
            continue;
        }
        moved = true;
        const Contact contact = contacts_[start];
        const ContactSummary summary = summaries_[start];
        const ContactNumbers numbers = lanes_.waiting(start).numbers();
        std::uint32_t to = start;
        for (std::uint32_t from = order_[to].slot; from != start; from = order_[to].slot) {
            moveContact(from, to);
            order_[to].slot = to;
            to = from;
        }
        contacts_[to] = contact;
        summaries_[to] = summary;
        lanes_.waiting(to) = numbers;
        order_[to].slot = to;
    }
    if (moved) {
        listAll();
    }
    return moved;
}

} // namespace KODO_PRECISION
} // namespace kodo
