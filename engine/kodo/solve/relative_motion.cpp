// SPDX-License-Identifier: MIT
#include <kodo/solve/relative_motion.hpp>

#include <algorithm>
#include <cmath>

namespace kodo::inline KODO_PRECISION {
namespace {

/// How far a body goes at most as seen from a locked one, which nothing stops: what lies still on a
/// turning floor goes nowhere.
Real motionSeenFrom(const Bodies& bodies, std::uint32_t locked, std::uint32_t other, Real swing) {
    const Motion& floor = bodies.motion[locked];
    const Motion& motion = bodies.motion[other];
    const Vec2 arm = bodies.pose[other].position - bodies.pose[locked].position;
    const Vec2 carried = floor.move + cross(floor.turn, arm);
    const Real bend = floor.turn * floor.turn / 2 * length(arm); // what a chord leaves of an arc
    return length(motion.move - carried) + bend + std::abs(motion.turn - floor.turn) * swing;
}

} // namespace

Real relativeMotion(const Bodies& bodies, const Mover& moverA, const Mover& moverB) {
    const auto& [bodyA, swingA, stopA] = moverA;
    const auto& [bodyB, swingB, stopB] = moverB;
    const Motion& a = bodies.motion[bodyA];
    const Motion& b = bodies.motion[bodyB];
    if (a.locked()) {
        return motionSeenFrom(bodies, bodyA, bodyB, swingB);
    }
    if (b.locked()) {
        return motionSeenFrom(bodies, bodyB, bodyA, swingA);
    }
    const Real alone = stopA == stopB  ? 0
                       : stopA > stopB ? (stopA - stopB) * length(a.move)
                                       : (stopB - stopA) * length(b.move);
    return std::min(stopA, stopB) * length(b.move - a.move) + alone +
           stopA * std::abs(a.turn) * swingA + stopB * std::abs(b.turn) * swingB;
}

} // namespace kodo::inline KODO_PRECISION
