// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/core/water.hpp>

#include <numbers>
#include <vector>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

using Corners = std::vector<Vec2>;

Corners cornersAt(const kodo::ConvexShape& convex, const kodo::Transform& t) {
    Corners corners;
    if (!convex.isRound()) {
        for (const Vec2 vertex : convex.vertices) {
            corners.push_back(t * vertex);
        }
        return corners;
    }
    constexpr int kCorners = 16;
    constexpr Real kReach = Real(1.0130059); // of a corner, if a circle of radius 1 has equal area
    constexpr kodo::Rot kStep{Real(0.9238795), Real(0.3826834)}; // cosine and sine of 22.5 degrees
    const Vec2 center = t * convex.vertices[0];
    Vec2 arm{kReach * convex.radius, 0};
    for (int i = 0; i < kCorners; ++i) {
        corners.push_back(center + arm);
        arm = kStep * arm;
    }
    return corners;
}

/// The part of a convex polygon where side(p) < 0 [Sutherland74].
template <typename Side>
Corners clipped(const Corners& corners, Side side) {
    Corners inside;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = corners[i == 0 ? corners.size() - 1 : i - 1];
        const Vec2 to = corners[i];
        const Real before = side(from);
        const Real now = side(to);
        if ((before < 0) != (now < 0)) {
            inside.push_back(from + before / (before - now) * (to - from));
        }
        if (now < 0) {
            inside.push_back(to);
        }
    }
    return inside;
}

} // namespace

kodo::Submerged wetPart(const kodo::ConvexShape& convex, const kodo::Transform& t,
                        const kodo::Aabb& water) {
    const kodo::Aabb bounds = boundsOf(convex, t);
    if (bounds.lower.y >= water.upper.y || bounds.upper.y <= water.lower.y ||
        bounds.lower.x >= water.upper.x || bounds.upper.x <= water.lower.x) {
        return {};
    }
    Corners wet = cornersAt(convex, t);
    wet = clipped(wet, [&](Vec2 p) { return p.y - water.upper.y; });
    wet = clipped(wet, [&](Vec2 p) { return water.lower.y - p.y; });
    wet = clipped(wet, [&](Vec2 p) { return p.x - water.upper.x; });
    wet = clipped(wet, [&](Vec2 p) { return water.lower.x - p.x; });
    Real twice = 0; // the area as a triangle fan
    Vec2 moment;
    for (std::size_t i = 2; i < wet.size(); ++i) {
        const Vec2 a = wet[i - 1] - wet[0];
        const Vec2 b = wet[i] - wet[0];
        twice += cross(a, b);
        moment += cross(a, b) * (a + b);
    }
    return twice > 0 ? kodo::Submerged{twice / 2, wet[0] + moment / (3 * twice)}
                     : kodo::Submerged{};
}

// The drag is explicit: with the implicit one of FieldForce, a hull that carries a load would lose
// the share dt drag / m of its lift. It is stable, since even wood loses only 1/40 of its velocity
// in a tick.
kodo::FieldForce Pool::at(const kodo::BodyView& body, Real dt) const {
    const kodo::Transform pose = midStep(body, dt);
    kodo::FieldForce push;
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const kodo::Submerged wet = wetPart(body.part(i).convex, pose, region_);
        if (wet.area == 0) {
            continue;
        }
        const Vec2 arm = wet.centroid - pose.position;
        const Real drag = fluid_.drag * wet.area;
        const Vec2 slip = body.velocity() + cross(body.angularVelocity(), arm) - fluid_.flow;
        const Vec2 force = Vec2{0, fluid_.density * wet.area * kGravity} - drag * slip;
        // Rotation about the centroid is damped as for a disc of the same area.
        const Real spinDrag = drag * wet.area / (2 * std::numbers::pi_v<Real>);
        push.force += force;
        push.torque += cross(arm, force) - spinDrag * body.angularVelocity();
    }
    return push;
}

} // namespace apart
