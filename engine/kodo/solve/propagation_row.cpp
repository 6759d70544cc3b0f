// SPDX-License-Identifier: MIT
#include <kodo/solve/propagation_row.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kodo::inline KODO_PRECISION {
namespace {

/// The two bodies of a row, as a pass may push them.
struct Pair {
    Motion& a;
    Motion& b;
    const RowMasses& masses;

    void push(Vec2 impulse, Real spinA, Real spinB) const {
        a.velocity -= masses.invMassA * impulse;
        a.angularVelocity -= masses.invInertiaA * spinA;
        b.velocity += masses.invMassB * impulse;
        b.angularVelocity += masses.invInertiaB * spinB;
    }
    Real speed(Vec2 direction, Real leverA, Real leverB) const {
        return dot(direction, b.velocity - a.velocity) + leverB * b.angularVelocity -
               leverA * a.angularVelocity;
    }
};

void solveNormal(PropagationRow& row, const Pair& pair, PropagationRow::Point& p, Real& sum,
                 Real share, Real invH) {
    const Real k = pair.masses.response(p.leverA, p.leverB);
    if (!(k > 0)) { // nothing can move here: a hinge is hit straight towards its pin
        return;
    }
    const Real speed = pair.speed(row.normal, p.leverA, p.leverB) + std::max(p.gap, Real(0)) * invH;
    const Real next = std::max(sum - share * speed / k, Real(0));
    const Real change = next - sum;
    sum = next;
    pair.push(change * row.normal, change * p.leverA, change * p.leverB);
}

void solveFriction(PropagationRow& row, const Pair& pair) {
    const Real load = row.load();
    const Vec2 t = perp(row.normal);
    const Real k = pair.masses.response(row.tangentLeverA, row.tangentLeverB);
    if (!(k > 0)) {
        return;
    }
    const Real stick = row.friction - pair.speed(t, row.tangentLeverA, row.tangentLeverB) / k;
    const Real slip = row.kineticFriction * load;
    const bool sticks = std::abs(stick) <= row.staticFriction * load;
    const Real next = sticks ? stick : std::clamp(stick, -slip, slip);
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
    const Real next = std::clamp(wanted, -limit, limit);
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
    Real sum = 0;
    for (int i = 0; i < count; ++i) {
        sum += points[i].impulse + points[i].shock;
    }
    return sum;
}

PropagationRow makeRow(const Contact& contact, std::uint32_t place) {
    const Manifold& manifold = contact.manifold;
    PropagationRow row{};
    row.a = contact.key.bodyA;
    row.b = contact.key.bodyB;
    row.contact = place;
    row.count = manifold.count;
    row.normal = manifold.normal;
    Vec2 meanA;
    Vec2 meanB;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        const ManifoldPoint& p = manifold.points[i];
        row.points[i].leverA = cross(p.armA, row.normal);
        row.points[i].leverB = cross(p.armB, row.normal);
        row.points[i].gap = p.separation;
        meanA += p.armA;
        meanB += p.armB;
    }
    const Real share = Real(1) / static_cast<Real>(row.count);
    row.tangentLeverA = cross(share * meanA, perp(row.normal));
    row.tangentLeverB = cross(share * meanB, perp(row.normal));
    return row;
}

Real rollingLever(const Contact& contact, const Motion& a, const Motion& b) {
    if (contact.material.rollingResistance == 0 || a.invInertia + b.invInertia == 0) {
        return 0;
    }
    constexpr Real kNone = std::numeric_limits<Real>::max();
    const ManifoldPoint& p = contact.manifold.points[0];
    const Real radiusA = a.invInertia > 0 ? length(p.armA) : kNone;
    const Real radiusB = b.invInertia > 0 ? length(p.armB) : kNone;
    return contact.material.rollingResistance * std::min(radiusA, radiusB);
}

void solveRow(PropagationRow& row, Bodies& bodies, const RowMasses& masses, Real share, Real invH) {
    const Pair pair{bodies.motion[row.a], bodies.motion[row.b], masses};
    for (int i = 0; i < row.count; ++i) {
        solveNormal(row, pair, row.points[i], row.points[i].impulse, share, invH);
    }
    solveTangents(row, pair);
}

void shockRow(PropagationRow& row, Bodies& bodies, const RowMasses& masses, Real invH) {
    const Pair pair{bodies.motion[row.a], bodies.motion[row.b], masses};
    for (int i = 0; i < row.count; ++i) {
        solveNormal(row, pair, row.points[i], row.points[i].shock, 1, invH);
    }
    solveTangents(row, pair);
}

void partRow(PropagationRow& row, std::vector<Parting>& parting, const RowMasses& masses,
             const PartingLimits& limits, bool shock) {
    Parting& a = parting[row.a];
    Parting& b = parting[row.b];
    for (int i = 0; i < row.count; ++i) {
        PropagationRow::Point& p = row.points[i];
        const Real k = masses.response(p.leverA, p.leverB);
        if (!(k > 0)) {
            continue;
        }
        const Real wanted = std::min(-limits.allowed - std::min(p.gap, Real(0)), limits.most);
        const Real moved = dot(row.normal, b.move - a.move) + p.leverB * b.turn - p.leverA * a.turn;
        Real& sum = shock ? p.shockParting : p.parting;
        const Real next = std::max(sum + (wanted - moved) / k, Real(0));
        const Real change = next - sum;
        sum = next;
        a.move -= change * masses.invMassA * row.normal;
        a.turn -= change * masses.invInertiaA * p.leverA;
        b.move += change * masses.invMassB * row.normal;
        b.turn += change * masses.invInertiaB * p.leverB;
    }
}

} // namespace kodo::inline KODO_PRECISION
