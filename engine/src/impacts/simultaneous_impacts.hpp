// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include <array>
#include <span>
#include <vector>

#include "impacts/impact.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Impacts of several contacts at the same instant, by Newton's law at each point that approaches:
///
///   v_n' >= -e v_n,  J >= 0,  J = 0 where v_n' > -e v_n
///
/// The velocities after the impact are unique, whatever the order of the contacts. The energy
/// changes by sum(J (v_n + v_n')) / 2 <= 0, by 0 for e = 1, and grows for e > 1. Friction is
/// Coulomb's at each point, |J_t| <= mu J, and left out where it would gain energy. Projected
/// Gauss-Seidel. Without a solution, as between two walls that close, each point is hit once, and
/// so it is where no contact bounces: the contact solver follows.
class SimultaneousImpacts {
public:
    /// Applies the impulses to the bodies, and adds them to PointImpulse::impact.
    void solve(std::span<const Impact> hits, const Tolerances& tolerances);

private:
    /// One contact point with all that an iteration reads.
    struct Point {
        BodyVelocity* a;
        BodyVelocity* b;
        Vec2 normal;
        Vec2 tangent;
        Vec2 armA; // m, world
        Vec2 armB;
        Vec2 leverA; // m, of armA along normal and tangent
        Vec2 leverB;
        Real target;         // m/s, separating speed after the impact
        Real normalMass;     // kg
        Real tangentialMass; // kg; 0: no friction
        Real staticFriction;
        Real kineticFriction;
        Real surfaceSpeed; // m/s, along the tangent
        Real impulse = 0;  // N s, along the normal, so far
        Real friction = 0; // N s, along the tangent, so far
        Real impact;       // N s, PointImpulse::impact
        Vec2 before;       // m/s, of one surface against the other, along normal and tangent
        const Impact* hit;
        std::size_t index; // in the manifold

        Vec2 relativeVelocity() const;
        Real slidingSpeed() const { return dot(tangent, relativeVelocity()) + surfaceSpeed; }
        /// Applies an impulse (N s), with its angular impulses (N m s) on both bodies.
        void push(Vec2 j, Real angularA, Real angularB) const;
    };
    void addPoints(const Impact& hit, const Tolerances& tolerances);
    bool iterate(Real tolerance, int most);
    void undo();
    bool gainsEnergy() const;
    void storeImpulses();

    std::vector<Point> points_;
};

} // namespace KODO_PRECISION
} // namespace kodo
