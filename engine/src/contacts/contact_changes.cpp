// SPDX-License-Identifier: MIT
// ContactSet: additions, removals and changes of bodies between two steps.
#include "contacts/contact_set.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

/// Frees the slots of removed contacts.
void ContactSet::freeDetached() {
    if (store_.freeDetached()) {
        store_.renumber(records_.toggled());
        changed();
    }
}

void ContactSet::drop(std::uint32_t body, const Bodies& bodies) {
    store_.lists().forEach(body, [&](std::uint32_t slot) {
        addEnd(takeOut(slot, bodies));
        store_.detach(slot);
    });
    bodyChanged(body);
}

/// Must be called before a contact leaves the list between two steps: keeps its record.
StoredContact ContactSet::takeOut(std::uint32_t slot, const Bodies& bodies) {
    StoredContact contact = store_.copyOf(slot, bodies);
    records_.keep(contact);
    contact.phase.reset();
    return contact;
}

void ContactSet::touchedBy(std::uint32_t body, std::vector<std::uint32_t>& others) {
    others.clear();
    store_.lists().forEach(body, [&](std::uint32_t slot) {
        if (contacts()[slot].wasTouching) {
            const ContactKey& key = contacts()[slot].key;
            others.push_back(key.other(body));
        }
    });
}

void ContactSet::partRemoved(std::uint32_t body, std::size_t part, const Bodies& bodies) {
    store_.lists().forEach(body, [&](std::uint32_t slot) {
        Contact& contact = contacts()[slot];
        std::uint16_t& own = contact.key.bodyA == body ? contact.key.partA : contact.key.partB;
        if (own < part) {
            return;
        }
        const StoredContact before = takeOut(slot, bodies); // before its key changes
        contact.phase.reset();
        if (own > part) {
            --own;
            return;
        }
        addEnd(before);
        store_.detach(slot);
    });
    store_.partsChanged();
    bodyChanged(body);
}

/// Moves a contact between inactive bodies to idle_.
void ContactSet::takeIdle(std::uint32_t slot, const Bodies& bodies) {
    StoredContact& taken = idle_.emplace_back(takeOut(slot, bodies));
    taken.row = {};
    if (taken.wasTouching) {
        touchCounts_.count(taken, false);
    }
    // Otherwise the step after putBack would report them again.
    taken.numbers.approachSpeed = 0;
    taken.numbers.total = {};
    for (PointImpulse& impulse : taken.numbers.impulse) {
        impulse = {.normal = impulse.normal};
    }
}

std::span<const StoredContact>
ContactSet::takeIdle(const Bodies& bodies, std::span<const std::uint32_t> of, Flags states) {
    const auto isIdle = [&](const ContactSummary& summary) {
        const Flags either =
            bodies.filter[summary.bodyA].flags | bodies.filter[summary.bodyB].flags;
        return !bodies.active(summary.bodyA) && !bodies.active(summary.bodyB) &&
               (states == 0 || (either & (kAsleep | kOutside)) == states);
    };
    idle_.clear();
    for (const std::uint32_t body : of) {
        store_.lists().forEach(body, [&](std::uint32_t slot) {
            if (isIdle(summaries()[slot])) {
                takeIdle(slot, bodies);
                store_.detach(slot);
            }
        });
    }
    freeDetached();
    std::sort(idle_.begin(), idle_.end(), // total order: keys are unique
              [](const Contact& a, const Contact& b) { return a.key < b.key; });
    return idle_;
}

std::span<const StoredContact> ContactSet::takeArrivals(const Bodies& bodies) {
    if (!allArrived_ && arrivals_.empty()) {
        return {};
    }
    if (std::exchange(allArrived_, false)) {
        arrivals_ = allIndices(bodies.size());
    }
    takeIdle(bodies, arrivals_, kAsleep);
    arrivals_.clear();
    return idle_;
}

void ContactSet::putBack(std::span<const StoredContact> returning, Bodies& bodies) {
    freeDetached();
    const std::span<const std::uint32_t> slots = store_.putBack(returning, candidates_.bounds());
    for (const std::uint32_t slot : slots) {
        const Contact& contact = contacts()[slot];
        // Teleports during its absence from the list are not in the contact yet.
        if (contact.teleportCounts[0] != bodies.teleportCount[contact.key.bodyA] ||
            contact.teleportCounts[1] != bodies.teleportCount[contact.key.bodyB]) {
            bodies.noteTeleport(contact.key.bodyA);
            bodies.noteTeleport(contact.key.bodyB);
        }
        if (contact.wasTouching) {
            touchCounts_.count(contact, true);
        }
    }
    if (!slots.empty()) {
        changed();
    }
}

void ContactSet::bodyChanged(std::uint32_t body) {
    if (body >= hasChanged_.size()) {
        hasChanged_.resize(body + std::size_t{1}, Change::None);
    }
    if (std::exchange(hasChanged_[body], Change::Any) == Change::None) {
        changes_.push_back(body);
    }
}

void ContactSet::bodyChanged(const Bodies& bodies, const Tolerances& tolerances,
                             std::uint32_t body) {
    bodyChanged(body);
    candidates_.renew(bodies, tolerances, body);
    hasChanged_[body] = Change::Bounded;
}

/// Updates the bounds of the bodies in changes_ and describes their contacts.
void ContactSet::renewChanged(const Bodies& bodies, const Tolerances& tolerances) {
    changed();
    std::sort(changes_.begin(), changes_.end()); // total order: bodies are unique
    resizeByBody(hasChanged_, bodies);
    touchCounts_.resize(bodies);
    for (const std::uint32_t body : changes_) {
        if (hasChanged_[body] == Change::Any) {
            candidates_.renew(bodies, tolerances, body);
        }
    }
    PartBounds& bounds = candidates_.bounds();
    if (bounds.takeMoved()) {
        store_.partsChanged();
    }
    for (const std::uint32_t body : changes_) {
        store_.describe(body, bodies, bounds);
    }
    store_.refreshPlaces();
}

void ContactSet::addArrivals(std::span<const std::uint32_t> bodies) {
    arrivals_.insert(arrivals_.end(), bodies.begin(), bodies.end());
    if (arrivals_.size() > candidates_.bounds().size()) {
        allArrived_ = true;
        arrivals_.clear();
    }
}

void ContactSet::applyChanges(const Bodies& bodies, const Tolerances& tolerances) {
    freeDetached();
    if (stale_ || pairsStale_) {
        allArrived_ = true;
    } else if (!changes_.empty() || !activityChanges_.empty()) {
        addArrivals(changes_);
        addArrivals(activityChanges_);
    }
    if (std::exchange(stale_, false)) {
        changed();
        candidates_.renew(bodies, tolerances);
        touchCounts_.resize(bodies);
        store_.describe(bodies, candidates_.bounds());
        pairsStale_ = false;
    } else if (!changes_.empty()) {
        renewChanged(bodies, tolerances);
    }
    for (const std::uint32_t body : changes_) {
        hasChanged_[body] = Change::None;
    }
    changes_.clear();
    PartBounds& bounds = candidates_.bounds();
    if (candidates_.renumberIfDue(bodies, store_.size())) {
        store_.renumberBounds(bounds);
    }
    if (std::exchange(pairsStale_, false)) {
        bounds.listAll();
    }
    for (const std::uint32_t body : activityChanges_) {
        bounds.listBody(body);
    }
    activityChanges_.clear();
}

} // namespace KODO_PRECISION
} // namespace kodo
