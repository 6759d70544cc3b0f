// SPDX-License-Identifier: MIT
#include "world/region.hpp"

#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Calls visit(strip) for the parts of a box beyond each side of another one: what meets `box`
/// alone meets one of them. They may overlap.
template <typename Visit>
void forEachStrip(const Aabb& box, const Aabb& other, Visit visit) {
    const auto visitIf = [&](const Aabb& strip) {
        if (strip.lower.x <= strip.upper.x && strip.lower.y <= strip.upper.y) {
            visit(strip);
        }
    };
    const auto& [lower, upper] = box;
    visitIf({lower, {std::min(upper.x, other.lower.x), upper.y}});
    visitIf({lower, {upper.x, std::min(upper.y, other.lower.y)}});
    visitIf({{std::max(lower.x, other.upper.x), lower.y}, upper});
    visitIf({{lower.x, std::max(lower.y, other.upper.y)}, upper});
}

/// True if the disc around the body is inside the box, with a margin for rounding. Cheaper than the
/// bounds of the body.
bool isWellInside(const Aabb& box, const Bodies& bodies, std::uint32_t body) {
    const Vec2 center = bodies.pose[body].position;
    const Real rounding = (std::abs(center.x) + std::abs(center.y)) / Real(1 << 18);
    const Real reach = Real(1.01) * bodies.geometry(body).boundingRadius + rounding;
    return center.x - reach > box.lower.x && center.x + reach < box.upper.x &&
           center.y - reach > box.lower.y && center.y + reach < box.upper.y;
}

/// True for contacts with an active body.
auto hasActive(const Bodies& bodies) {
    return [&bodies](const Contact& contact) {
        return bodies.active(contact.key.bodyA) || bodies.active(contact.key.bodyB);
    };
}

} // namespace

bool Region::contains(const Bodies& bodies, std::uint32_t body) const {
    return !box_ || isWellInside(*box_, bodies, body) || overlap(*box_, boundsOfBody(bodies, body));
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

void Region::place(std::uint32_t body, Bodies& bodies, ContactSet& contacts) {
    if (update(bodies, body)) {
        contacts.bodyChanged(body); // updates its bounds at the place where it stopped
        park({&body, 1}, bodies, contacts);
    }
}

std::vector<std::uint32_t> Region::mayCross(const Aabb& before, const Bodies& bodies,
                                            const CandidatePairs& parts) const {
    const PartBounds& bounds = parts.bounds();
    std::vector<std::uint32_t> found = bodies.awake;
    const auto add = [&](std::uint32_t i) { found.push_back(bounds.part(i).body); };
    std::for_each(parts.planes().begin(), parts.planes().end(), add);
    // The parts of a body may leave a gap, which is within its bounds.
    for (std::uint32_t body = 0; body < bounds.bodyCount(); ++body) {
        if (bounds.countOf(body) > 1) {
            found.push_back(body);
        }
    }
    const auto search = [&](const Aabb& strip) { parts.trees().overlaps(strip, add); };
    forEachStrip(before, *box_, search);
    forEachStrip(*box_, before, search);
    sortUnique(found);
    return found;
}

void Region::moveInOut(std::vector<std::uint32_t>& candidates, Bodies& bodies,
                       ContactSet& contacts) {
    std::erase_if(candidates, [&](std::uint32_t body) {
        const bool isOutside = (bodies.filter[body].flags & kOutside) != 0;
        return !bodies.ids.aliveAt(body) || isOutside != contains(bodies, body);
    });
    if (candidates.empty()) {
        return;
    }
    for (const std::uint32_t body : candidates) {
        update(bodies, body);
        contacts.activityChanged(body);
    }
    park(candidates, bodies, contacts);
}

void Region::park(std::span<const std::uint32_t> of, Bodies& bodies, ContactSet& contacts) {
    parked_.take(of, hasActive(bodies), unparked_);
    putBack(bodies, contacts);
    setAside(contacts.takeIdle(bodies, of), of, bodies, contacts);
}

void Region::followActivity(Bodies& bodies, ContactSet& contacts) {
    if (parked_.isEmpty()) {
        return;
    }
    if (const auto changed = contacts.activityChanges()) {
        parked_.take(*changed, hasActive(bodies), unparked_);
    } else {
        parked_.take(hasActive(bodies), unparked_);
    }
    putBack(bodies, contacts);
}

/// Parks those of the idle contacts `of` some bodies that have a body outside.
void Region::setAside(std::span<const StoredContact> idle, std::span<const std::uint32_t> of,
                      Bodies& bodies, ContactSet& contacts) {
    const auto waits = [&](std::uint32_t body) {
        return (bodies.filter[body].flags & kOutside) != 0;
    };
    const auto byKey = [](const Contact& a, const Contact& b) { return a.key < b.key; };
    const auto wasFoundAgain = [&](const Contact& old) {
        return std::binary_search(idle.begin(), idle.end(), old, byKey);
    };
    parked_.take(of, wasFoundAgain, unparked_);
    // Contacts of frozen bodies return to the list, since their end is not yet recorded.
    unparked_.clear();
    for (const StoredContact& contact : idle) {
        if (waits(contact.key.bodyA) || waits(contact.key.bodyB)) {
            parked_.add(contact);
        } else {
            unparked_.push_back(contact);
        }
    }
    contacts.putBack(unparked_, bodies);
    unparked_.clear();
}

/// Returns unparked_ to the list.
void Region::putBack(Bodies& bodies, ContactSet& contacts) {
    if (unparked_.empty()) {
        return;
    }
    for (StoredContact& contact : unparked_) {
        describeContact(contact, bodies); // its bodies may have changed since
    }
    contacts.putBack(unparked_, bodies);
    unparked_.clear();
}

void Region::unparkContactsOf(std::uint32_t body, Bodies& bodies, ContactSet& contacts) {
    parked_.take(
        {&body, 1}, [](const Contact&) { return true; }, unparked_);
    putBack(bodies, contacts);
}

void Region::makeOutsideStatic(Bodies& bodies, const ContactSet& contacts, const JointSet& joints) {
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
}

void Region::restoreOutside(Bodies& bodies) {
    for (const auto& [body, motion] : outsideVelocities_) {
        bodies.motion[body] = motion;
    }
    outsideVelocities_.clear();
}

void Region::visitState(StateStream& stream, const Bodies& bodies) {
    auto& [box, outsideVelocities, parked, unparked] = *this;
    stream(box);
    require(!box || (box->lower.x <= box->upper.x && box->lower.y <= box->upper.y),
            "the region has its corners swapped");
    parked.visitState(stream, bodies);
}

} // namespace KODO_PRECISION
} // namespace kodo
