// SPDX-License-Identifier: MIT
#include <kodo/bodies/force_field.hpp>

namespace kodo::inline KODO_PRECISION {

Transform midStep(const Bodies& bodies, std::uint32_t body, Real dt) {
    const Transform& pose = bodies.pose[body];
    const Motion& motion = bodies.motion[body];
    return {pose.position + dt / 2 * motion.velocity,
            turned(pose.rotation, dt / 2 * motion.angularVelocity)};
}

Push Gravity::at(const Bodies& bodies, std::uint32_t body, Real) const {
    return {bodies.form(body).mass.mass * acceleration_};
}

} // namespace kodo::inline KODO_PRECISION
