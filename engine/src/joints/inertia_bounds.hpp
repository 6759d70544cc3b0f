// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <cstdint>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Lower bounds of moments of inertia while springs, ropes and rods act in a substep.
///
/// A force F on an anchor turns the arm r of the anchor towards its own direction, at a squared
/// angular frequency of up to |F| |r| / I. A substep of h (s) is unstable beyond 2 rad, and gains
/// energy before. So bodies have at least
///
///   I >= h^2 sum of |F| |r|
///
/// Angular momentum stays while the inertia is raised, angular velocity while it falls back. So
/// vibrations lose energy, as in an implicit step.
class InertiaBounds {
public:
    /// Adds force times arm (N m) to the sum of a body.
    void add(const Bodies& bodies, std::uint32_t body, Real torque);
    /// Raises inertia to the bounds.
    void raise(Bodies& bodies, Real h);
    /// Restores the inertia of all bodies.
    void restore(Bodies& bodies);

private:
    struct Raised {
        std::uint32_t body;
        Real invInertia; // 1/(kg m^2), the true one
    };
    std::vector<Real> torques_; // N m, by body; zero outside of add() to raise()
    std::vector<std::uint32_t> bodies_;
    std::vector<Raised> raised_;
};

} // namespace KODO_PRECISION
} // namespace kodo
