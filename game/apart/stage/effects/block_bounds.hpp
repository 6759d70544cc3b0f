// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>

namespace apart {

/// Bounds of a block, which may be one part of a body.
inline kodo::Aabb boundsOf(const Game& game, const Block& block) {
    const kodo::BodyView body = game.world()[block.body];
    if (block.ownsBody()) {
        return body.bounds();
    }
    const kodo::Vec2 middle = body.massFrame() * body.part(block.part).convex.middle;
    const kodo::Vec2 half{kCellWidth / 2, kCellHeight / 2};
    return {middle - half, middle + half};
}

} // namespace apart
