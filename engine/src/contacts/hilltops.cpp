// SPDX-License-Identifier: MIT
#include "collide/chain_line.hpp"
#include "collide/one_sided.hpp"
#include "contacts/contact_update.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Displacement in a step, in slops, below which all points are kept, so that resting bodies stay
// supported.
constexpr Real kLeastMoved = Real(0.25);
// Depth in slops up to which a passing point counts as apart. A deeper point is a contact, with an
// impact if the material has restitution.
constexpr Real kTolerance = Real(0.125);

/// A one-sided copy of a line whose face gives the normal of a manifold. Empty: no such line, or
/// another feature gives the normal.
std::optional<ConvexShape> lineWithNormal(const ConvexShape& shape, const Rot& rotation,
                                          Vec2 normal) {
    if (!shape.isLine() || !(shape.oneSided || isLinked(shape))) {
        return std::nullopt;
    }
    constexpr Real kSame = Real(0.9999); // cosine
    const Vec2 side = unrotate(rotation, normal);
    if (std::abs(dot(side, shape.normals[1])) < kSame) {
        return std::nullopt;
    }
    return shape.oneSided ? shape : facingTo(shape, side);
}

/// The point of the other shape in a step of dt, in the frame of the line's body.
PointOverLine pointOver(const ManifoldPoint& point, const Bodies& bodies, const ContactKey& key,
                        bool lineIsA, Real dt) {
    const Vec2 moved = dt * (velocityAt(bodies.motion[key.bodyB], point.armB) -
                             velocityAt(bodies.motion[key.bodyA], point.armA));
    const Rot& rotation = bodies.pose[lineIsA ? key.bodyA : key.bodyB].rotation;
    return {unrotate(rotation, lineIsA ? point.armA : point.armB),
            unrotate(rotation, lineIsA ? moved : -moved), point.separation};
}

} // namespace

void removePassingPoints(Manifold& manifold, const Contact& contact, const Bodies& bodies,
                         const Tolerances& tolerances, Real dt) {
    const ContactKey& key = contact.key;
    const ConvexShape& shapeA = bodies.convex(key.bodyA, key.partA);
    const ConvexShape& shapeB = bodies.convex(key.bodyB, key.partB);
    const Real slop = tolerances.slop;
    if (contact.sensor || shapeA.isRound() || shapeB.isRound() ||
        std::max(shapeA.coreRadius, shapeB.coreRadius) < slop) {
        return;
    }
    for (const bool isA : {true, false}) {
        if (manifold.count == 0) {
            break;
        }
        const auto line =
            lineWithNormal(isA ? shapeA : shapeB, bodies.pose[isA ? key.bodyA : key.bodyB].rotation,
                           isA ? manifold.normal : -manifold.normal);
        if (!line) {
            continue;
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
            const PointOverLine point = pointOver(manifold.points[i], bodies, key, isA, dt);
            const Real moved = length(point.displacement);
            if (moved < kLeastMoved * slop || !missesLine(*line, point, kTolerance * slop)) {
                manifold.points[kept++] = manifold.points[i];
            }
        }
        manifold.count = static_cast<int>(kept);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
