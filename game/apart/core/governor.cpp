// SPDX-License-Identifier: MIT
#include <apart/core/governor.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Vec2;

Vec2 servoVelocity(Vec2 velocity, Vec2 heading, Real target) {
    const Real speed = length(velocity);
    if (std::abs(speed - target) <= kServoBand * target) {
        return velocity;
    }
    const Real next = speed + kServoShare * (target - speed);
    return speed < kHaltSpeed ? next * heading : (next / speed) * velocity;
}

Vec2 throwOff(Vec2 velocity, Vec2 heading, std::span<const Vec2> normals, Real target) {
    if (length(velocity) >= kSwallowed * target) {
        return velocity;
    }
    for (const Vec2 normal : normals) {
        heading -= 2 * std::min(dot(heading, normal), Real(0)) * normal;
    }
    return target * heading;
}

Vec2 turnedFromFlat(Vec2 velocity, std::span<const Vec2> normals) {
    const Real speed = length(velocity);
    if (std::abs(velocity.y) >= kFlatSine * speed) {
        return velocity;
    }
    const Real side = velocity.x < 0 ? Real(-1) : Real(1);
    const Real nearest = velocity.y > 0 ? Real(1) : Real(-1); // down if neither: to the player
    for (const Real upward : {nearest, -nearest}) {
        const Vec2 turned{side * kFlatCosine * speed, upward * kFlatSine * speed};
        const bool free = std::all_of(normals.begin(), normals.end(),
                                      [&](Vec2 normal) { return dot(turned, normal) >= 0; });
        if (free) {
            return turned;
        }
    }
    return velocity;
}

} // namespace apart
