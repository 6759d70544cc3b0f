// SPDX-License-Identifier: MIT
#include "joints/joint_rows.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {
/// K maps an impulse at the anchors to the change of their relative velocity:
///
///   K = (1/mA + 1/mB) 1 + perp(rA) perp(rA)^T / IA + perp(rB) perp(rB)^T / IB      [Catto09]
///
/// For a body that can only rotate, K = k u u^T is singular: the point moves along u only. The
/// impulse is then u (u . speed) / k = K speed / k^2.
Vec2 PointConstraint::stopping(const BodyVelocity& a, const BodyVelocity& b, Vec2 speed) const {
    const Real mass = a.invMass + b.invMass;
    const Real xx = mass + a.invInertia * armA.y * armA.y + b.invInertia * armB.y * armB.y;
    const Real xy = -a.invInertia * armA.x * armA.y - b.invInertia * armB.x * armB.y;
    const Real yy = mass + a.invInertia * armA.x * armA.x + b.invInertia * armB.x * armB.x;
    const Real k = xx + yy;
    if (!(k > 0)) {
        return {}; // both bodies are immovable
    }
    const Real determinant = xx * yy - xy * xy;
    if (!(determinant > kSingularPoint * xx * yy)) {
        return Vec2{xx * speed.x + xy * speed.y, xy * speed.x + yy * speed.y} / (k * k);
    }
    return Vec2{yy * speed.x - xy * speed.y, xx * speed.y - xy * speed.x} / determinant;
}

Vec2 PointConstraint::missing(const BodyVelocity& a, const BodyVelocity& b, Vec2 impulse,
                              bool biased) const {
    const Softness soft = biased ? softness : Softness{};
    const Vec2 bias = biased ? soft.biasRate * error + arc : Vec2{};
    const Vec2 speed = velocityAt(b, armB) - velocityAt(a, armA) + bias;
    Vec2 next = impulse - soft.massScale * stopping(a, b, speed) - soft.impulseScale * impulse;
    const Real size = length(next);
    if (size > maxImpulse) {
        next = (maxImpulse / size) * next;
    }
    return next - impulse;
}

void PointConstraint::solve(BodyVelocity& a, BodyVelocity& b, Vec2& impulse, bool biased) const {
    const Vec2 change = missing(a, b, impulse, biased);
    impulse += change;
    push(a, b, change);
}

void PointConstraint::push(BodyVelocity& a, BodyVelocity& b, Vec2 impulse) const {
    applyImpulse(a, armA, -impulse);
    applyImpulse(b, armB, impulse);
}

void PointConstraint::addToSums(Vec2 impulse, Vec2& pushes, Real&) const {
    pushes += impulse;
}

void AxisConstraint::addToSums(Real impulse, Vec2& pushes, Real& turns) const {
    if (axis == Vec2{}) {
        turns += leverB * impulse;
    } else {
        pushes += impulse * axis;
    }
}

void AxisConstraint::push(BodyVelocity& a, BodyVelocity& b, Real impulse) const {
    a.velocity -= a.invMass * impulse * axis;
    a.angularVelocity -= a.invInertia * leverA * impulse;
    b.velocity += b.invMass * impulse * axis;
    b.angularVelocity += b.invInertia * leverB * impulse;
}

void AxisConstraint::solve(BodyVelocity& a, BodyVelocity& b, Real& impulse, bool biased) const {
    Real k = (a.invMass + b.invMass) * dot(axis, axis) + a.invInertia * leverA * leverA +
             b.invInertia * leverB * leverB;
    if (!(k > 0)) {
        return;
    }
    const Softness soft = biased ? softness : Softness{};
    Real now = dot(axis, b.velocity - a.velocity) + leverB * b.angularVelocity -
               leverA * a.angularVelocity - speed + soft.biasRate * error;
    if (const PointConstraint* point = beside.point) {
        const Vec2 u =
            leverA * a.invInertia * perp(point->armA) + leverB * b.invInertia * perp(point->armB);
        now += dot(u, point->missing(a, b, beside.impulse, beside.biased));
        const Real fraction = beside.biased ? point->softness.massScale : 1;
        k = std::max(k - fraction * dot(u, point->stopping(a, b, u)), kLeastShare * k);
    }
    const Real wanted = impulse - soft.massScale * now / k - soft.impulseScale * impulse;
    const Real next = std::clamp(wanted, bounds.lower, bounds.upper);
    push(a, b, next - impulse);
    impulse = next;
}

} // namespace KODO_PRECISION
} // namespace kodo
