// SPDX-License-Identifier: MIT
// ContactSet: additions, removals and changes of bodies between two steps.
#include "contacts/contact_set.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

/// Removes the contacts for which gone(slot) is true, in the order of keys.
template <typename Gone>
void ContactSet::eraseIf(Gone gone) {
    settle();
    for (const Place& place : order_) {
        if (gone(place.slot)) {
            detach(place.slot);
        }
    }
    settle();
}

/// Takes a contact out of the lists of its bodies. Its slot stays in use until settle().
void ContactSet::detach(std::uint32_t slot) {
    ContactSummary& summary = summaries_[slot];
    if (lists_.isValid()) {
        lists_.remove(slot, summary.bodyA, summary.bodyB);
    }
    summary.gone = true;
    contacts_[slot].phase.reset(); // no record
    gone_.push_back(slot);
}

/// Frees the slots of detached contacts.
void ContactSet::settle() {
    if (gone_.empty()) {
        return;
    }
    std::erase_if(order_, [&](const Place& place) { return summaries_[place.slot].gone; });
    holes_.clear();
    std::swap(holes_, gone_);
    fillHoles();
}

/// The contacts of each body.
const ContactLists& ContactSet::lists() const {
    if (!lists_.isValid()) {
        lists_.begin(touches_.size(), contacts_.size());
        forEachInOrder([&](std::uint32_t slot) {
            lists_.add(slot, summaries_[slot].bodyA, summaries_[slot].bodyB);
        });
    }
    return lists_;
}

void ContactSet::drop(std::uint32_t body, const WriteBack& writeBack) {
    lists().forEach(body, [&](std::uint32_t slot) {
        takeOut(contacts_[slot], writeBack);
        noteEnd(contacts_[slot]);
        detach(slot);
    });
    bodyChanged(body);
}

/// Must be called before a contact leaves the list between two steps: keeps its record.
void ContactSet::takeOut(Contact& contact, const WriteBack& writeBack) {
    writeBack(contact);
    records_.keep(contact);
    contact.phase.reset();
}

void ContactSet::touchedBy(std::uint32_t body, std::vector<std::uint32_t>& others) {
    others.clear();
    lists().forEach(body, [&](std::uint32_t slot) {
        if (contacts_[slot].wasTouching) {
            const ContactKey& key = contacts_[slot].key;
            others.push_back(key.bodyA == body ? key.bodyB : key.bodyA);
        }
    });
}

void ContactSet::partRemoved(std::uint32_t body, std::size_t part) {
    writeRecords();
    eraseIf([&](std::uint32_t slot) {
        Contact& contact = contacts_[slot];
        bool gone = false;
        for (const bool isA : {true, false}) {
            std::uint16_t& own = isA ? contact.key.partA : contact.key.partB;
            if ((isA ? contact.key.bodyA : contact.key.bodyB) == body && own >= part) {
                gone = own == part;
                own = static_cast<std::uint16_t>(gone ? own : own - 1);
            }
        }
        if (gone) {
            noteEnd(contact);
        }
        return gone;
    });
    placesStale_ = true;
    bodyChanged(body);
}

/// Moves a contact between inactive bodies to idle_.
void ContactSet::takeIdle(std::uint32_t slot, const WriteBack& writeBack) {
    takeOut(contacts_[slot], writeBack);
    idle_.push_back(contacts_[slot]);
    Contact& taken = idle_.back();
    taken.row = {};
    if (taken.wasTouching) {
        countTouch(taken, false);
    }
    // Otherwise the step after putBack would report them again.
    taken.approachSpeed = 0;
    clearImpactImpulses(taken);
}

std::span<const Contact> ContactSet::takeIdle(const Bodies& bodies, const WriteBack& writeBack) {
    idle_.clear();
    eraseIf([&](std::uint32_t slot) {
        const ContactSummary& summary = summaries_[slot];
        const bool gone = !bodies.active(summary.bodyA) && !bodies.active(summary.bodyB);
        if (gone) {
            takeIdle(slot, writeBack);
        }
        return gone;
    });
    return idle_;
}

std::span<const Contact> ContactSet::takeIdle(const Bodies& bodies,
                                              std::span<const std::uint32_t> of,
                                              const WriteBack& writeBack) {
    idle_.clear();
    for (const std::uint32_t body : of) {
        lists().forEach(body, [&](std::uint32_t slot) {
            const ContactSummary& summary = summaries_[slot];
            if (!bodies.active(summary.bodyA) && !bodies.active(summary.bodyB)) {
                takeIdle(slot, writeBack);
                detach(slot);
            }
        });
    }
    settle();
    std::sort(idle_.begin(), idle_.end(), // total order: keys are unique
              [](const Contact& a, const Contact& b) { return a.key < b.key; });
    return idle_;
}

void ContactSet::putBack(std::span<const Contact> contacts, Bodies& bodies) {
    settle();
    const auto keyOf = [&](const Place& place) { return contacts_[place.slot].key; };
    slots_.resize(contacts.size());
    std::iota(slots_.begin(), slots_.end(), 0u);
    std::sort(slots_.begin(), slots_.end(), [&](std::uint32_t i, std::uint32_t k) { // total order
        return contacts[i].key != contacts[k].key ? contacts[i].key < contacts[k].key : i < k;
    });
    pairChanges_.clear();
    auto place = order_.begin();
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const Contact& contact = contacts[slots_[i]];
        if (i > 0 && contacts[slots_[i - 1]].key == contact.key) {
            continue;
        }
        place = std::lower_bound(
            place, order_.end(), contact.key,
            [&](const Place& at, const ContactKey& key) { return keyOf(at) < key; });
        if (place == order_.end() || keyOf(*place) != contact.key) {
            pairChanges_.push_back(
                {{0, 0}, static_cast<std::uint32_t>(place - order_.begin()), true});
            pairChanges_.back().pair.first = appendSlot(contact, bodies);
        }
    }
    insertPlaces();
}

/// Puts a contact into a new slot, without a place in order_.
std::uint32_t ContactSet::appendSlot(const Contact& contact, Bodies& bodies) {
    const auto slot = static_cast<std::uint32_t>(contacts_.size());
    contacts_.push_back(contact);
    summaries_.emplace_back();
    renewSummary(slot);
    if (lists_.isValid()) {
        lists_.add(slot, contact.key.bodyA, contact.key.bodyB);
    }
    ++reorderPolicy_.strayed;
    // Teleports during its absence from the list are not in the contact yet.
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    if (contact.teleportCountA != bodies.teleportCount[bodyA] ||
        contact.teleportCountB != bodies.teleportCount[bodyB]) {
        bodies.noteTeleport(bodyA);
        bodies.noteTeleport(bodyB);
    }
    if (contact.wasTouching) {
        countTouch(contact, true);
    }
    return slot;
}

/// Inserts the places of the contacts that putBack has appended; pairChanges_ has their slots, in
/// order.
void ContactSet::insertPlaces() {
    if (pairChanges_.empty()) {
        return;
    }
    changed();
    newOrder_.clear();
    newOrder_.reserve(std::max(order_.capacity(), order_.size() + pairChanges_.size()));
    auto next = order_.begin();
    for (const PairChange& change : pairChanges_) {
        const auto at = order_.begin() + static_cast<std::ptrdiff_t>(change.at);
        newOrder_.insert(newOrder_.end(), next, at);
        newOrder_.push_back({summaries_[change.pair.first].proxies, change.pair.first});
        next = at;
    }
    newOrder_.insert(newOrder_.end(), next, order_.end());
    std::swap(order_, newOrder_);
}

/// Rebuilds order_ from the contacts.
void ContactSet::orderContacts() {
    changed();
    lists_.forget();
    order_.resize(contacts_.size());
    for (std::uint32_t slot = 0; slot < order_.size(); ++slot) {
        order_[slot].slot = slot;
    }
    std::sort(order_.begin(), order_.end(), // total order: keys are unique
              [&](const Place& a, const Place& b) {
                  return contacts_[a.slot].key < contacts_[b.slot].key;
              });
    renewPlaces();
}

/// Updates all summaries and the pairs of bounds in order_.
void ContactSet::renewPlaces() {
    summaries_.resize(contacts_.size());
    for (Place& place : order_) {
        renewSummary(place.slot);
        place.pair = summaries_[place.slot].proxies;
    }
}

void ContactSet::renewSummary(std::uint32_t slot) {
    const Contact& contact = contacts_[slot];
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    const ContactSummary before = summaries_[slot];
    ContactSummary& summary = summaries_[slot];
    summary =
        ContactSummary::of(contact, {bounds_.indexOf(bodyA, partA), bounds_.indexOf(bodyB, partB)});
    if (contact.row.resident) { // the contact itself is out of date
        summary.approachSpeed = before.approachSpeed;
        summary.separation = before.separation;
    }
}

/// Rebuilds bounds and contacts for changes of any number of bodies.
void ContactSet::renew(const Bodies& bodies, const Tolerances& tolerances) {
    changed();
    bounds_.renew(bodies, tolerances);
    finder_.forget();
    still_.forget();
    resizeByBody(touches_, bodies);
    for (Contact& contact : contacts_) {
        describeContact(contact, bodies);
    }
    renewPlaces();
}

void ContactSet::bodyChanged(std::uint32_t body) {
    if (body >= hasChanged_.size()) {
        hasChanged_.resize(body + std::size_t{1}, 0);
    }
    if (std::exchange(hasChanged_[body], std::uint8_t{1}) == 0) {
        changes_.push_back(body);
    }
}

/// The same for the bodies in changes_ alone: updates their bounds and describes their contacts.
void ContactSet::renewChanged(const Bodies& bodies, const Tolerances& tolerances) {
    changed();
    std::sort(changes_.begin(), changes_.end()); // total order: bodies are unique
    resizeByBody(hasChanged_, bodies);
    resizeByBody(touches_, bodies);
    const std::size_t before = bounds_.size();
    const bool renumbered = bounds_.renew(bodies, tolerances, changes_);
    if (renumbered || bounds_.size() != before) {
        finder_.forget();
        movers_.forget();
    }
    still_.bodiesChanged(bodies, bounds_, changes_);
    if (renumbered) {
        renumberPairs();
    }
    for (const std::uint32_t body : changes_) {
        lists().forEach(body, [&](std::uint32_t slot) {
            describeContact(contacts_[slot], bodies);
            renewSummary(slot);
        });
    }
    if (std::exchange(placesStale_, false)) {
        for (Place& place : order_) {
            place.pair = summaries_[place.slot].proxies;
        }
    }
}

void ContactSet::compactBounds() {
    if (bounds_.compact()) {
        finder_.forget();
        movers_.forget();
        renewPlaces();
    }
}

/// The indices of parts have changed.
void ContactSet::renumberPairs() {
    for (Place& place : order_) {
        ContactSummary& summary = summaries_[place.slot];
        summary.proxies = {bounds_.indexNow(summary.proxies.first, summary.bodyA),
                           bounds_.indexNow(summary.proxies.second, summary.bodyB)};
    }
    placesStale_ = true;
}

void ContactSet::applyChanges(const Bodies& bodies, const Tolerances& tolerances) {
    settle();
    if (std::exchange(stale_, false)) {
        renew(bodies, tolerances);
        pairsStale_ = false;
    } else if (!changes_.empty()) {
        renewChanged(bodies, tolerances);
    }
    for (const std::uint32_t body : changes_) {
        hasChanged_[body] = 0;
    }
    changes_.clear();
    if (std::exchange(pairsStale_, false)) {
        bounds_.listAll();
    }
    for (const std::uint32_t body : activityChanges_) {
        bounds_.listBody(body);
    }
    activityChanges_.clear();
}

} // namespace KODO_PRECISION
} // namespace kodo
