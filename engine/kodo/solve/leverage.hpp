// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/contacts/contact.hpp>

#include <algorithm>
#include <limits>

namespace kodo::inline KODO_PRECISION {

/// Do the bodies of a contact not give way at this point? Two that cannot be moved, but turned, do
/// so only by a lever. The shorter that is, the heavier they seem, and hit straight towards its
/// hinge a body would have to spin without bound: so they are immovable where they would seem more
/// than 64 times as heavy as they are,
///
///   lever^2 / I < 1 / (64 m)
///
/// which for a wheel is within 5 degrees of its hinge.
inline bool isBlocked(const Bodies& bodies, const Contact& contact, std::size_t point) {
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    const Motion& a = bodies.motion[bodyA];
    const Motion& b = bodies.motion[bodyB];
    if (a.invMass > 0 || b.invMass > 0) {
        return false;
    }
    const ManifoldPoint& p = contact.manifold.points[point];
    const Real leverA = leverOf(p.armA, contact.manifold.normal);
    const Real leverB = leverOf(p.armB, contact.manifold.normal);
    const Real given = a.invInertia * leverA * leverA + b.invInertia * leverB * leverB;
    const auto alone = [&](const Motion& motion, std::uint32_t body) {
        return motion.invInertia > 0 ? 1 / bodies.form(body).mass.mass : Real(0);
    };
    return given * 64 <= alone(a, bodyA) + alone(b, bodyB);
}

/// What brakes rolling (m): resistance times the distance from the centre of the rolling body to
/// the contact; 0 where nothing rolls [Thesis06, 4.3.3].
inline Real rollingLever(const Contact& contact, const Motion& a, const Motion& b) {
    if (contact.material.rollingResistance == 0 || a.invInertia + b.invInertia == 0) {
        return 0;
    }
    constexpr Real kNone = std::numeric_limits<Real>::max();
    const ManifoldPoint& p = contact.manifold.points[0];
    const Real radiusA = a.invInertia > 0 ? length(p.armA) : kNone;
    const Real radiusB = b.invInertia > 0 ? length(p.armB) : kNone;
    return contact.material.rollingResistance * std::min(radiusA, radiusB);
}

} // namespace kodo::inline KODO_PRECISION
