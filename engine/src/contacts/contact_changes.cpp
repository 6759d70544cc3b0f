// SPDX-License-Identifier: MIT
// ContactSet: additions, removals and changes of bodies between two steps.
#include "contacts/contact_set.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

/// Removes the contacts for which gone(slot) is true, in the order of keys.
template <typename Gone>
void ContactSet::eraseIf(Gone gone) {
    settle();
    index_.forget();
    holes_.clear();
    std::erase_if(order_, [&](const Place& place) {
        const bool erased = gone(place.slot);
        if (erased) {
            holes_.push_back(place.slot);
        }
        return erased;
    });
    fillHoles();
}

void ContactSet::drop(std::uint32_t body, const std::function<void(Contact&)>& writeBack) {
    holes_.clear();
    for (const std::uint32_t place : placesOf(body)) {
        const std::uint32_t slot = std::exchange(order_[place].slot, kGone);
        if (slot == kGone) {
            continue;
        }
        Contact& contact = contacts_[slot];
        writeBack(contact);
        if (recordsDue_ && contact.phase) {
            recordContact(contact, dropped_);
        }
        noteEnd(contact);
        holes_.push_back(slot);
        anyGone_ = true;
    }
    fillHoles();
    bodyChanged(body);
}

/// Places of the contacts of a body in order_; some may be empty.
std::span<const std::uint32_t> ContactSet::placesOf(std::uint32_t body) {
    if (!index_.isValid()) {
        settle();
        index_.build(order_.size(), [&](std::size_t place) {
            const std::uint32_t slot = order_[place].slot;
            return ContactIndex::Entry{summaries_[slot].bodyA, summaries_[slot].bodyB, slot};
        });
    }
    return index_.placesOf(body);
}

void ContactSet::touchedBy(std::uint32_t body, std::vector<std::uint32_t>& others) {
    others.clear();
    for (const std::uint32_t place : placesOf(body)) {
        const std::uint32_t slot = order_[place].slot;
        if (slot != kGone && contacts_[slot].wasTouching) {
            const ContactKey& key = contacts_[slot].key;
            others.push_back(key.bodyA == body ? key.bodyB : key.bodyA);
        }
    }
}

/// Removes the places of dropped contacts from the order.
void ContactSet::settle() {
    if (std::exchange(anyGone_, false)) {
        std::erase_if(order_, [](const Place& place) { return place.slot == kGone; });
        index_.forget();
    }
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
    bodyChanged(body);
}

std::span<const Contact> ContactSet::takeIdle(const Bodies& bodies) {
    writeRecords();
    idle_.clear();
    eraseIf([&](std::uint32_t slot) {
        const Contact& contact = contacts_[slot];
        const bool gone = !bodies.active(contact.key.bodyA) && !bodies.active(contact.key.bodyB);
        if (gone) {
            idle_.push_back(contact);
            idle_.back().row = {};
            if (contact.wasTouching) {
                countTouch(contact, false);
            }
            // Otherwise the step after putBack would report them again.
            idle_.back().approachSpeed = 0;
            clearImpactImpulses(idle_.back());
        }
        return gone;
    });
    return idle_;
}

void ContactSet::putBack(std::span<const Contact> contacts, Bodies& bodies) {
    writeRecords();
    settle();
    const auto keyOf = [&](const Place& place) { return contacts_[place.slot].key; };
    for (const Contact& contact : contacts) {
        const auto place = std::lower_bound(
            order_.begin(), order_.end(), contact.key,
            [&](const Place& at, const ContactKey& key) { return keyOf(at) < key; });
        if (place == order_.end() || keyOf(*place) != contact.key) {
            contacts_.push_back(contact);
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
        }
    }
    orderContacts();
}

/// Rebuilds order_ from the contacts.
void ContactSet::orderContacts() {
    changed();
    index_.forget();
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
    touches_.resize(bodies.size());
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
    hasChanged_.resize(bodies.size(), 0);
    touches_.resize(bodies.size());
    if (bounds_.renew(bodies, tolerances, changes_)) {
        finder_.forget();
        movers_.forget();
    }
    still_.bodiesChanged(bodies, bounds_, changes_);
    for (std::uint32_t slot = 0; slot < summaries_.size(); ++slot) {
        ContactSummary& summary = summaries_[slot];
        if ((hasChanged_[summary.bodyA] | hasChanged_[summary.bodyB]) != 0) {
            describeContact(contacts_[slot], bodies);
            renewSummary(slot);
        } else {
            summary.proxies = {bounds_.indexNow(summary.proxies.first, summary.bodyA),
                               bounds_.indexNow(summary.proxies.second, summary.bodyB)};
        }
    }
    for (Place& place : order_) {
        place.pair = summaries_[place.slot].proxies;
    }
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
    for (const std::uint32_t body : stirred_) {
        bounds_.listBody(body);
    }
    stirred_.clear();
}

} // namespace KODO_PRECISION
} // namespace kodo
