// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

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
/// Gauss-Seidel. Without a solution, as between two walls that close, each point is hit once. So it
/// is where no contact bounces and several bodies move: the contact solver follows.
class SimultaneousImpacts {
public:
    /// Applies the impulses to the bodies, and adds them to PointImpulse::impact.
    void solve(std::span<const Impact> hits, const Tolerances& tolerances);

private:
    /// One body at a contact point. Vectors have x and y first, then the angular number.
    struct Side {
        BodyVelocity* body;
        bool locked;
        Four mass;    // 1/kg, 1/kg, 1/(kg m^2), 0
        Four arm;     // m, world, turned by 90 degrees
        Four normal;  // and its lever (m)
        Four tangent; // and its lever (m)

        /// m/s, at the point.
        Four velocity() const { return speeds(*body) + speeds(*body)[2] * arm; }
        /// Applies an impulse (N s, N s, N m s, 0). See applyImpulse() about locked bodies.
        void push(Four impulse) const {
            if (!locked) {
                speeds(*body) += mass * impulse;
            }
        }
    };
    /// One contact point with all that an iteration reads.
    struct Point {
        Side a;
        Side b;
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

        /// m/s, of b against a.
        Real speedAlong(Four direction) const {
            const Four along = direction * (b.velocity() - a.velocity());
            return along[0] + along[1];
        }
        Real slidingSpeed() const { return speedAlong(b.tangent) + surfaceSpeed; }
        /// Applies an impulse (N s) along the normals or tangents.
        void push(Real j, Four Side::*direction) const {
            a.push(-j * (a.*direction));
            b.push(j * (b.*direction));
        }
    };
    void addPoints(const Impact& hit, const Tolerances& tolerances);
    bool iterate(Real tolerance, int most);
    void undo();
    bool pushesOneBody() const;
    bool gainsEnergy() const;

    std::vector<Point> points_;
};

} // namespace KODO_PRECISION
} // namespace kodo
