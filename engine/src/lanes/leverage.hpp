// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <algorithm>
#include <limits>

#include "lanes/contact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// True if the bodies of a contact do not give way at a point. Bodies that can rotate but not
/// translate give way only by a lever. The shorter the lever, the larger is the effective mass. An
/// impact straight towards the hinge would need unlimited spin. So bodies count as immovable where
/// the effective mass is more than 64 times the mass:
///
///   lever^2 / I < 1 / (64 m)
///
/// For a wheel this is within 5 degrees of the direction to its hinge.
inline bool isBlocked(const Bodies& bodies, const Contact& contact, std::size_t point) {
    const auto [bodyA, partA, bodyB, partB] = contact.key;
    const BodyVelocity& a = bodies.motion[bodyA];
    const BodyVelocity& b = bodies.motion[bodyB];
    if (a.invMass > 0 || b.invMass > 0) {
        return false;
    }
    const ManifoldPoint& p = contact.manifold.points[point];
    const Real leverA = leverOf(p.armA, contact.manifold.normal);
    const Real leverB = leverOf(p.armB, contact.manifold.normal);
    const Real given = a.invInertia * leverA * leverA + b.invInertia * leverB * leverB;
    const auto alone = [&](const BodyVelocity& motion, std::uint32_t body) {
        return motion.invInertia > 0 ? 1 / bodies.geometry(body).mass.mass : Real(0);
    };
    return given * 64 <= alone(a, bodyA) + alone(b, bodyB);
}

/// Lever of the rolling resistance (m): resistance times the distance from the centre of the
/// rolling body to the contact; 0 without rolling [Thesis06, 4.3.3].
inline Real rollingLever(const Contact& contact, const BodyVelocity& a, const BodyVelocity& b) {
    if (contact.material.rollingResistance == 0 || a.invInertia + b.invInertia == 0) {
        return 0;
    }
    constexpr Real kUnlimited = std::numeric_limits<Real>::max();
    const ManifoldPoint& p = contact.manifold.points[0];
    const Real radiusA = a.invInertia > 0 ? length(p.armA) : kUnlimited;
    const Real radiusB = b.invInertia > 0 ? length(p.armB) : kUnlimited;
    return contact.material.rollingResistance * std::min(radiusA, radiusB);
}

} // namespace KODO_PRECISION
} // namespace kodo
