// SPDX-License-Identifier: MIT
#pragma once

#include <support/scenes.hpp>

/// Queries about bodies outside the region.
namespace support {

inline bool isOutside(const kodo::World& world, kodo::BodyId id) {
    return (world[id].flags() & kodo::kOutside) != 0;
}

/// Pose and velocity, for bitwise comparison.
struct State {
    kodo::Vec2 center;
    kodo::Rot rotation;
    kodo::Vec2 velocity;
    kodo::Real spin;
    friend bool operator==(const State&, const State&) = default;
};
inline State stateOf(const kodo::World& world, kodo::BodyId id) {
    const kodo::BodyView body = world[id];
    return {body.center(), body.rotation(), body.velocity(), body.angularVelocity()};
}

} // namespace support
