// SPDX-License-Identifier: MIT
#include "lanes/contact_block_lanes.hpp"

#include <limits>

#include "lanes/leverage.hpp"

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

Real effectiveMass(const BodyVelocity& a, const BodyVelocity& b, Real leverA, Real leverB) {
    const Real k =
        a.invMass + b.invMass + a.invInertia * leverA * leverA + b.invInertia * leverB * leverB;
    return k >= std::numeric_limits<Real>::min() ? 1 / k : 0; // 0: neither body gives way
}

/// Coefficients of a point.
struct PointValues {
    Real leverA = 0;
    Real leverB = 0;
    Real mass = 0;
};

void writePoint(ContactBlock::Point& point, std::size_t lane, const PointValues& values) {
    point.leverA[lane] = values.leverA;
    point.leverB[lane] = values.leverB;
    point.mass[lane] = values.mass;
}

} // namespace

void fillLane(ContactBlock& block, std::size_t lane, const Bodies& bodies, const Contact& contact,
              const LaneRules& rules) {
    const BodyVelocity& a = bodies.motion[contact.key.bodyA];
    const BodyVelocity& b = bodies.motion[contact.key.bodyB];
    const Manifold& manifold = contact.manifold;
    const Vec2 n = manifold.normal;
    block.normalX[lane] = n.x;
    block.normalY[lane] = n.y;
    const auto setPoint = [&](std::size_t i) {
        const ManifoldPoint& p = manifold.points[i];
        const Real leverA = leverOf(p.armA, n);
        const Real leverB = leverOf(p.armB, n);
        if (isBlocked(bodies, contact, i)) { // no effective mass: no impulse
            writePoint(block.points[i], lane, {leverA, leverB, 0});
            block.points[i].impulse[lane] = 0;
        } else {
            writePoint(block.points[i], lane,
                       {leverA, leverB, effectiveMass(a, b, leverA, leverB)});
        }
    };
    setPoint(0);
    Vec2 meanA = manifold.points[0].armA;
    Vec2 meanB = manifold.points[0].armB;
    if (manifold.count == 2) {
        setPoint(1);
        meanA = Real(0.5) * (meanA + manifold.points[1].armA);
        meanB = Real(0.5) * (meanB + manifold.points[1].armB);
    } else {
        writePoint(block.points[1], lane, {});
        block.points[1].separation[lane] = block.points[1].impulse[lane] = 0;
    }
    block.tangentLeverA[lane] = cross(meanA, perp(n));
    block.tangentLeverB[lane] = cross(meanB, perp(n));
    block.tangentMass[lane] =
        effectiveMass(a, b, block.tangentLeverA[lane], block.tangentLeverB[lane]);
    block.staticFriction[lane] = block.staticFriction[lane] < 0 ? -contact.material.staticFriction
                                                                : contact.material.staticFriction;
    block.kineticFriction[lane] = contact.material.kineticFriction;
    block.pushSpeed[lane] = rules.pushSpeed;
}

void fillLane(SurfaceBlock& surface, ContactBlock& block, std::size_t lane, const Bodies& bodies,
              const Contact& contact, const LaneRules& rules) {
    const BodyVelocity& a = bodies.motion[contact.key.bodyA];
    const BodyVelocity& b = bodies.motion[contact.key.bodyB];
    const bool rolls =
        rules.rolling && contact.material.rollingResistance > 0 && a.invInertia + b.invInertia > 0;
    surface.rollingLever[lane] = rolls ? rollingLever(contact, a, b) : Real(0);
    surface.rollingMass[lane] = rolls ? 1 / (a.invInertia + b.invInertia) : Real(0);
    surface.speed[lane] = contact.material.surfaceSpeed;
    block.rolling[lane] = rolls ? block.rolling[lane] : Real(0);
}

void applyImpulses(Bodies& bodies, const ContactLanes::Place& at, Real share) {
    const auto& [block, lane] = at;
    const Vec2 n{block.normalX[lane], block.normalY[lane]};
    const Real first = share * block.points[0].impulse[lane];
    const Real second = share * block.points[1].impulse[lane];
    const Real friction = share * block.friction[lane];
    const Real roll = share * block.rolling[lane];
    const Vec2 impulse = (first + second) * n + friction * perp(n);
    const auto momentBy = [&](Real lever1, Real lever2, Real tangent) {
        return lever1 * first + lever2 * second + tangent * friction + roll;
    };
    BodyVelocity& a = bodies.motion[bodyOfPlace(block.a[lane])];
    BodyVelocity& b = bodies.motion[bodyOfPlace(block.b[lane])];
    applyImpulse(a, a.invMass, -impulse, a.invInertia,
                 -momentBy(block.points[0].leverA[lane], block.points[1].leverA[lane],
                           block.tangentLeverA[lane]));
    applyImpulse(b, b.invMass, impulse, b.invInertia,
                 momentBy(block.points[0].leverB[lane], block.points[1].leverB[lane],
                          block.tangentLeverB[lane]));
}

void clearLane(ContactBlock& block, std::size_t lane) {
    for (ContactBlock::Point& point : block.points) {
        writePoint(point, lane, {});
    }
    for (ContactBlock::Each* each : {&block.normalX, &block.normalY, &block.tangentLeverA,
                                     &block.tangentLeverB, &block.tangentMass}) {
        (*each)[lane] = 0;
    }
    ContactLane(block, lane) = ContactNumbers{};
}

} // namespace KODO_PRECISION
} // namespace kodo
