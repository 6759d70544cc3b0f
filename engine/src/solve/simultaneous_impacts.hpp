// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/settings.hpp>

#include "solve/impact.hpp"

#include <array>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Impacts of several contacts at the same instant, by Newton's law at each point that approaches:
///
///   v_n' >= -e v_n,  J >= 0,  J = 0 where v_n' > -e v_n
///
/// The velocities after the impact are unique, whatever the order of the contacts. The energy
/// changes by sum(J (v_n + v_n')) / 2 <= 0, and by 0 for e = 1. Friction is Coulomb's at each
/// point, |J_t| <= mu J, and left out where it would gain energy. Projected Gauss-Seidel. Without a
/// solution, as between two walls that close, each point is hit once, and so it is where no contact
/// bounces: the contact solver follows.
class SimultaneousImpacts {
public:
    /// Applies the impulses to the bodies, and adds them to PointImpulse::impact.
    void solve(std::span<const Impact> hits, const Tolerances& tolerances);

private:
    struct Point {
        const Impact* hit;
        std::size_t index;   // in the manifold
        Vec2 before;         // m/s, relative velocity along normal and tangent
        Real target;         // m/s, separating speed after the impact
        Real normalMass;     // kg
        Real tangentialMass; // kg; 0: no friction
        Real normal = 0;     // N s, so far
        Real tangential = 0; // N s, so far
    };
    void addPoints(const Impact& hit, const Tolerances& tolerances);
    bool iterate(Real tolerance, int most);
    void undo();
    bool gainsEnergy() const;

    std::vector<Point> points_;
};

} // namespace KODO_PRECISION
} // namespace kodo
