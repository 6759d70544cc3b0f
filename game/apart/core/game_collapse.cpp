// SPDX-License-Identifier: MIT
// Buildings: blocks that fall from their place, the collapses that they form, and broken joints.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

bool isFar(Vec2 from, Vec2 to) {
    return lengthSquared(to - from) > kFallenWay * kFallenWay;
}

bool hasFallen(const GameState& game, const Block& block) {
    const kodo::BodyView body = game.world[block.body];
    const kodo::Rot now = body.rotation();
    const kodo::Rot home = block.home.rotation;
    const Vec2 place = body.position();
    return now.c * home.c + now.s * home.s < kFallenCosine ||
           (isFar(block.home.position, place) && (isGone(place) || !game.isCarried(block)));
}

/// True if little of a building is left above its lowest block.
bool isLow(const GameState& game) {
    const Level& level = *game.origin.level;
    std::vector<Real> heights; // m, of its blocks at the start
    for (const FreeBlock& block : level.freeBlocks) {
        if (level.kinds[block.kind].breakable() &&
            level.kinds[block.kind].support == Support::Standing) {
            heights.push_back(static_cast<Real>(block.y) / 1000);
        }
    }
    const Real base = *std::min_element(heights.begin(), heights.end()) - kCellHeight / 2;
    const auto add = [&](Real sum, Real height) { return sum + std::max(height - base, Real(0)); };
    const Real full = std::accumulate(heights.begin(), heights.end(), Real(0), add);
    Real left = 0;
    for (const Block& block : game.blocks) {
        const bool stands = block.counts() && block.support == Support::Standing;
        left = stands ? add(left, game.frameOf(block).position.y) : left;
    }
    return left <= kDownShare * full;
}

/// The lowest block that is to be cleared; blocks.size(): none.
std::size_t lowestLeft(const GameState& game) {
    std::size_t lowest = game.blocks.size();
    Real height = 0;
    for (std::size_t i = 0; i < game.blocks.size(); ++i) {
        const Real y = game.blocks[i].counts() ? game.frameOf(game.blocks[i]).position.y : height;
        if (game.blocks[i].counts() && (lowest == game.blocks.size() || y < height)) {
            lowest = i;
            height = y;
        }
    }
    return lowest;
}

} // namespace

static void findCarriers(GameState& game);
static void rest(GameState& game, Block& block);
static void crumble(GameState& game);
static void watchLinks(GameState& game);
static void dropLinks(GameState& game, BodyId body);

void watchBuildings(GameState& game) {
    watchLinks(game);
    if (game.result != Result::Playing) {
        return;
    }
    if (game.tick == kTouchTicks) {
        findCarriers(game);
    }
    for (std::size_t i = 0; i < game.blocks.size(); ++i) {
        const Support support = game.blocks[i].support;
        if (support != Support::Standing && support != Support::Fallen) {
            continue;
        }
        const bool asleep = std::as_const(game.world)[game.blocks[i].body].isAsleep();
        if (support == Support::Fallen && asleep) {
            rest(game, game.blocks[i]);
        } else if (support == Support::Standing && !asleep && hasFallen(game, game.blocks[i])) {
            markFallen(game, i, LetGo::Why::Toppled);
        }
    }
    const bool quiet = game.tick - game.buildings.collapse.lastTick > kCollapseGap;
    if (game.buildings.collapse.blocks > 0 && quiet && game.counts.blocksLeft > 0 &&
        !game.falls()) {
        endCollapse(game);
    }
    crumble(game);
}

void findCarriers(GameState& game) {
    constexpr Real kUpwards = Real(0.3); // of a normal, towards the block that is carried
    const auto stands = [&](BodyId body) {
        const Block* block = game.findBlock(body);
        return block != nullptr && block->support == Support::Standing;
    };
    const kodo::World& world = game.world;
    const auto add = [&](BodyId block, BodyId by) {
        if (stands(block)) {
            game.buildings.carriers.push_back(
                {block, by, toLocal(world[by].transform(), world[block].position())});
        }
    };
    for (const kodo::CollisionRecord& hit : world.collisions()) {
        if (std::abs(hit.normal.y) > kUpwards) {
            hit.normal.y > 0 ? add(hit.b, hit.a) : add(hit.a, hit.b);
        }
    }
    for (const Link& link : game.buildings.links) {
        const kodo::JointDef& def = world.joint(link.joint);
        add(secondBody(def), firstBody(def));
    }
}

bool GameState::isCarried(const Block& block) const {
    const Vec2 place = world[block.body].position();
    for (const Carrier& carrier : buildings.carriers) {
        if (carrier.block != block.body || !world.contains(carrier.by)) {
            continue;
        }
        const Block* by = findBlock(carrier.by);
        const bool fallen = by != nullptr && by->support == Support::Fallen;
        if (!fallen && !isFar(carrier.place, toLocal(world[carrier.by].transform(), place))) {
            return true;
        }
    }
    for (std::size_t i = 0; i < waters.size(); ++i) { // afloat, as high above the surface as before
        const Vec2 home = block.home.position;
        const kodo::Aabb& water = waters[i].region;
        const auto top = static_cast<Real>(origin.level->waters[i].y) / 1000;
        const bool within = std::min(home.x, place.x) > water.lower.x &&
                            std::max(home.x, place.x) < water.upper.x && home.y > water.lower.y &&
                            home.y < top + kFallenWay;
        if (within && !waters[i].open &&
            std::abs(place.y - water.upper.y - (home.y - top)) < kFallenWay) {
            return true;
        }
    }
    return false;
}

/// Breaks what is left of a building that is down, block by block.
void crumble(GameState& game) {
    if (!game.counts.isDown()) {
        const bool quiet = game.tick - game.buildings.collapse.lastTick > kDownTicks;
        const bool down = game.armed() && quiet && isBuilding(*game.origin.level) && isLow(game);
        game.counts.downTick = down ? game.tick : 0;
    }
    if (!game.counts.isDown()) {
        return;
    }
    const std::size_t lowest = lowestLeft(game);
    if (lowest < game.blocks.size() && (game.tick - game.counts.downTick) % kCrumbleTicks == 0) {
        breakBlock(game, lowest, game.frameOf(game.blocks[lowest]).position, {});
    }
}

/// Rubble that has come to rest has landed. In a level with ground it stays until it is moved, and
/// for half of its lifetime at least from then on.
void rest(GameState& game, Block& block) {
    land(game, block);
    if (hasGround(*game.origin.level)) {
        block.looseTick =
            std::max(block.looseTick + kFallenTicks / 2, game.tick) - kFallenTicks / 2;
    }
}

bool GameState::falls() const {
    return std::any_of(blocks.begin(), blocks.end(),
                       [](const Block& block) { return block.due > 0; });
}

/// `impact`: with what it landed on; nullptr: it came to rest, broke or left.
void land(GameState& game, Block& block, const kodo::CollisionRecord* impact) {
    if (block.due > 0) {
        const Vec2 place = impact != nullptr ? impact->point : game.frameOf(block).position;
        ++game.buildings.collapse.landed;
        game.buildings.collapse.sum += place;
        game.counts.score += block.due;
        game.events.emplace_back(
            Landed{.block = block.body,
                   .stuff = block.kind.stuff,
                   .point = place,
                   .points = std::exchange(block.due, 0),
                   .impulse = impact != nullptr ? impact->totalImpulse : Real(0)});
    }
}

/// A standing block falls, or is let go: it counts as cleared, and is rubble from now on.
void markFallen(GameState& game, std::size_t index, LetGo::Why why) {
    Block& block = game.blocks[index];
    const Vec2 place = game.frameOf(block).position;
    if (block.counts()) {
        block.due = addToCollapse(game, block);
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
                                   .why = why});
}

/// Its own points times the number of blocks in this collapse, or times the combo if that is
/// larger. Before the first serve nothing is worth points, and nothing is multiplied once the
/// building is down.
std::int32_t addToCollapse(GameState& game, const Block& block) {
    if (game.counts.hits == 0) {
        return 0;
    }
    ++game.buildings.collapse.blocks;
    game.buildings.collapse.lastTick = game.tick;
    game.buildings.collapse.largest =
        std::max(game.buildings.collapse.largest, game.buildings.collapse.blocks);
    const std::int32_t chain = std::max(game.buildings.collapse.blocks, game.counts.combo);
    const std::int32_t factor = game.counts.isDown() ? 1 : std::min(chain, kMostCombo);
    const std::int32_t points = pointsOf(block.kind) * factor;
    game.buildings.collapse.points += points;
    return points;
}

void endCollapse(GameState& game) {
    if (game.buildings.collapse.blocks >= kLeastCollapse) {
        const Vec2 middle = game.buildings.collapse.sum /
                            static_cast<Real>(std::max(game.buildings.collapse.landed, 1));
        game.events.emplace_back(
            Collapsed{game.buildings.collapse.blocks, game.buildings.collapse.points, middle});
    }
    game.buildings.collapse = {.largest = game.buildings.collapse.largest};
}

void watchLinks(GameState& game) {
    for (const kodo::BrokenJoint& broken : game.world.brokenJoints()) {
        const auto found = std::find_if(game.buildings.links.begin(), game.buildings.links.end(),
                                        [&](const Link& link) { return link.joint == broken.id; });
        if (found != game.buildings.links.end()) {
            game.events.emplace_back(Snapped{found->kind, found->place, broken.force});
            game.clock.progress();
        }
    }
    forgetLinks(game);
    const kodo::World& world = game.world;
    for (Link& link : game.buildings.links) {
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
    std::erase_if(game.buildings.links,
                  [&](const Link& link) { return !game.world.contains(link.joint); });
}

/// Removes the joints of a body.
void dropLinks(GameState& game, BodyId body) {
    forgetLinks(game); // of bodies removed since
    for (const Link& link : game.buildings.links) {
        const kodo::JointDef& def = game.world.joint(link.joint);
        if (firstBody(def) == body || secondBody(def) == body) {
            game.world.remove(link.joint);
        }
    }
    forgetLinks(game);
}

} // namespace apart
