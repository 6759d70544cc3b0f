// SPDX-License-Identifier: MIT
#include "propagation/propagation_row.hpp"

#include "math/friction.hpp"

#include <algorithm>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

/// The two bodies of a row, with their masses in a pass.
struct Pair {
    BodyVelocity& a;
    BodyVelocity& b;
    const RowMasses& masses;

    void push(Vec2 impulse, Real spinA, Real spinB) const {
        applyImpulse(a, masses.invMassA, -impulse, masses.invInertiaA, -spinA);
        applyImpulse(b, masses.invMassB, impulse, masses.invInertiaB, spinB);
    }
    Real speed(Vec2 direction, Real leverA, Real leverB) const {
        return dot(direction, b.velocity - a.velocity) + leverB * b.angularVelocity -
               leverA * a.angularVelocity;
    }
};

/// Response of two contact points to impulses x. solve() finds x >= 0 with k x + speed >= 0, where
/// one of the two is 0 at each point. Solving both at once keeps a flat box from tilting to the
/// corner that comes first [Catto06].
struct TwoPoints {
    Real k11;
    Real k12;
    Real k22;

    std::array<Real, 2> solve(Real speed1, Real speed2) const {
        constexpr Real kSingularPoints = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-12);
        const Real determinant = k11 * k22 - k12 * k12;
        if (determinant > kSingularPoints * k11 * k22) {
            const Real x1 = (k12 * speed2 - k22 * speed1) / determinant;
            const Real x2 = (k12 * speed1 - k11 * speed2) / determinant;
            if (x1 >= 0 && x2 >= 0) {
                return {x1, x2};
            }
        } else if (speed1 < 0 && speed2 < 0) { // cannot rotate: both points act as one
            const Real half = std::max(-speed1, -speed2) / (k11 + k22);
            return {half, half};
        }
        const Real alone1 = std::max(-speed1 / k11, Real(0));
        if (speed2 + k12 * alone1 >= 0) {
            return {alone1, 0};
        }
        return {0, std::max(-speed2 / k22, Real(0))};
    }
};

TwoPoints twoPoints(const PropagationRow& row, const RowMasses& m) {
    const PropagationRow::Point& p = row.points[0];
    const PropagationRow::Point& q = row.points[1];
    return {m.response(p.leverA, p.leverB),
            m.invMassA + m.invMassB + m.invInertiaA * p.leverA * q.leverA +
                m.invInertiaB * p.leverB * q.leverB,
            m.response(q.leverA, q.leverB)};
}

/// Impulse sums with which no point approaches, from the speeds with the current sums. Speeds may
/// also be displacements (m); the sums are then in kg m.
std::array<Real, 2> wantedSums(const PropagationRow& row, const RowMasses& masses,
                               const std::array<Real, 2>& speeds, const std::array<Real, 2>& sums) {
    if (row.count == 1) {
        const Real k = masses.response(row.points[0].leverA, row.points[0].leverB);
        // A hinged body does not give way to an impulse straight towards its joint.
        return {k > 0 ? std::max(sums[0] - speeds[0] / k, Real(0)) : sums[0], 0};
    }
    const TwoPoints k = twoPoints(row, masses);
    if (!(k.k11 > 0 && k.k22 > 0)) {
        return sums;
    }
    return k.solve(speeds[0] - k.k11 * sums[0] - k.k12 * sums[1],
                   speeds[1] - k.k12 * sums[0] - k.k22 * sums[1]);
}

void solveNormals(PropagationRow& row, const Pair& pair, Real fraction, Real invH) {
    std::array<Real, 2>& sums = row.impulse;
    std::array<Real, 2> speeds{};
    for (std::size_t i = 0; i < row.count; ++i) {
        const PropagationRow::Point& p = row.points[i];
        speeds[i] = pair.speed(row.normal, p.leverA, p.leverB) + std::max(p.gap, Real(0)) * invH;
    }
    const std::array<Real, 2> wanted = wantedSums(row, pair.masses, speeds, sums);
    for (std::size_t i = 0; i < row.count; ++i) {
        const PropagationRow::Point& p = row.points[i];
        const Real change = fraction * (wanted[i] - sums[i]);
        sums[i] += change;
        pair.push(change * row.normal, change * p.leverA, change * p.leverB);
    }
}

void solveFriction(PropagationRow& row, const Pair& pair) {
    const Vec2 t = perp(row.normal);
    const Real k = pair.masses.response(row.tangentLeverA, row.tangentLeverB);
    if (!(k > 0)) {
        return;
    }
    const Real sliding = pair.speed(t, row.tangentLeverA, row.tangentLeverB) + row.surfaceSpeed;
    const Real stopping = row.friction - sliding / k;
    const Real next =
        frictionImpulse<Real>({row.staticFriction, row.kineticFriction, row.load(), 1}, stopping)
            .impulse;
    const Real change = next - row.friction;
    row.friction = next;
    pair.push(change * t, change * row.tangentLeverA, change * row.tangentLeverB);
}

void solveRolling(PropagationRow& row, const Pair& pair) {
    const Real freedom = pair.masses.invInertiaA + pair.masses.invInertiaB;
    if (freedom == 0) {
        return;
    }
    const Real limit = row.rollingLever * row.load();
    const Real wanted = row.rolling - (pair.b.angularVelocity - pair.a.angularVelocity) / freedom;
    const Real next = within(limit, wanted);
    const Real change = next - row.rolling;
    row.rolling = next;
    pair.push({}, change, change);
}

void solveTangents(PropagationRow& row, const Pair& pair) {
    if (row.staticFriction > 0) {
        solveFriction(row, pair);
    }
    if (row.rollingLever > 0) {
        solveRolling(row, pair);
    }
}

} // namespace

Real PropagationRow::load() const {
    return impulse[0] + impulse[1];
}

PropagationRow makeRow(const Contact& contact, std::uint32_t place) {
    const Manifold& manifold = contact.manifold;
    PropagationRow row{};
    row.a = contact.key.bodyA;
    row.b = contact.key.bodyB;
    row.contact = place;
    row.count = static_cast<std::size_t>(manifold.count);
    row.normal = manifold.normal;
    Vec2 meanA;
    Vec2 meanB;
    for (std::size_t i = 0; i < row.count; ++i) {
        const ManifoldPoint& p = manifold.points[i];
        row.points[i].leverA = cross(p.armA, row.normal);
        row.points[i].leverB = cross(p.armB, row.normal);
        row.points[i].gap = p.separation;
        meanA += p.armA;
        meanB += p.armB;
    }
    const Real fraction = Real(1) / static_cast<Real>(row.count);
    row.tangentLeverA = cross(fraction * meanA, perp(row.normal));
    row.tangentLeverB = cross(fraction * meanB, perp(row.normal));
    return row;
}

RowMasses massesOf(const Bodies& bodies, const PropagationRow& row, bool frozenA, bool frozenB) {
    const BodyVelocity& a = bodies.motion[row.a];
    const BodyVelocity& b = bodies.motion[row.b];
    return {frozenA ? 0 : a.invMass, frozenA ? 0 : a.invInertia, frozenB ? 0 : b.invMass,
            frozenB ? 0 : b.invInertia};
}

void warmStart(PropagationRow& row, const ContactLane& before, Bodies& bodies, Real h) {
    const RowMasses masses = massesOf(bodies, row);
    const Pair pair{bodies.motion[row.a], bodies.motion[row.b], masses};
    const Vec2 a = h * bodies.acceleration[row.a].linear;
    const Vec2 b = h * bodies.acceleration[row.b].linear;
    const Vec2 t = perp(row.normal);
    const PropagationRow::Point& p = row.points[0];
    const Vec2 speed{pair.speed(row.normal, p.leverA, p.leverB) - dot(row.normal, b - a),
                     pair.speed(t, row.tangentLeverA, row.tangentLeverB) - dot(t, b - a)};
    if (lengthSquared(speed) > std::max(lengthSquared(a), lengthSquared(b))) {
        return;
    }
    for (std::size_t i = 0; i < row.count; ++i) {
        const Real j = row.impulse[i] = before.impulse(i);
        pair.push(j * row.normal, j * row.points[i].leverA, j * row.points[i].leverB);
    }
    const Real f = row.friction = row.staticFriction > 0 ? before.friction() : Real(0);
    row.rolling = row.rollingLever > 0 ? before.rolling() : Real(0);
    pair.push(f * t, f * row.tangentLeverA + row.rolling, f * row.tangentLeverB + row.rolling);
}

void solveRow(PropagationRow& row, Bodies& bodies, const RowMasses& masses, Real fraction,
              Real invH) {
    const Pair pair{bodies.motion[row.a], bodies.motion[row.b], masses};
    solveNormals(row, pair, fraction, invH);
    solveTangents(row, pair);
}

void separateRow(PropagationRow& row, std::vector<SeparationShift>& parting,
                 const RowMasses& masses, const SeparationLimits& limits) {
    SeparationShift& a = parting[row.a];
    SeparationShift& b = parting[row.b];
    std::array<Real, 2> missing{};
    for (std::size_t i = 0; i < row.count; ++i) {
        const PropagationRow::Point& p = row.points[i];
        const Real wanted = std::min(-limits.allowed - std::min(p.gap, Real(0)), limits.most);
        const Real moved = dot(row.normal, b.deltaPosition - a.deltaPosition) +
                           p.leverB * b.deltaAngle - p.leverA * a.deltaAngle;
        missing[i] = moved - wanted;
    }
    const std::array<Real, 2> next = wantedSums(row, masses, missing, row.parting);
    for (std::size_t i = 0; i < row.count; ++i) {
        const PropagationRow::Point& p = row.points[i];
        const Real change = next[i] - row.parting[i];
        if (masses.invMassA != 0 || masses.invInertiaA != 0) { // see applyImpulse()
            a.deltaPosition -= change * masses.invMassA * row.normal;
            a.deltaAngle -= change * masses.invInertiaA * p.leverA;
        }
        if (masses.invMassB != 0 || masses.invInertiaB != 0) {
            b.deltaPosition += change * masses.invMassB * row.normal;
            b.deltaAngle += change * masses.invInertiaB * p.leverB;
        }
    }
    row.parting = next;
}

} // namespace KODO_PRECISION
} // namespace kodo
