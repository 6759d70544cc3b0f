// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"
#include "collide/manifold.hpp"

#include "lanes/contact.hpp"
#include "lanes/contact_lane.hpp"
#include "lanes/leverage.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// One contact with its two bodies.
struct Impact {
    const Bodies* bodies;
    Contact* contact;
    ContactLane lane;
    BodyVelocity* a;
    BodyVelocity* b;
    bool frictionless;

    Vec2 normal() const { return contact->manifold.normal; }
    Vec2 tangent() const { return perp(contact->manifold.normal); }
    const ManifoldPoint& point(std::size_t i) const { return contact->manifold.points[i]; }
    Real separation(std::size_t i) const { return lane.separation(i); }
    Vec2 relativeVelocity(std::size_t i) const {
        return velocityAt(*b, point(i).armB) - velocityAt(*a, point(i).armA);
    }
    /// m/s along the tangent, of one surface against the other.
    Real slidingSpeed(std::size_t i) const {
        return dot(tangent(), relativeVelocity(i)) + contact->material.surfaceSpeed;
    }
    /// True if an impulse along the normal moves neither body.
    bool blocked(std::size_t i) const { return isBlocked(*bodies, *contact, i); }
    /// Applies an impact impulse (N s) along normal and tangent.
    void push(std::size_t i, Real jn, Real jt) const {
        const Vec2 impulse = jn * normal() + jt * tangent();
        const auto& [armA, armB, then, feature] = point(i);
        applyImpulse(*a, a->invMass, -impulse, a->invInertia,
                     -(leverOf(armA, normal()) * jn + leverOf(armA, tangent()) * jt));
        applyImpulse(*b, b->invMass, impulse, b->invInertia,
                     leverOf(armB, normal()) * jn + leverOf(armB, tangent()) * jt);
        lane.impact(i) += jn;
        lane.total(1) += jt;
    }
};

/// Relative velocity along u at point i per impulse along v at point k (m/s per N s).
inline Real response(const Impact& hit, std::size_t i, Vec2 u, std::size_t k, Vec2 v) {
    const ManifoldPoint& p = hit.point(i);
    const ManifoldPoint& q = hit.point(k);
    return (hit.a->invMass + hit.b->invMass) * dot(u, v) +
           hit.a->invInertia * leverOf(p.armA, u) * leverOf(q.armA, v) +
           hit.b->invInertia * leverOf(p.armB, u) * leverOf(q.armB, v);
}

/// Approach speed (m/s) at point i if it is faster than restSpeed (m/s), else 0.
inline Real approach(const Impact& hit, std::size_t i, Real restSpeed) {
    const Real speed = -dot(hit.normal(), hit.relativeVelocity(i));
    return speed > restSpeed ? speed : 0;
}

} // namespace KODO_PRECISION
} // namespace kodo
