// SPDX-License-Identifier: MIT
#pragma once

#include <support/scenes.hpp>

/// Questions about what waits outside a region of interest.
namespace support {

inline bool waits(const kodo::World& world, kodo::BodyId id) {
    return (world[id].flags() & kodo::kOutside) != 0;
}

/// Pose and motion, to be compared bit by bit.
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
