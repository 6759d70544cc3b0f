// SPDX-License-Identifier: MIT
#include "solve/simultaneous_impacts.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {
namespace {

constexpr int kMostIterations = 100;
// Of the fastest approach: the change of a speed in one iteration at which the result is final.
constexpr Real kFinal = sizeof(Real) == 4 ? Real(1e-6) : Real(1e-12);
// Share of the energy that moves at which a gain is not an error of the iteration.
constexpr Real kGain = Real(2e-5);

/// Relative velocity (m/s) along normal and tangent.
Vec2 alongAxes(const Impact& hit, std::size_t point) {
    const Vec2 velocity = hit.relativeVelocity(point);
    return {dot(hit.normal(), velocity), dot(hit.tangent(), velocity)};
}

} // namespace

/// Adds the points of a contact that touch and approach.
void SimultaneousImpacts::addPoints(const Impact& hit, const Tolerances& tolerances) {
    const Material& material = hit.contact->material;
    for (std::size_t i = 0; i < static_cast<std::size_t>(hit.contact->manifold.count); ++i) {
        const Real speed = approach(hit, i, 0);
        if (!(speed > 0) || hit.point(i).separation > tolerances.slop || hit.blocked(i)) {
            continue;
        }
        const Real kn = response(hit, i, hit.normal(), i, hit.normal());
        const Real kt = response(hit, i, hit.tangent(), i, hit.tangent());
        const bool slides = !hit.frictionless && material.staticFriction > 0 && kt > 0;
        points_.push_back({&hit, i, alongAxes(hit, i), material.restitution * speed, 1 / kn,
                           slides ? 1 / kt : 0});
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
            const Impact& hit = *point.hit;
            const Real apart = dot(hit.normal(), hit.relativeVelocity(point.index));
            const Real next =
                std::max(Real(0), point.normal + (point.target - apart) * point.normalMass);
            const Real more = next - point.normal;
            point.normal = next;
            hit.push(point.index, more, 0);
            largest = std::max(largest, std::abs(more) / point.normalMass);
            if (!(point.tangentialMass > 0)) {
                continue;
            }
            const Material& material = hit.contact->material;
            const Real sliding = dot(hit.tangent(), hit.relativeVelocity(point.index));
            const Real stick = point.tangential - sliding * point.tangentialMass;
            const Real limit = material.kineticFriction * next;
            const bool sticks = std::abs(stick) <= material.staticFriction * next;
            const Real friction = sticks ? stick : std::clamp(stick, -limit, limit);
            const Real change = friction - point.tangential;
            point.tangential = friction;
            hit.push(point.index, 0, change);
            largest = std::max(largest, std::abs(change) / point.tangentialMass);
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
        point.hit->push(point.index, -point.normal, -point.tangential);
        point.normal = 0;
        point.tangential = 0;
        point.tangentialMass = 0;
    }
}

/// True if the impulses have added energy, beyond rounding.
bool SimultaneousImpacts::gainsEnergy() const {
    Real gained = 0; // J, twice
    Real moved = 0;  // J, sum of magnitudes
    for (const Point& point : points_) {
        const Vec2 after = alongAxes(*point.hit, point.index);
        const Vec2 impulse{point.normal, point.tangential};
        gained += dot(impulse, point.before + after);
        moved += std::abs(impulse.x * point.before.x) + std::abs(impulse.y * point.before.y);
    }
    return gained > kGain * moved;
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
    if (!bounces) {
        iterate(0, 1); // the contact solver follows
    } else if (!iterate(kFinal * fastest, kMostIterations)) {
        undo();
        iterate(0, 1);
    } else if (gainsEnergy()) {
        undo();
        iterate(kFinal * fastest, kMostIterations);
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
