// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <cstdint>

namespace apart {

/// Role of a body in the game, one user flag each: roleOf(world[id].flags()).
enum class Role : std::uint16_t {
    Wall = 1,
    Paddle = 2,
    Block = 4,
    Ball = 8,
    Shard = 16,
    Part = 32,
    Obstruction = 128,
};
constexpr kodo::Flags flagsOf(Role role) {
    return static_cast<kodo::Flags>(role);
}
constexpr Role roleOf(kodo::Flags flags) {
    return static_cast<Role>(flags & 0xbf);
}

} // namespace apart
