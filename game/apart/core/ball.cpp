// SPDX-License-Identifier: MIT
// Bodies of all kinds of balls.
#include <apart/core/field.hpp>
#include <apart/core/tuning.hpp>

#include <numbers>

namespace apart {

using kodo::Circle;
using kodo::Real;
using kodo::Vec2;

namespace {

/// Two half ellipses of the same width, with the tip to the right.
kodo::Polygon eggShape() {
    kodo::Polygon egg;
    for (int i = 0; i < kEggFacets; ++i) {
        const Real angle = static_cast<Real>(2 * i + 1) / kEggFacets * std::numbers::pi_v<Real>;
        const Vec2 way = kodo::Rot::fromAngle(angle).xAxis();
        egg.corners.push_back({(way.x > 0 ? kEggLong : kEggShort) * way.x, kEggHalfWidth * way.y});
    }
    return egg;
}

kodo::Material materialOf(BallKind kind) {
    return kind == BallKind::Rough ? kodo::withFriction(kRoughFriction, 1) : kBallMaterial;
}

Real densityOf(BallKind kind) {
    return kind == BallKind::Heavy ? kHeavyFactor * kBallDensity : kBallDensity;
}

} // namespace

kodo::BodyId addBall(kodo::World& world, Vec2 position, BallKind kind) {
    kodo::BodyDef def{.shape = Circle{kBallRadius},
                      .position = position,
                      .material = materialOf(kind),
                      .density = densityOf(kind),
                      .flags = flagsOf(Role::Ball)};
    if (kind == BallKind::Egg) {
        def.shape = eggShape();
    }
    if (kind != BallKind::Lopsided) {
        return world.add(def);
    }
    const Real mass = massOf(Circle{kBallRadius}, kBallDensity).mass;
    const Circle core{kCoreRadius, {kCoreOffset, 0}};
    def.density = (1 - kCoreShare) * kBallDensity;
    const kodo::BodyId ball = world.add(def);
    world.weld(ball, core, def.material, kCoreShare * mass / massOf(core, Real(1)).mass);
    return ball;
}

Real reachOf(BallKind kind) {
    return kind == BallKind::Egg ? kEggLong : kBallRadius;
}

} // namespace apart
