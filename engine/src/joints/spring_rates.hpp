// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joint.hpp>

#include "bodies/bodies.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

/// Bounds of the squared angular frequency (1/s^2) at which springs can make their bodies vibrate,
/// with all springs of these bodies.
///
/// A spring of stiffness k adds k J_a M_a^-1 J_a^T to the sum of its body a, and likewise for b.
/// The squared angular frequency of any number of springs is at most the largest S_a + S_b of a
/// spring. The bound of a spring is the largest of these values among all springs of its bodies. So
/// if each k is divided by its bound, the bound of the whole becomes 1.
class SpringRates {
public:
    struct Spring {
        std::uint32_t joint;
        std::uint32_t a; // bodies
        std::uint32_t b;
        Real ofA;       // 1/s^2, k J_a M_a^-1 J_a^T
        Real ofB;       // 1/s^2, likewise
        Real stiffness; // N/m, of a DistanceJoint
        Real bound = 0; // 1/s^2, result of find()
    };

    void clear() { springs_.clear(); }
    /// Adds the springs of a joint, if it has any.
    void add(const Bodies& bodies, std::uint32_t joint, const JointDef& def);
    /// Finds the bounds of the springs since clear().
    void find(const Bodies& bodies);
    std::span<const Spring> all() const { return springs_; }

private:
    template <typename Joint>
    void addSpring(const Bodies& bodies, std::uint32_t joint, const Joint& spring);

    std::vector<Spring> springs_;
    std::vector<Real> sums_;    // by body; zero outside of find()
    std::vector<Real> largest_; // by body; zero outside of find()
};

/// See World::springOf().
Spring springOf(const Bodies& bodies, const JointDef& def, Real stiffness, Real damping);

} // namespace KODO_PRECISION
} // namespace kodo
