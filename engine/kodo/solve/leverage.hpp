// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/bodies/bodies.hpp>
#include <kodo/contacts/contact.hpp>

#include <algorithm>
#include <limits>

namespace kodo::inline KODO_PRECISION {

/// Two bodies of which neither can be moved, but one turned, give way at a contact only where its
/// arm lies aslant to the normal. Hit (almost, within 2 degrees) straight towards its hinge it
/// would have to spin without bound.
inline bool isBlocked(const Motion& a, Vec2 armA, const Motion& b, Vec2 armB, Vec2 normal) {
    if (a.invMass > 0 || b.invMass > 0) {
        return false;
    }
    const Real leverA = cross(armA, normal);
    const Real leverB = cross(armB, normal);
    const Real along = a.invInertia * leverA * leverA + b.invInertia * leverB * leverB;
    const Real most = a.invInertia * lengthSquared(armA) + b.invInertia * lengthSquared(armB);
    return along <= most / 1024;
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
