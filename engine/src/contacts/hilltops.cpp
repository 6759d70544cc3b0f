// SPDX-License-Identifier: MIT
#include "contacts/hilltops.hpp"

#include "collide/jointed_line.hpp"
#include "collide/one_sided.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

// Slops in a step below which all points are kept: what rests must not lose its support.
constexpr Real kLeastMoved = Real(0.25);

/// A one-sided copy of a line whose face gives the normal of a manifold. Empty: no such line, or
/// another feature gives the normal.
std::optional<ConvexShape> lineWithNormal(const ConvexShape& shape, const Rot& rotation,
                                          Vec2 normal) {
    if (!shape.isLine() || !(shape.oneSided || isJointed(shape))) {
        return std::nullopt;
    }
    constexpr Real kSame = Real(0.9999); // cosine
    const Vec2 side = unrotate(rotation, normal);
    if (std::abs(dot(side, shape.normals[1])) < kSame) {
        return std::nullopt;
    }
    return shape.oneSided ? shape : facingTo(shape, side);
}

/// The point of the other shape, in the frame of the line's body.
PointOverLine pointOver(const ManifoldPoint& point, const Bodies& bodies, const ContactKey& key,
                        bool lineIsA) {
    const Vec2 velocity = velocityAt(bodies.motion[key.bodyB], point.armB) -
                          velocityAt(bodies.motion[key.bodyA], point.armA);
    const Rot& rotation = bodies.pose[lineIsA ? key.bodyA : key.bodyB].rotation;
    return {unrotate(rotation, lineIsA ? point.armA : point.armB),
            unrotate(rotation, lineIsA ? velocity : -velocity), point.separation};
}

} // namespace

Real removePassingPoints(Manifold& manifold, const Bodies& bodies, const ContactKey& key,
                         const Tolerances& tolerances, Real dt) {
    Real nearest = std::numeric_limits<Real>::infinity();
    const Real slop = tolerances.slop;
    if (std::max(bodies.convex(key.bodyA, key.partA).coreRadius,
                 bodies.convex(key.bodyB, key.partB).coreRadius) < slop) {
        return nearest;
    }
    for (const bool isA : {true, false}) {
        if (manifold.count == 0) {
            break;
        }
        const std::uint32_t body = isA ? key.bodyA : key.bodyB;
        const auto line =
            lineWithNormal(bodies.convex(body, isA ? key.partA : key.partB),
                           bodies.pose[body].rotation, isA ? manifold.normal : -manifold.normal);
        if (!line) {
            continue;
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) {
            const PointOverLine point = pointOver(manifold.points[i], bodies, key, isA);
            const Real moved = dt * length(point.velocity);
            if (moved < kLeastMoved * slop || !missesLine(*line, point, slop)) {
                const Real distance = distanceToHilltop(*line, point) - moved;
                nearest = std::min(nearest, std::max(distance, Real(0)));
                manifold.points[kept++] = manifold.points[i];
            }
        }
        manifold.count = static_cast<int>(kept);
    }
    return nearest;
}

} // namespace KODO_PRECISION
} // namespace kodo
