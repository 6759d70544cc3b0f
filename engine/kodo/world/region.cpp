// SPDX-License-Identifier: MIT
#include <kodo/contacts/contact_update.hpp>
#include <kodo/world/world.hpp>

#include <utility>

namespace kodo::inline KODO_PRECISION {

void World::setRegion(std::optional<Aabb> region) {
    if (region && !(region->lower.x <= region->upper.x && region->lower.y <= region->upper.y)) {
        throw BadDefinition({"region", "must have its lower corner below and left of its upper"});
    }
    region_ = region;
    for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
        if (bodies_.ids.aliveAt(body)) {
            askRegion(body);
        }
    }
    putContactsAside();
    // What rests and is touched by what takes part again wakes with the contact that it has kept.
    std::vector<std::uint32_t> touched;
    rest_.forEachContact([&](const Contact& contact) {
        const ContactKey& key = contact.key;
        if (contact.wasTouching && (bodies_.active(key.bodyA) || bodies_.active(key.bodyB))) {
            touched.push_back(bodies_.resting(key.bodyA) ? key.bodyA : key.bodyB);
        }
    });
    for (const std::uint32_t body : touched) {
        wake(body);
    }
    bodies_.awakeStale = true;
    contacts_.activityChanged();
}

/// Asks anew whether a body takes part in steps or waits, since it or the region has changed. True
/// if it has just left.
bool World::askRegion(std::uint32_t body) {
    Flags& flags = bodies_.filter[body].flags;
    const bool waited = (flags & kOutside) != 0;
    const bool inside = !region_ || overlap(*region_, boundsOfBody(bodies_, body));
    flags = inside ? flags & ~kOutside : flags | kOutside;
    if (!inside) { // it has come to a stand, although it keeps its velocity
        bodies_.motion[body].halt();
    }
    bodies_.jumped(body);
    bodies_.awakeStale = true;
    return !inside && !waited;
}

/// The same for one that may have contacts.
void World::placeInRegion(std::uint32_t body) {
    if (askRegion(body)) {
        contacts_.bodyChanged(body); // its bounds are to be those of where it waits
        putContactsAside();
    }
}

/// Contacts of which no body takes part since one waits are put aside, and come back when one does
/// again: meanwhile they neither end nor begin.
void World::putContactsAside() {
    fetchContacts();
    const auto waits = [&](std::uint32_t body) {
        return (bodies_.filter[body].flags & kOutside) != 0;
    };
    takeBack([&](const Contact& contact) {
        return bodies_.active(contact.key.bodyA) || bodies_.active(contact.key.bodyB);
    });
    // Contacts of what froze go back into the list: that they end is yet to be recorded.
    returning_.clear();
    const std::span<const Contact> idle = contacts_.takeIdle(bodies_);
    const auto byKey = [](const Contact& a, const Contact& b) { return a.key < b.key; };
    std::erase_if(aside_, [&](const Contact& old) { // one that was found again meanwhile
        return std::binary_search(idle.begin(), idle.end(), old, byKey);
    });
    for (const Contact& contact : idle) {
        const bool aside = waits(contact.key.bodyA) || waits(contact.key.bodyB);
        (aside ? aside_ : returning_).push_back(contact);
    }
    contacts_.putBack(returning_, bodies_);
}

/// Puts back the contacts that which(contact) names.
template <typename Which>
void World::takeBack(Which which) {
    returning_.clear();
    std::erase_if(aside_, [&](const Contact& contact) {
        const bool back = which(contact);
        if (back) {
            returning_.push_back(contact);
            describeContact(returning_.back(), bodies_); // its bodies may have changed since
        }
        return back;
    });
    contacts_.putBack(returning_, bodies_);
}

void World::takeBackContactsOf(std::uint32_t body) {
    if (!aside_.empty()) {
        fetchContacts();
        takeBack([=](const Contact& contact) {
            return contact.key.bodyA == body || contact.key.bodyB == body;
        });
    }
}

/// For the time of the solver, what waits is a wall to what touches it or is tied to it: it stands
/// and cannot be pushed.
void World::holdWhatWaits() {
    const auto hold = [&](std::uint32_t body) {
        Motion& motion = bodies_.motion[body];
        const bool still =
            bodies_.locked(body) && motion.velocity == Vec2{} && motion.angularVelocity == 0;
        if ((bodies_.filter[body].flags & kOutside) != 0 && !still) {
            held_.emplace_back(body, std::exchange(motion, {}));
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
    if (!held_.empty()) {
        softStep_.blocks().reclaimAll(contacts_.contacts(), bodies_);
        contacts_.measureApproach(bodies_); // it was measured with the speeds that they keep
    }
}

void World::releaseWhatWaits() {
    for (const auto& [body, motion] : held_) {
        bodies_.motion[body] = motion;
    }
    held_.clear();
}

} // namespace kodo::inline KODO_PRECISION
