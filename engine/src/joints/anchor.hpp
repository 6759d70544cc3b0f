// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/joint.hpp>

#include "bodies/bodies.hpp"

namespace kodo {
inline namespace KODO_PRECISION {

/// Vector (m, world axes) from the centre of mass to an anchor, which is in the frame of the shape.
inline Vec2 armOf(const Bodies& bodies, std::uint32_t body, Rot rotation, Vec2 anchor) {
    return rotation * (anchor - bodies.geometry(body).mass.center);
}

} // namespace KODO_PRECISION
} // namespace kodo
