// SPDX-License-Identifier: MIT
#include "joints/joint_rows.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {

Real CoupledAngle::missing(const BodyVelocity& a, const BodyVelocity& b, bool biased) const {
    return constraint != nullptr ? constraint->missing(a, b, impulse, biased) : Real(0);
}

Real CoupledAngle::removed(bool biased) const {
    return constraint == nullptr ? Real(0) : biased ? constraint->softness.massScale : Real(1);
}

namespace {

/// K of a point constraint divided by its trace k, so that squares of small and large masses
/// neither underflow nor overflow.
struct ScaledK {
    Real k; // 1/kg; all others are in units of it
    Real mass;
    Real a; // inverse inertias, 1/m^2
    Real b;
    Real together; // of both bodies as one
    Real determinant;

    ScaledK(const BodyVelocity& bodyA, const BodyVelocity& bodyB, const PointConstraint& point,
            Real turned) {
        const Real sum = bodyA.invInertia + bodyB.invInertia;
        const Real free = 1 - turned;
        const Real rotation = bodyA.invInertia * lengthSquared(point.armA) +
                              bodyB.invInertia * lengthSquared(point.armB);
        const Real squareBetween = lengthSquared(point.armA - point.armB);
        const Real jointly =
            sum > 0 ? turned * (bodyA.invInertia / sum) * bodyB.invInertia : Real(0);
        k = 2 * (bodyA.invMass + bodyB.invMass) + free * rotation + jointly * squareBetween;
        const Real scale = k > 0 ? 1 / k : Real(0);
        mass = scale * (bodyA.invMass + bodyB.invMass);
        a = free * scale * bodyA.invInertia;
        b = free * scale * bodyB.invInertia;
        together = scale * jointly;
        const Real area = cross(point.armA, point.armB);
        const Real both = a * (scale * bodyB.invInertia); // only one factor of free remains
        determinant = mass * (1 - mass) + both * area * area;
    }
};

} // namespace

/// K maps an impulse at the anchors to the change of their relative velocity:
///
///   K = M 1 + perp(rA) perp(rA)^T / IA + perp(rB) perp(rB)^T / IB,  M = 1/mA + 1/mB     [Catto09]
///   det K = M (M + rA^2 / IA + rB^2 / IB) + (rA x rB)^2 / (IA IB)
///   K^-1 v = (M v + rA (rA . v) / IA + rB (rB . v) / IB) / det K
///
/// These forms contain no differences, so unlike masses and inertias lose no digits. If both bodies
/// can only rotate, K may be singular: the point moves along one direction only. The impulse is
/// then K speed / k^2.
Vec2 PointConstraint::stopping(const BodyVelocity& a, const BodyVelocity& b, Vec2 speed,
                               Real turned) const {
    const ScaledK scaled(a, b, *this, turned);
    if (!(scaled.k > 0)) {
        return {}; // both bodies are immovable
    }
    const auto weighted = [&](Vec2 rA, Vec2 rB) {
        const Vec2 between = rA - rB;
        return scaled.mass * speed + scaled.a * dot(rA, speed) * rA +
               scaled.b * dot(rB, speed) * rB + scaled.together * dot(between, speed) * between;
    };
    if (scaled.mass > 0 || scaled.determinant > kSingularPoint) {
        return weighted(armA, armB) / (scaled.determinant * scaled.k);
    }
    return weighted(perp(armA), perp(armB)) / scaled.k;
}

/// 1/I_a + 1/I_b - u^T K^-1 u in a form without differences, with M as in K:
///
///   M (M (1/I_a + 1/I_b) + |rA - rB|^2 / (I_a I_b)) / det K
Real PointConstraint::hinged(const BodyVelocity& a, const BodyVelocity& b) const {
    const Real sum = a.invInertia + b.invInertia;
    const ScaledK scaled(a, b, *this, 0);
    if (!(scaled.determinant > 0)) {
        return sum;
    }
    const Real between = lengthSquared(armA - armB);
    return scaled.mass * (scaled.mass * sum + scaled.a * b.invInertia * between) /
           scaled.determinant;
}

Vec2 PointConstraint::missing(const BodyVelocity& a, const BodyVelocity& b, Vec2 impulse,
                              bool biased) const {
    const Softness soft = biased ? softness : Softness{};
    const Vec2 bias = biased ? soft.biasRate * error + arc : Vec2{};
    Vec2 speed = velocityAt(b, armB) - velocityAt(a, armA) + bias;
    if (angle.constraint != nullptr) {
        speed +=
            angle.missing(a, b, biased) * (a.invInertia * perp(armA) + b.invInertia * perp(armB));
    }
    Vec2 next = impulse - soft.massScale * stopping(a, b, speed, angle.removed(biased)) -
                soft.impulseScale * impulse;
    const Real size = length(next);
    if (size > maxImpulse) {
        next = (maxImpulse / size) * next;
    }
    return next - impulse;
}

Vec2 PointConstraint::reaction(const BodyVelocity& a, const BodyVelocity& b, Real twist) const {
    return -stopping(a, b, twist * (a.invInertia * perp(armA) + b.invInertia * perp(armB)));
}

void PointConstraint::solve(BodyVelocity& a, BodyVelocity& b, Vec2& impulse, bool biased) const {
    const Vec2 change = missing(a, b, impulse, biased);
    impulse += change;
    apply(a, b, change);
}

void PointConstraint::apply(BodyVelocity& a, BodyVelocity& b, Vec2 impulse) const {
    applyImpulse(a, armA, -impulse);
    applyImpulse(b, armB, impulse);
}

void PointConstraint::addToSums(Vec2 impulse, Vec2& linear, Real&) const {
    linear += impulse;
}

void AxisConstraint::addToSums(Real impulse, Vec2& linear, Real& angular) const {
    if (axis == Vec2{}) {
        angular += leverB * impulse;
    } else {
        linear += impulse * axis;
        angular += couple * impulse;
    }
}

void AxisConstraint::apply(BodyVelocity& a, BodyVelocity& b, Real impulse) const {
    // In the order of the products as written; see applyImpulse() for locked bodies.
    if (!a.locked()) {
        a.velocity -= a.invMass * impulse * axisA.value_or(axis);
        a.angularVelocity -= a.invInertia * leverA * impulse;
    }
    if (!b.locked()) {
        b.velocity += b.invMass * impulse * axis;
        b.angularVelocity += b.invInertia * leverB * impulse;
    }
}

void AxisConstraint::solve(BodyVelocity& a, BodyVelocity& b, Real& impulse, bool biased) const {
    const Real change = missing(a, b, impulse, biased);
    impulse += change;
    apply(a, b, change);
    if (beside.held) {
        const Vec2 reaction = beside.point->reaction(a, b, leverB * change);
        beside.point->apply(a, b, reaction);
        *beside.impulse += reaction;
    }
}

Real AxisConstraint::give(const BodyVelocity& a, const BodyVelocity& b, bool biased) const {
    const Real mass = axisA ? a.invMass * lengthSquared(*axisA) + b.invMass * lengthSquared(axis)
                            : (a.invMass + b.invMass) * dot(axis, axis);
    Real k = mass + a.invInertia * leverA * leverA + b.invInertia * leverB * leverB;
    if (angle.constraint != nullptr) {
        const Real sum = a.invInertia + b.invInertia;
        const Real lever = leverA - leverB;
        const Real together = sum > 0 ? a.invInertia * b.invInertia / sum * lever * lever : Real(0);
        const Real turned = angle.removed(biased);
        k = mass + (1 - turned) * (k - mass) + turned * together;
    }
    if (const PointConstraint* point = beside.point) {
        const Real fraction = beside.biased ? point->softness.massScale : 1;
        k = (1 - fraction) * k + fraction * point->hinged(a, b);
    }
    return k;
}

Real AxisConstraint::missing(const BodyVelocity& a, const BodyVelocity& b, Real impulse,
                             bool biased) const {
    const Softness soft = biased ? softness : Softness{};
    const Real along = axisA ? dot(axis, b.velocity) - dot(*axisA, a.velocity)
                             : dot(axis, b.velocity - a.velocity);
    Real now = along + leverB * b.angularVelocity - leverA * a.angularVelocity - speed +
               soft.biasRate * error;
    if (angle.constraint != nullptr) {
        now += angle.missing(a, b, biased) * (a.invInertia * leverA + b.invInertia * leverB);
    }
    if (const PointConstraint* point = beside.point) {
        const Vec2 u =
            leverA * a.invInertia * perp(point->armA) + leverB * b.invInertia * perp(point->armB);
        now += dot(u, point->missing(a, b, *beside.impulse, beside.biased));
    }
    const Real k = give(a, b, biased);
    if (!(k > 0)) {
        return 0; // both bodies are immovable, or the other constraint leaves no motion free
    }
    const Real stopping = impulse - (now - soft.biasRate * error) / k; // without softness
    const Real rigid = std::min(borne, std::max(stopping, Real(0)));
    const Real wanted = impulse - soft.massScale * now / k - soft.impulseScale * (impulse - rigid);
    return std::clamp(wanted, bounds.lower, bounds.upper) - impulse;
}

} // namespace KODO_PRECISION
} // namespace kodo
