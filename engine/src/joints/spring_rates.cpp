// SPDX-License-Identifier: MIT
#include "joints/spring_rates.hpp"

#include "joints/anchor.hpp"

#include <algorithm>
#include <numbers>

namespace kodo {
inline namespace KODO_PRECISION {

void SpringRates::add(const Bodies& bodies, std::uint32_t joint, const DistanceJoint& spring) {
    const JointEnds& ends = spring.ends;
    const std::uint32_t a = ends.a.index;
    const std::uint32_t b = ends.b.index;
    const Vec2 armA = armOf(bodies, a, bodies.pose[a].rotation, ends.anchorA);
    const Vec2 armB = armOf(bodies, b, bodies.pose[b].rotation, ends.anchorB);
    // The lever is at most the arm, as the spring itself has none. Bodies may turn far in a step.
    const auto give = [&](std::uint32_t body, Vec2 arm) {
        const BodyVelocity& motion = bodies.motion[body];
        return motion.invMass + motion.invInertia * lengthSquared(arm);
    };
    const Real giveA = give(a, armA);
    const Real giveB = give(b, armB);
    const Real omega = 2 * std::numbers::pi_v<Real> * spring.hertz;
    const Real mass = bodies.motion[a].invMass + bodies.motion[b].invMass;
    if (giveA + giveB > 0) {
        // N/m; bodies that can only rotate have no other mass than that at the anchors
        const Real stiffness = omega * omega / (mass > 0 ? mass : giveA + giveB);
        springs_.push_back({joint, a, b, stiffness * giveA, stiffness * giveB, stiffness});
    }
}

void SpringRates::find(const Bodies& bodies) {
    if (springs_.empty()) {
        return;
    }
    resizeByBody(sums_, bodies);
    resizeByBody(largest_, bodies);
    for (const Spring& spring : springs_) {
        sums_[spring.a] += spring.ofA;
        sums_[spring.b] += spring.ofB;
    }
    for (const Spring& spring : springs_) {
        const Real both = sums_[spring.a] + sums_[spring.b];
        for (const std::uint32_t body : {spring.a, spring.b}) {
            if (!bodies.locked(body)) {
                largest_[body] = std::max(largest_[body], both);
            }
        }
    }
    for (Spring& spring : springs_) {
        spring.bound = std::max(largest_[spring.a], largest_[spring.b]);
    }
    for (const Spring& spring : springs_) {
        sums_[spring.a] = sums_[spring.b] = 0;
        largest_[spring.a] = largest_[spring.b] = 0;
    }
}

} // namespace KODO_PRECISION
} // namespace kodo
