// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/effects/block_bounds.hpp>

#include <variant>
#include <vector>

namespace apart {

/// What no word may cover before a serve: blocks, points of ropes and springs, and of the line of
/// dots that shows the serve.
inline std::vector<Aabb> keptFree(const Game& game) {
    std::vector<Aabb> free;
    for (const Block& block : game.blocks()) {
        free.push_back(boundsOf(game, block));
    }
    for (const Link& link : game.links()) {
        const kodo::JointDef& def = game.world().joint(link.joint);
        if (const auto* line = std::get_if<kodo::DistanceJoint>(&def)) {
            const Vec2 a = game.world()[line->ends.a].transform() * line->ends.anchorA;
            const Vec2 b = game.world()[line->ends.b].transform() * line->ends.anchorB;
            for (int i = 0; i <= 100; ++i) {
                const Vec2 place = a + static_cast<Real>(i) / 100 * (b - a);
                free.push_back({place, place});
            }
        }
    }
    const Vec2 ball = game.world()[game.balls()[0].body].position();
    for (int i = 5; i <= 44; ++i) {
        const Vec2 dot = ball + static_cast<Real>(i) / 10 * game.serveHeading();
        free.push_back({dot, dot});
    }
    return free;
}

} // namespace apart
