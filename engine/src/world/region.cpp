// SPDX-License-Identifier: MIT
#include "base/checks.hpp"
#include "bodies/body_checks.hpp"
#include "contacts/contact_update.hpp"
#include "world/world_impl.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

void WorldImpl::setRegion(std::optional<Aabb> region) {
    if (region) {
        refuse(checkBox("region", *region));
    }
    region_ = region;
    for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
        if (bodies_.ids.aliveAt(body)) {
            updateRegion(body);
        }
    }
    parkContacts();
    // Sleeping bodies wake if they touch a body that is active again.
    std::vector<std::uint32_t> touched;
    sleep_.forEachContact([&](const Contact& contact) {
        const ContactKey& key = contact.key;
        if (contact.wasTouching && (bodies_.active(key.bodyA) || bodies_.active(key.bodyB))) {
            touched.push_back(bodies_.asleep(key.bodyA) ? key.bodyA : key.bodyB);
        }
    });
    for (const std::uint32_t body : touched) {
        wake(body);
    }
    bodies_.changes.allActivity = true;
    contacts_.activityChanged();
}

/// Updates kOutside after a change of the body or the region. True if the body has just left the
/// region.
bool WorldImpl::updateRegion(std::uint32_t body) {
    Flags& flags = bodies_.filter[body].flags;
    const bool waited = (flags & kOutside) != 0;
    const bool inside = !region_ || overlap(*region_, boundsOfBody(bodies_, body));
    flags = inside ? flags & ~kOutside : flags | kOutside;
    if (!inside) { // it stops, but keeps its velocity
        bodies_.motion[body].clearDisplacement();
    }
    bodies_.teleported(body);
    bodies_.noteActivity(body);
    return !inside && !waited;
}

/// The same for a body that may have contacts.
void WorldImpl::placeInRegion(std::uint32_t body) {
    if (updateRegion(body)) {
        contacts_.bodyChanged(body); // updates its bounds at the place where it stopped
        parkContacts();
    }
}

/// Parks contacts without an active body if a body is outside the region. They return when a body
/// becomes active: meanwhile they neither end nor begin.
void WorldImpl::parkContacts() {
    const auto waits = [&](std::uint32_t body) {
        return (bodies_.filter[body].flags & kOutside) != 0;
    };
    unpark([&](const Contact& contact) {
        return bodies_.active(contact.key.bodyA) || bodies_.active(contact.key.bodyB);
    });
    // Contacts of frozen bodies return to the list, since their end is not yet recorded.
    unparked_.clear();
    const std::span<const Contact> idle = contacts_.takeIdle(bodies_, writeBack());
    const auto byKey = [](const Contact& a, const Contact& b) { return a.key < b.key; };
    std::erase_if(parked_, [&](const Contact& old) { // found again since
        return std::binary_search(idle.begin(), idle.end(), old, byKey);
    });
    for (const Contact& contact : idle) {
        const bool aside = waits(contact.key.bodyA) || waits(contact.key.bodyB);
        (aside ? parked_ : unparked_).push_back(contact);
    }
    contacts_.putBack(unparked_, bodies_);
}

/// Returns the parked contacts for which which(contact) is true to the list.
template <typename Which>
void WorldImpl::unpark(Which which) {
    unparked_.clear();
    std::erase_if(parked_, [&](const Contact& contact) {
        const bool back = which(contact);
        if (back) {
            unparked_.push_back(contact);
            describeContact(unparked_.back(), bodies_); // its bodies may have changed since
        }
        return back;
    });
    contacts_.putBack(unparked_, bodies_);
}

void WorldImpl::unparkContactsOf(std::uint32_t body) {
    if (!parked_.empty()) {
        unpark([=](const Contact& contact) {
            return contact.key.bodyA == body || contact.key.bodyB == body;
        });
    }
}

/// Bodies outside the region count as static during the solve, for touching contacts and joints.
void WorldImpl::makeOutsideStatic() {
    const auto hold = [&](std::uint32_t body) {
        BodyVelocity& motion = bodies_.motion[body];
        const bool still =
            bodies_.locked(body) && motion.velocity == Vec2{} && motion.angularVelocity == 0;
        if ((bodies_.filter[body].flags & kOutside) != 0 && !still) {
            outsideVelocities_.emplace_back(body, std::exchange(motion, {}));
        }
    };
    for (const Contact& contact : contacts_.contacts()) {
        hold(contact.key.bodyA);
        hold(contact.key.bodyB);
    }
    joints_.forEachBusy([&](const JointSet::Joint& joint) {
        hold(firstBody(joint.def).index);
        hold(secondBody(joint.def).index);
    });
    if (!outsideVelocities_.empty()) {
        softSolver_.blocks().evictAll(contacts_.contacts(), bodies_);
        contacts_.measureApproach(bodies_); // measured with the velocities that are restored later
    }
}

void WorldImpl::restoreOutside() {
    for (const auto& [body, motion] : outsideVelocities_) {
        bodies_.motion[body] = motion;
    }
    outsideVelocities_.clear();
}

} // namespace KODO_PRECISION
} // namespace kodo
