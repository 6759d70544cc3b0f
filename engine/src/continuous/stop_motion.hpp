// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/bodies.hpp"

#include <algorithm>
#include <cmath>

namespace kodo {
inline namespace KODO_PRECISION {

/// Time (s) until the end of the step from the place at `fraction` of the displacement. A constant
/// acceleration a changes the speed on the way, so it is not (1 - fraction) dt. Along a, with the
/// rest r of the displacement and the final speed v:
///
///   r = v t - a t^2 / 2
///
/// With this time the velocity at the place has the energy of free flight.
inline Real timeFrom(const BodyVelocity& motion, Vec2 acceleration, Real fraction, Real dt) {
    const Real even = (1 - fraction) * dt;
    const Real a = length(acceleration);
    if (!(a > 0)) {
        return even;
    }
    const Vec2 along = acceleration / a;
    const Real rest = (1 - fraction) * dot(along, motion.deltaPosition);
    const Real speed = dot(along, motion.velocity);
    const Real square = speed * speed - 2 * a * rest;
    const Real sum = std::abs(speed) + std::sqrt(std::max(square, Real(0)));
    if (rest * speed <= 0 || square < 0 || !(sum > 0)) {
        return even; // it turns back within the step, or is not in free flight
    }
    const Real time = 2 * std::abs(rest) / sum;
    return time <= dt ? time : even;
}

/// Ends the displacement of a body at `fraction` of the step; from there on only `push` (m, per
/// whole step) moves it. The velocity loses what the forces added after that time.
inline void stop(Bodies& bodies, std::uint32_t body, Real fraction, Vec2 push, Real dt) {
    BodyVelocity& motion = bodies.motion[body];
    const Real lost = timeFrom(motion, bodies.acceleration[body].linear, fraction, dt);
    motion.deltaPosition = fraction * motion.deltaPosition + (1 - fraction) * push;
    motion.deltaAngle *= fraction;
    motion.velocity -= lost * bodies.acceleration[body].linear;
    motion.angularVelocity -= lost * bodies.acceleration[body].angular;
}

} // namespace KODO_PRECISION
} // namespace kodo
