// SPDX-License-Identifier: MIT
#include "continuous/relative_motion.hpp"

#include <kodo/geometry.hpp>

#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>

#include "impacts/departure.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// Bound (m) of the motion of a body relative to a locked one, which nothing stops. It is 0 for a
/// body that rests on a rotating floor.
Real motionSeenFrom(const Bodies& bodies, std::uint32_t locked, std::uint32_t other,
                    Real rotationReach) {
    const BodyVelocity& floor = bodies.motion[locked];
    const BodyVelocity& motion = bodies.motion[other];
    const Vec2 arm = bodies.pose[other].position - bodies.pose[locked].position;
    const Vec2 carried = floor.deltaPosition + cross(floor.deltaAngle, arm);
    // m, distance of the arc from its tangent
    const Real bend = floor.deltaAngle * floor.deltaAngle / 2 * length(arm);
    return length(motion.deltaPosition - carried) + bend +
           std::abs(motion.deltaAngle - floor.deltaAngle) * rotationReach;
}

} // namespace

Real relativeMotion(const Bodies& bodies, const MovingBody& movingA, const MovingBody& movingB) {
    const auto& [bodyA, rotationReachA, stopA] = movingA;
    const auto& [bodyB, rotationReachB, stopB] = movingB;
    const BodyVelocity& a = bodies.motion[bodyA];
    const BodyVelocity& b = bodies.motion[bodyB];
    // The sum of both motions is a bound, too. Without it, a pair that ContinuousCollision excludes
    // by the motion of each body could count as fast.
    if (a.locked()) {
        return std::min(motionSeenFrom(bodies, bodyA, bodyB, rotationReachB),
                        a.way(rotationReachA) + b.way(rotationReachB));
    }
    if (b.locked()) {
        return std::min(motionSeenFrom(bodies, bodyB, bodyA, rotationReachA),
                        a.way(rotationReachA) + b.way(rotationReachB));
    }
    const Real alone = stopA == stopB  ? 0
                       : stopA > stopB ? (stopA - stopB) * length(a.deltaPosition)
                                       : (stopB - stopA) * length(b.deltaPosition);
    return std::min(stopA, stopB) * length(b.deltaPosition - a.deltaPosition) + alone +
           stopA * std::abs(a.deltaAngle) * rotationReachA +
           stopB * std::abs(b.deltaAngle) * rotationReachB;
}

Real motionAgainst(const Bodies& bodies, Vec2 normal, const MovingBody& movingA,
                   const MovingBody& movingB) {
    const BodyVelocity& a = bodies.motion[movingA.body];
    const BodyVelocity& b = bodies.motion[movingB.body];
    return dot(normal, movingA.stopAt * a.deltaPosition - movingB.stopAt * b.deltaPosition) +
           movingA.stopAt * std::abs(a.deltaAngle) * movingA.rotationReach +
           movingB.stopAt * std::abs(b.deltaAngle) * movingB.rotationReach;
}

Real gapOf(const Bodies& bodies, const ContactSet& contactSet, std::uint32_t slot,
           const Tolerances& tolerances) {
    const ContactStore& store = contactSet.store();
    if (!store.read(slot).expired()) {
        return store.summaries()[slot].mayTouch ? store.separation(slot) : tolerances.margin;
    }
    const auto& [bodyA, partA, bodyB, partB] = contactSet.contacts()[slot].key;
    return separation(bodies.convex(bodyA, partA), bodies.pose[bodyA], bodies.convex(bodyB, partB),
                      bodies.pose[bodyB])
        .distance;
}

bool isUnheld(const Bodies& bodies, const ContactSet& contactSet, std::uint32_t slot, Real slop) {
    const Contact& contact = contactSet.contacts()[slot];
    const Real turns = bodies.extent[contact.key.bodyA].rotationReach +
                       bodies.extent[contact.key.bodyB].rotationReach; // else no other point comes
    if (contactSet.store().read(slot).expired()) {
        return contact.manifold.count == 0; // removePassing() did not know of a third body
    }
    if (!contact.bounces || turns == 0) {
        return false;
    }
    const auto& impulse = contactSet.store().numbers(slot).impulse;
    return impulse[0].normal + impulse[1].normal == 0 &&
           isAlone(bodies, contactSet.store(), slot, slop);
}

std::optional<Real> departureTime(const Bodies& bodies, const ContactSet& contactSet,
                                  std::uint32_t slot, Real near, Real slop) {
    const Contact& contact = contactSet.contacts()[slot];
    const Manifold& manifold = contact.manifold;
    const Vec2 normal = manifold.normal;
    const ContactNumbers numbers = contactSet.store().numbers(slot);
    const BodyVelocity& a = bodies.motion[contact.key.bodyA];
    const BodyVelocity& b = bodies.motion[contact.key.bodyB];
    const Real moved = dot(normal, b.deltaPosition - a.deltaPosition);
    Real last = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
        const Real gap = numbers.separation[i];
        if (gap > slop) {
            continue;
        }
        const ManifoldPoint& p = manifold.points[i];
        const Real rise = moved + (leverOf(p.armB, normal) * b.deltaAngle -
                                   leverOf(p.armA, normal) * a.deltaAngle);
        const Real missing = 2 * near - gap;
        if (!(rise > 0 && missing < rise)) {
            return std::nullopt;
        }
        last = std::max(last, missing / rise);
    }
    return last;
}

} // namespace KODO_PRECISION
} // namespace kodo
