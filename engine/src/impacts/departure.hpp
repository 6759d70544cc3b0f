// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "bodies/joint_lists.hpp"
#include "contacts/contact_store.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <limits>

#include "lanes/contact.hpp"
#include "lanes/contact_lane.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// How the bodies of a touching contact part at the start of the solve.
enum class Departure {
    None,           // they stay together, as far as their velocities tell
    Whole,          // all points leave after an impact, and stay apart until the end of the step
    BetweenImpacts, // with restitution: what touches leaves, another point may come
};

/// True if a joint holds a body of a contact that moves: the joint would go on pulling it into the
/// other one, as a third body would.
inline bool isJointed(const Bodies& bodies, const JointLists& joints, const ContactKey& key) {
    return (!bodies.locked(key.bodyA) && joints.hasAny(key.bodyA)) ||
           (!bodies.locked(key.bodyB) && joints.hasAny(key.bodyB));
}

/// True if no third body that moves touches the bodies of a contact. It would go on where
/// continuous collision stops these, since it pushes them only in the next step.
inline bool isAlone(const Bodies& bodies, const ContactStore& store, std::uint32_t slot,
                    Real slop) {
    const ContactKey& key = store.contacts()[slot].key;
    bool alone = true;
    for (const std::uint32_t body : {key.bodyA, key.bodyB}) {
        if (bodies.locked(body)) {
            continue;
        }
        store.lists().forEach(body, [&](std::uint32_t other) {
            const Contact& contact = store.contacts()[other];
            const std::uint32_t third = contact.key.other(body);
            const bool ofPair = third == key.bodyA || third == key.bodyB;
            alone = alone && (ofPair || bodies.isStill(third) || !contact.responds() ||
                              store.separation(other) > slop);
        });
    }
    return alone;
}

/// Departure of a contact in a step of dt (s); `bounces`: it has restitution in this step, and no
/// joint holds its bodies. Between impacts a contact needs no row: braking the point that comes
/// would take its rebound, as with a contact that does not touch yet. Continuous collision stops
/// the bodies where it arrives.
inline Departure departureOf(const Bodies& bodies, ContactStore& store, std::uint32_t slot,
                             bool bounces, Real slop, Real dt) {
    const Contact& contact = store.contacts()[slot];
    const ContactLane lane = store.lane(slot);
    constexpr Real kDeparts = Real(1) / 8; // slops in a step, without an impact in it
    const bool hit = lane.impacts() > 0;
    if (!hit && !bounces) {
        return Departure::None;
    }
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    const Vec2 n = contact.manifold.normal;
    // Speed (m/s) that forces which press the bodies together take within half of the step.
    const Real pressing = std::max(
        dot(n, bodies.acceleration[bodyA].linear - bodies.acceleration[bodyB].linear) * dt / 2,
        Real(0));
    Real touching = std::numeric_limits<Real>::max(); // m/s, least separating speed there
    Real beyond = touching;                           // likewise, of the points beyond the slop
    for (std::size_t i = 0; i < static_cast<std::size_t>(contact.manifold.count); ++i) {
        const ManifoldPoint& p = contact.manifold.points[i];
        const Vec2 apart =
            velocityAt(bodies.motion[bodyB], p.armB) - velocityAt(bodies.motion[bodyA], p.armA);
        Real& least = lane.separation(i) <= slop ? touching : beyond;
        least = std::min(least, dot(n, apart));
    }
    const auto wayOf = [&](std::uint32_t body) { // m, of a point by rotation
        return std::abs(bodies.motion[body].angularVelocity) * bodies.extent[body].rotationReach *
               dt;
    };
    const bool turns = wayOf(bodyA) + wayOf(bodyB) > slop; // another point may come
    const Real leaving = pressing + (hit ? Real(0) : kDeparts * slop / dt);
    if (bounces && touching >= leaving && (beyond < pressing || turns) &&
        isAlone(bodies, store, slot, slop)) {
        return Departure::BetweenImpacts;
    }
    return hit && std::min(touching, beyond) >= pressing ? Departure::Whole : Departure::None;
}

} // namespace KODO_PRECISION
} // namespace kodo
