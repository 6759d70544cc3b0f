// SPDX-License-Identifier: MIT
// What a ContactSet does when bodies come, go or change between two steps.
#include <kodo/contacts/contact_set.hpp>
#include <kodo/contacts/contact_update.hpp>

#include <algorithm>
#include <utility>

namespace kodo::inline KODO_PRECISION {

/// Takes out the contacts that gone(slot) names, in the order of keys.
template <typename Gone>
void ContactSet::eraseIf(Gone gone) {
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

void ContactSet::drop(std::uint32_t body, const std::function<void(Contact&)>& fetch) {
    eraseIf([&](std::uint32_t slot) {
        const bool gone = heads_[slot].bodyA == body || heads_[slot].bodyB == body;
        if (gone) {
            Contact& contact = contacts_[slot];
            fetch(contact);
            if (recordsDue_ && contact.phase) {
                recordContact(contact, dropped_);
            }
            noteEnd(contact);
        }
        return gone;
    });
    bodyChanged(body);
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
            // Or a step that it comes back in would report them again.
            idle_.back().approachSpeed = 0;
            forgetBlows(idle_.back());
        }
        return gone;
    });
    return idle_;
}

void ContactSet::putBack(std::span<const Contact> contacts, Bodies& bodies) {
    writeRecords();
    const auto keyOf = [&](const Place& place) { return contacts_[place.slot].key; };
    for (const Contact& contact : contacts) {
        const auto place = std::lower_bound(
            order_.begin(), order_.end(), contact.key,
            [&](const Place& at, const ContactKey& key) { return keyOf(at) < key; });
        if (place == order_.end() || keyOf(*place) != contact.key) {
            contacts_.push_back(contact);
            ++disorder_.strayed;
            // What happened to its bodies meanwhile is news to the contact.
            const auto& [bodyA, partA, bodyB, partB] = contact.key;
            if (contact.jumpsA != bodies.jumps[bodyA] || contact.jumpsB != bodies.jumps[bodyB]) {
                bodies.noteJump(bodyA);
                bodies.noteJump(bodyB);
            }
            if (contact.wasTouching) {
                countTouch(contact, true);
            }
        }
    }
    orderContacts();
}

/// Makes the order anew from the contacts.
void ContactSet::orderContacts() {
    changed();
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

/// Finds the bounds of all contacts again.
void ContactSet::renewPlaces() {
    heads_.resize(contacts_.size());
    for (Place& place : order_) {
        renewHead(place.slot);
        place.pair = heads_[place.slot].proxies;
    }
}

void ContactSet::renewHead(std::uint32_t slot) {
    const Contact& contact = contacts_[slot];
    const auto& [bodyA, partA, bodyB, partB] = contact.key;
    const ContactHead before = heads_[slot];
    ContactHead& head = heads_[slot];
    head = ContactHead::of(contact, {bounds_.indexOf(bodyA, partA), bounds_.indexOf(bodyB, partB)});
    if (contact.row.lent) { // the contact is out of date
        head.approachSpeed = before.approachSpeed;
        head.separation = before.separation;
    }
}

/// After many bodies came, went or changed.
void ContactSet::renew(const Bodies& bodies, const Tolerances& tolerances) {
    changed();
    bounds_.renew(bodies, tolerances);
    finder_.forget();
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

/// After some did: only their bounds are new, and only their contacts are described anew.
void ContactSet::renewChanged(const Bodies& bodies, const Tolerances& tolerances) {
    changed();
    std::sort(changes_.begin(), changes_.end()); // total order: bodies are unique
    hasChanged_.resize(bodies.size(), 0);
    touches_.resize(bodies.size());
    if (bounds_.renew(bodies, tolerances, changes_)) {
        finder_.forget();
    }
    for (std::uint32_t slot = 0; slot < heads_.size(); ++slot) {
        ContactHead& head = heads_[slot];
        if ((hasChanged_[head.bodyA] | hasChanged_[head.bodyB]) != 0) {
            describeContact(contacts_[slot], bodies);
            renewHead(slot);
        } else {
            head.proxies = {bounds_.indexNow(head.proxies.first, head.bodyA),
                            bounds_.indexNow(head.proxies.second, head.bodyB)};
        }
    }
    for (Place& place : order_) {
        place.pair = heads_[place.slot].proxies;
    }
}

void ContactSet::applyChanges(const Bodies& bodies, const Tolerances& tolerances) {
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

} // namespace kodo::inline KODO_PRECISION
