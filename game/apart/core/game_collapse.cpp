// SPDX-License-Identifier: MIT
// Buildings: blocks that fall from their place, the collapses that they form, and broken joints.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
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

void Game::watchBuildings() {
    watchLinks();
    if (result_ != Result::Playing) {
        return;
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (blocks_[i].support != Support::Standing) {
            continue;
        }
        const kodo::BodyView body = std::as_const(world_)[blocks_[i].body];
        if (!body.isAsleep() && hasFallen(body, blocks_[i].home)) {
            markFallen(i, LetGo::Why::Toppled);
        }
    }
    if (collapse_.blocks > 0 && tick_ - collapse_.lastTick > kCollapseGap) {
        endCollapse();
    }
}

/// A standing block falls, or is let go: it counts as cleared, and is rubble from now on.
void Game::markFallen(std::size_t index, LetGo::Why why) {
    Block& block = blocks_[index];
    const Vec2 place = frameOf(block).position;
    std::int32_t points = 0;
    if (block.counts()) {
        points = addToCollapse(block, place);
        --blocksLeft_;
    }
    if (why == LetGo::Why::Toppled) {
        clock_.progress();
    } else {
        dropLinks(block.body);
    }
    world_[block.body].setFlags(flagsOf(Role::Block) | kFalls | kStands);
    block.support = Support::Fallen;
    block.looseTick = tick_;
    block.strengthLeft *= kFallenStrength;
    events_.emplace_back(LetGo{.block = block.body,
                               .key = block.key,
                               .stuff = block.kind.stuff,
                               .point = place,
                               .why = why,
                               .points = points});
}

/// Returns the points of the block: its own times the number of blocks in this collapse, or times
/// the combo if that is larger.
std::int32_t Game::addToCollapse(const Block& block, Vec2 place) {
    ++collapse_.blocks;
    collapse_.lastTick = tick_;
    collapse_.sum += place;
    collapse_.largest = std::max(collapse_.largest, collapse_.blocks);
    const std::int32_t factor = std::min(std::max(collapse_.blocks, combo_), kMostCombo);
    const std::int32_t points = pointsOf(block.kind) * factor;
    collapse_.points += points;
    score_ += points;
    return points;
}

void Game::endCollapse() {
    if (collapse_.blocks >= kLeastCollapse) {
        const Vec2 middle = collapse_.sum / static_cast<Real>(collapse_.blocks);
        events_.emplace_back(Collapsed{collapse_.blocks, collapse_.points, middle});
    }
    collapse_ = {.largest = collapse_.largest};
}

void Game::watchLinks() {
    for (const kodo::BrokenJoint& broken : world_.brokenJoints()) {
        const auto found = std::find_if(links_.begin(), links_.end(),
                                        [&](const Link& link) { return link.joint == broken.id; });
        if (found != links_.end()) {
            events_.emplace_back(Snapped{found->kind, found->place, broken.force});
            clock_.progress();
        }
    }
    std::erase_if(links_, [&](const Link& link) { return !world_.contains(link.joint); });
    const kodo::World& world = world_;
    for (Link& link : links_) {
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

/// Removes the joints of a body.
void Game::dropLinks(BodyId body) {
    for (const Link& link : links_) {
        const kodo::JointDef& def = world_.joint(link.joint);
        if (firstBody(def) == body || secondBody(def) == body) {
            world_.remove(link.joint);
        }
    }
    std::erase_if(links_, [&](const Link& link) { return !world_.contains(link.joint); });
}

} // namespace apart
