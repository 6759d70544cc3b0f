// SPDX-License-Identifier: MIT
// Buildings: blocks that fall from their place, the collapses that they form, and broken joints.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <utility>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

bool hasFallen(kodo::BodyView body, const kodo::Transform& home) {
    const kodo::Rot now = body.rotation();
    const Real cosine = now.c * home.rotation.c + now.s * home.rotation.s;
    return cosine < kFallenCosine ||
           lengthSquared(body.position() - home.position) > kFallenWay * kFallenWay;
}

} // namespace

static void watchLinks(GameState& game);
static void dropLinks(GameState& game, BodyId body);

void watchBuildings(GameState& game) {
    watchLinks(game);
    if (game.result != Result::Playing) {
        return;
    }
    for (std::size_t i = 0; i < game.blocks.size(); ++i) {
        if (game.blocks[i].support != Support::Standing) {
            continue;
        }
        const kodo::BodyView body = std::as_const(game.world)[game.blocks[i].body];
        if (!body.isAsleep() && hasFallen(body, game.blocks[i].home)) {
            markFallen(game, i, LetGo::Why::Toppled);
        }
    }
    if (game.collapse.blocks > 0 && game.tick - game.collapse.lastTick > kCollapseGap) {
        endCollapse(game);
    }
}

/// A standing block falls, or is let go: it counts as cleared, and is rubble from now on.
void markFallen(GameState& game, std::size_t index, LetGo::Why why) {
    Block& block = game.blocks[index];
    const Vec2 place = game.frameOf(block).position;
    std::int32_t points = 0;
    if (block.counts()) {
        points = addToCollapse(game, block, place);
        --game.counts.blocksLeft;
    }
    if (why == LetGo::Why::Toppled) {
        game.clock.progress();
    } else {
        dropLinks(game, block.body);
    }
    game.world[block.body].setFlags(flagsOf(Role::Block) | kFalls | kStands);
    block.support = Support::Fallen;
    block.looseTick = game.tick;
    block.strengthLeft *= kFallenStrength;
    game.events.emplace_back(LetGo{.block = block.body,
                                   .key = block.key,
                                   .stuff = block.kind.stuff,
                                   .point = place,
                                   .why = why,
                                   .points = points});
}

/// Returns the points of the block: its own times the number of blocks in this collapse, or times
/// the combo if that is larger.
std::int32_t addToCollapse(GameState& game, const Block& block, Vec2 place) {
    ++game.collapse.blocks;
    game.collapse.lastTick = game.tick;
    game.collapse.sum += place;
    game.collapse.largest = std::max(game.collapse.largest, game.collapse.blocks);
    const std::int32_t factor =
        std::min(std::max(game.collapse.blocks, game.counts.combo), kMostCombo);
    const std::int32_t points = pointsOf(block.kind) * factor;
    game.collapse.points += points;
    game.counts.score += points;
    return points;
}

void endCollapse(GameState& game) {
    if (game.collapse.blocks >= kLeastCollapse) {
        const Vec2 middle = game.collapse.sum / static_cast<Real>(game.collapse.blocks);
        game.events.emplace_back(Collapsed{game.collapse.blocks, game.collapse.points, middle});
    }
    game.collapse = {.largest = game.collapse.largest};
}

void watchLinks(GameState& game) {
    for (const kodo::BrokenJoint& broken : game.world.brokenJoints()) {
        const auto found = std::find_if(game.links.begin(), game.links.end(),
                                        [&](const Link& link) { return link.joint == broken.id; });
        if (found != game.links.end()) {
            game.events.emplace_back(Snapped{found->kind, found->place, broken.force});
            game.clock.progress();
        }
    }
    forgetLinks(game);
    const kodo::World& world = game.world;
    for (Link& link : game.links) {
        const kodo::JointDef& def = world.joint(link.joint);
        const Vec2 anchor = std::visit(
            [](const auto& joint) {
                if constexpr (requires { joint.ends; }) {
                    return joint.ends.anchorB;
                } else {
                    return joint.anchor;
                }
            },
            def);
        link.place = world[secondBody(def)].transform() * anchor;
    }
}

void forgetLinks(GameState& game) {
    std::erase_if(game.links, [&](const Link& link) { return !game.world.contains(link.joint); });
}

/// Removes the joints of a body.
void dropLinks(GameState& game, BodyId body) {
    forgetLinks(game); // of bodies removed since
    for (const Link& link : game.links) {
        const kodo::JointDef& def = game.world.joint(link.joint);
        if (firstBody(def) == body || secondBody(def) == body) {
            game.world.remove(link.joint);
        }
    }
    forgetLinks(game);
}

} // namespace apart
