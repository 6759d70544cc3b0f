// SPDX-License-Identifier: MIT
#include "joints/inertia_bounds.hpp"

#include <utility>

namespace kodo {
inline namespace KODO_PRECISION {

void InertiaBounds::add(const Bodies& bodies, std::uint32_t body, Real torque) {
    if (!(torque > 0) || !(bodies.motion[body].invInertia > 0)) {
        return;
    }
    resizeByBody(torques_, bodies);
    if (torques_[body] == 0) {
        bodies_.push_back(body);
    }
    torques_[body] += torque;
}

void InertiaBounds::raise(Bodies& bodies, Real h) {
    for (const std::uint32_t body : bodies_) {
        BodyVelocity& motion = bodies.motion[body];
        const Real ratio = h * h * std::exchange(torques_[body], Real(0)) * motion.invInertia;
        if (ratio > 1) {
            raised_.push_back({body, motion.invInertia});
            motion.invInertia /= ratio;
            motion.angularVelocity /= ratio;
        }
    }
    bodies_.clear();
}

void InertiaBounds::restore(Bodies& bodies) {
    for (const Raised& raised : raised_) {
        bodies.motion[raised.body].invInertia = raised.invInertia;
    }
    raised_.clear();
}

} // namespace KODO_PRECISION
} // namespace kodo
