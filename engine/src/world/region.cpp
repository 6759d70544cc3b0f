// SPDX-License-Identifier: MIT
#include "world/region.hpp"

#include "contacts/contact_update.hpp"

#include <algorithm>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

bool Region::contains(const Bodies& bodies, std::uint32_t body) const {
    return !box_ || overlap(*box_, boundsOfBody(bodies, body));
}

bool Region::update(Bodies& bodies, std::uint32_t body) const {
    Flags& flags = bodies.filter[body].flags;
    const bool waited = (flags & kOutside) != 0;
    const bool inside = contains(bodies, body);
    flags = inside ? flags & ~kOutside : flags | kOutside;
    if (!inside) { // it stops, but keeps its velocity
        bodies.motion[body].clearDisplacement();
    }
    bodies.teleported(body);
    bodies.noteActivity(body);
    return !inside && !waited;
}

void Region::place(std::uint32_t body, Bodies& bodies, ContactSet& contacts,
                   const WriteBack& writeBack) {
    if (update(bodies, body)) {
        contacts.bodyChanged(body); // updates its bounds at the place where it stopped
        park(bodies, contacts, writeBack);
    }
}

void Region::park(Bodies& bodies, ContactSet& contacts, const WriteBack& writeBack) {
    const auto waits = [&](std::uint32_t body) {
        return (bodies.filter[body].flags & kOutside) != 0;
    };
    const auto isActive = [&](const Contact& contact) {
        return bodies.active(contact.key.bodyA) || bodies.active(contact.key.bodyB);
    };
    unpark(isActive, bodies, contacts);
    // Contacts of frozen bodies return to the list, since their end is not yet recorded.
    unparked_.clear();
    const std::span<const Contact> idle = contacts.takeIdle(bodies, writeBack);
    const auto byKey = [](const Contact& a, const Contact& b) { return a.key < b.key; };
    std::erase_if(parked_, [&](const Contact& old) { // found again since
        return std::binary_search(idle.begin(), idle.end(), old, byKey);
    });
    for (const Contact& contact : idle) {
        const bool aside = waits(contact.key.bodyA) || waits(contact.key.bodyB);
        (aside ? parked_ : unparked_).push_back(contact);
    }
    contacts.putBack(unparked_, bodies);
}

/// Returns the parked contacts for which which(contact) is true to the list.
template <typename Which>
void Region::unpark(Which which, Bodies& bodies, ContactSet& contacts) {
    unparked_.clear();
    std::erase_if(parked_, [&](const Contact& contact) {
        const bool back = which(contact);
        if (back) {
            unparked_.push_back(contact);
            describeContact(unparked_.back(), bodies); // its bodies may have changed since
        }
        return back;
    });
    contacts.putBack(unparked_, bodies);
}

void Region::unparkContactsOf(std::uint32_t body, Bodies& bodies, ContactSet& contacts) {
    if (!parked_.empty()) {
        const auto isOwn = [=](const Contact& contact) {
            return contact.key.bodyA == body || contact.key.bodyB == body;
        };
        unpark(isOwn, bodies, contacts);
    }
}

bool Region::makeOutsideStatic(Bodies& bodies, const ContactSet& contacts, const JointSet& joints) {
    const auto hold = [&](std::uint32_t body) {
        BodyVelocity& motion = bodies.motion[body];
        const bool still =
            bodies.locked(body) && motion.velocity == Vec2{} && motion.angularVelocity == 0;
        if ((bodies.filter[body].flags & kOutside) != 0 && !still) {
            outsideVelocities_.emplace_back(body, std::exchange(motion, {}));
        }
    };
    for (const Contact& contact : contacts.contacts()) {
        hold(contact.key.bodyA);
        hold(contact.key.bodyB);
    }
    joints.forEachBusy([&](const JointSet::Joint& joint) {
        hold(firstBody(joint.def).index);
        hold(secondBody(joint.def).index);
    });
    return !outsideVelocities_.empty();
}

void Region::restoreOutside(Bodies& bodies) {
    for (const auto& [body, motion] : outsideVelocities_) {
        bodies.motion[body] = motion;
    }
    outsideVelocities_.clear();
}

} // namespace KODO_PRECISION
} // namespace kodo
