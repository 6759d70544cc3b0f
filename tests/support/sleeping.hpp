// SPDX-License-Identifier: MIT
#pragma once

#include <support/scenes.hpp>

/// Queries about sleeping bodies.
namespace support {

inline bool isAsleep(const kodo::World& world, kodo::BodyId id) {
    return (world[id].flags() & kodo::kAsleep) != 0;
}

inline std::size_t countAsleep(const kodo::World& world) {
    std::size_t count = 0;
    for (const kodo::BodyId id : world.bodies()) {
        count += isAsleep(world, id) ? 1 : 0;
    }
    return count;
}

/// The first step after which the body is asleep, or `most` + 1.
inline int stepsUntilAsleep(kodo::World& world, kodo::BodyId id, int most) {
    for (int step = 1; step <= most; ++step) {
        world.step(kDt);
        if (isAsleep(world, id)) {
            return step;
        }
    }
    return most + 1;
}

} // namespace support
