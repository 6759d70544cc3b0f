// SPDX-License-Identifier: MIT
#include "joints/spring_rates.hpp"

#include "base/checks.hpp"
#include "joints/anchor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace kodo {
inline namespace KODO_PRECISION {

namespace {

/// Visits joints with a spring that acts once in a substep.
template <typename Joint>
inline constexpr bool kHasSpring = requires(Joint joint) {
    joint.ends;
    joint.hertz;
}
&&!std::is_same_v<Joint, MotorJoint>;

/// Inverse of the mass (kg) or moment of inertia (kg m^2) that `hertz` is about: see JointKinds.
template <typename Joint>
Real giveOf(const Bodies& bodies, const Joint& joint) {
    const JointEnds& ends = joint.ends;
    const BodyVelocity& a = bodies.motion[ends.a.index];
    const BodyVelocity& b = bodies.motion[ends.b.index];
    const Vec2 armA = armOf(bodies, ends.a.index, {}, ends.anchorA);
    const Vec2 armB = armOf(bodies, ends.b.index, {}, ends.anchorB);
    if constexpr (std::is_same_v<Joint, RevoluteJoint>) {
        return inverseAbout(a, armA) + inverseAbout(b, armB);
    }
    const Real free = a.invMass + b.invMass;
    return free > 0 ? free
                    : a.invInertia * lengthSquared(armA) + b.invInertia * lengthSquared(armB);
}

} // namespace

Spring springOf(const Bodies& bodies, const JointDef& def, Real stiffness, Real damping) {
    refuse(checkPositive("stiffness", stiffness, std::numeric_limits<Real>::max(), "N/m"));
    refuse(checkNotNegative("damping", damping, "N s/m"));
    const Real give = std::visit(
        [&](const auto& kind) -> Real {
            if constexpr (kHasSpring<std::decay_t<decltype(kind)>>) {
                return giveOf(bodies, kind);
            } else {
                throw BadDefinition({"joint", "must be one with a spring between two bodies"});
            }
        },
        def);
    if (!(give > 0)) {
        throw BadDefinition({"joint", "has no body that the spring could move"});
    }
    const Real omega = std::sqrt(stiffness * give); // rad/s
    return {omega / (2 * std::numbers::pi_v<Real>), damping * give / (2 * omega)};
}

/// The lever of a spring is at most its arm, as the spring itself has none: bodies may turn far in
/// a step. Bodies that can only rotate have no other mass than that at the anchors.
template <typename Joint>
void SpringRates::addSpring(const Bodies& bodies, std::uint32_t joint, const Joint& spring) {
    constexpr bool kTurns = std::is_same_v<Joint, RevoluteJoint>;
    const JointEnds& ends = spring.ends;
    const std::uint32_t a = ends.a.index;
    const std::uint32_t b = ends.b.index;
    const BodyVelocity& bodyA = bodies.motion[a];
    const BodyVelocity& bodyB = bodies.motion[b];
    Vec2 armA = armOf(bodies, a, bodies.pose[a].rotation, ends.anchorA);
    const Vec2 armB = armOf(bodies, b, bodies.pose[b].rotation, ends.anchorB);
    const Real omega = 2 * std::numbers::pi_v<Real> * spring.hertz;
    if constexpr (kTurns) {
        const Real give = inverseAbout(bodyA, armA) + inverseAbout(bodyB, armB);
        const Real rate = give > 0 ? omega * omega / give : Real(0);
        // a body on an immovable one rotates about the anchor
        const Real ofA = bodyB.locked() ? give : bodyA.invInertia;
        const Real ofB = bodyA.locked() ? give : bodyB.invInertia;
        springs_.push_back({joint, a, b, rate * ofA, rate * ofB, 0});
        return;
    }
    if constexpr (requires { spring.axis; }) { // see JointFrame::commonArm()
        armA = bodies.pose[b].position + armB - bodies.pose[a].position;
    }
    const Real giveA = bodyA.invMass + bodyA.invInertia * lengthSquared(armA);
    const Real giveB = bodyB.invMass + bodyB.invInertia * lengthSquared(armB);
    const Real mass = bodyA.invMass + bodyB.invMass;
    if (!(giveA + giveB > 0)) {
        return;
    }
    const Real stiffness = omega * omega / (mass > 0 ? mass : giveA + giveB); // N/m
    Spring added{joint, a, b, stiffness * giveA, stiffness * giveB, stiffness};
    const Real inertia = bodyA.invInertia + bodyB.invInertia;
    if (std::is_same_v<Joint, FixedJoint> && inertia > 0) {
        added.ofA += omega * omega * (bodyA.invInertia / inertia);
        added.ofB += omega * omega * (bodyB.invInertia / inertia);
    }
    springs_.push_back(added);
}

void SpringRates::add(const Bodies& bodies, std::uint32_t joint, const JointDef& def) {
    std::visit(
        [&](const auto& kind) {
            if constexpr (kHasSpring<std::decay_t<decltype(kind)>>) {
                if (kind.hertz > 0) {
                    addSpring(bodies, joint, kind);
                }
            }
        },
        def);
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
