// SPDX-License-Identifier: MIT
#include "impacts/simultaneous_impacts.hpp"

#include "math/friction.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr int kMostIterations = 100;
// Of the fastest approach: the change of a speed in one iteration at which the result is final.
constexpr Real kFinal = sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12);
// Share of the energy that moves at which a gain is not an error of the iteration.
constexpr Real kGain = Real(2e-5);

} // namespace

/// Adds the points of a contact that touch and approach.
void SimultaneousImpacts::addPoints(const Impact& hit, const Tolerances& tolerances) {
    const Material& material = hit.contact->material;
    const Vec2 normal = hit.normal();
    const Vec2 tangent = hit.tangent();
    const auto sideOf = [&](BodyVelocity& body, Vec2 arm) {
        return Side{&body,
                    body.locked(),
                    {body.invMass, body.invMass, body.invInertia, 0},
                    {-arm.y, arm.x, 0, 0},
                    {normal.x, normal.y, leverOf(arm, normal), 0},
                    {tangent.x, tangent.y, leverOf(arm, tangent), 0}};
    };
    for (std::size_t i = 0; i < static_cast<std::size_t>(hit.contact->manifold.count); ++i) {
        const Real speed = approach(hit, i, 0);
        if (!(speed > 0) || hit.separation(i) > tolerances.slop || hit.blocked(i)) {
            continue;
        }
        const Real kn = response(hit, i, normal, i, normal);
        const Real kt = response(hit, i, tangent, i, tangent);
        const bool slides = !hit.frictionless && material.staticFriction > 0 && kt > 0;
        const auto& [armA, armB, then, feature] = hit.point(i);
        points_.push_back({.a = sideOf(*hit.a, armA),
                           .b = sideOf(*hit.b, armB),
                           .target = material.restitution * speed,
                           .normalMass = 1 / kn,
                           .tangentialMass = slides ? 1 / kt : 0,
                           .staticFriction = material.staticFriction,
                           .kineticFriction = material.kineticFriction,
                           .surfaceSpeed = material.surfaceSpeed,
                           .impact = hit.lane.impact(i),
                           .before = {-speed, hit.slidingSpeed(i)},
                           .hit = &hit,
                           .index = i});
    }
}

/// Iterates until no speed changes by more than `tolerance` (m/s). False if the impulses grow
/// instead.
bool SimultaneousImpacts::iterate(Real tolerance, int most) {
    Real first = 0;
    Real largest = 0;
    for (int iteration = 0; iteration < most; ++iteration) {
        first = iteration == 1 ? largest : first;
        largest = 0;
        for (Point& point : points_) {
            const Real apart = point.speedAlong(point.b.normal);
            const Real next =
                std::max(Real(0), point.impulse + (point.target - apart) * point.normalMass);
            const Real more = next - point.impulse;
            if (more != 0) {
                point.impulse = next;
                point.impact += more;
                point.push(more, &Side::normal);
                largest = std::max(largest, std::abs(more) / point.normalMass);
            }
            if (!(point.tangentialMass > 0) || (next == 0 && point.friction == 0)) {
                continue;
            }
            const Real stopping = point.friction - point.slidingSpeed() * point.tangentialMass;
            const FrictionLimits<Real> limits{point.staticFriction, point.kineticFriction, next, 1};
            const Real friction = frictionImpulse(limits, stopping).impulse;
            const Real change = friction - point.friction;
            if (change != 0) {
                point.friction = friction;
                point.push(change, &Side::tangent);
                largest = std::max(largest, std::abs(change) / point.tangentialMass);
            }
        }
        if (!(largest > tolerance)) {
            return true;
        }
    }
    return largest < first / 4;
}

/// Takes all impulses back.
void SimultaneousImpacts::undo() {
    for (Point& point : points_) {
        const auto& [a, b] = std::tie(point.a, point.b);
        a.push(point.impulse * a.normal + point.friction * a.tangent);
        b.push(-point.impulse * b.normal - point.friction * b.tangent);
        point.impact -= point.impulse;
        point.impulse = 0;
        point.friction = 0;
        point.tangentialMass = 0;
    }
}

/// True if the impulses have added energy, beyond rounding.
bool SimultaneousImpacts::gainsEnergy() const {
    Real gained = 0; // J, twice
    Real moved = 0;  // J, sum of magnitudes
    for (const Point& point : points_) {
        const Vec2 after{point.speedAlong(point.b.normal), point.slidingSpeed()};
        const Vec2 impulse{point.impulse, point.friction};
        const Real asked = std::max(point.target + point.before.x, Real(0)); // 0 for e <= 1
        gained += dot(impulse, point.before + after) - point.impulse * asked;
        moved += std::abs(impulse.x * point.before.x) + std::abs(impulse.y * point.before.y);
    }
    return gained > kGain * moved;
}

/// True if all points are of one movable body, as where a rod lands on tiles.
bool SimultaneousImpacts::pushesOneBody() const {
    const auto movableOf = [](const Point& point) {
        return point.a.locked ? point.b.body : point.a.body;
    };
    return std::all_of(points_.begin(), points_.end(), [&](const Point& point) {
        return point.a.locked != point.b.locked && movableOf(point) == movableOf(points_[0]);
    });
}

void SimultaneousImpacts::solve(std::span<const Impact> hits, const Tolerances& tolerances) {
    points_.clear();
    for (const Impact& hit : hits) {
        addPoints(hit, tolerances);
    }
    Real fastest = 0;
    for (const Point& point : points_) {
        fastest = std::max(fastest, -point.before.x);
    }
    const bool bounces = std::any_of(hits.begin(), hits.end(), [](const Impact& hit) {
        return hit.contact->material.restitution > 0;
    });
    if (!bounces && !pushesOneBody()) {
        iterate(0, 1); // the contact solver follows
    } else if (!iterate(kFinal * fastest, kMostIterations)) {
        undo();
        iterate(0, 1);
    } else if (gainsEnergy()) {
        undo();
        iterate(kFinal * fastest, kMostIterations);
    }
    for (const Point& point : points_) {
        point.hit->lane.impact(point.index) = point.impact;
        point.hit->lane.total(1) += point.friction;
        point.a.body->invMass = point.a.mass[0]; // 0 times an infinite impulse is NaN
        point.b.body->invMass = point.b.mass[0];
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
