// SPDX-License-Identifier: MIT
// Initial scene of a game, and the motion of the boss.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

static void buildField(GameState& game);
static void buildBlocks(GameState& game);
static void buildBoss(GameState& game);
static void buildObstructions(GameState& game);
static void buildFreeBlocks(GameState& game);
static void buildLinks(GameState& game);
static void addBlock(GameState& game, Block block);
static void hang(GameState& game, Block& block);

void buildField(GameState& game) {
    renewFields(game);
    for (const kodo::BodyDef& def : wallDefs()) {
        game.walls.push_back(game.world.add(def));
    }
}

void buildBlocks(GameState& game) {
    for (const Cell& cell : game.origin.level->cells) {
        const BlockKind& kind = game.origin.level->kinds[cell.kind];
        Block block{.kind = kind,
                    .strengthLeft = static_cast<Real>(kind.strength) / 1000,
                    .key = static_cast<std::uint32_t>(cell.row * kColumns + cell.column),
                    .support = kind.support};
        if (kind.support == Support::Boss) {
            block.local = centerOf(cell); // m, world; until buildBoss(game)
        } else {
            block.body = game.world.add(blockDef(kind, centerOf(cell)));
        }
        if (kind.support == Support::Hanging) {
            hang(game, block);
        }
        addBlock(game, block);
    }
}

/// Appends a block that has its body, unless it belongs to the boss.
void addBlock(GameState& game, Block block) {
    if (block.support == Support::Standing || block.support == Support::Moving) {
        kodo::BodyRef body = game.world[block.body];
        body.setType(kodo::BodyType::Dynamic);
        body.setFlags(flagsOf(Role::Block) | kStands);
        body.setMaterial(kStandingMaterial);
        block.home = body.transform();
    }
    game.blocks.push_back(block);
    game.counts.blocksAtStart += block.kind.breakable() ? 1 : 0;
    game.counts.blocksLeft = game.counts.blocksAtStart;
    game.counts.prizeUnit += block.counts() ? kPrizeFactor * pointsOf(block.kind) : 0;
}

void buildFreeBlocks(GameState& game) {
    if (!game.origin.level->freeBlocks.empty()) { // a tower sinks less into itself
        kodo::StepSettings settings = game.world.settings();
        settings.soft().contactHertz = kBuildingHertz;
        game.world.setSettings(settings);
    }
    for (std::size_t i = 0; i < game.origin.level->freeBlocks.size(); ++i) {
        const FreeBlock& def = game.origin.level->freeBlocks[i];
        const BlockKind& kind = game.origin.level->kinds[def.kind];
        addBlock(game, {.body = game.world.add(blockDef(kind, placedShapeOf(def))),
                        .kind = kind,
                        .strengthLeft = static_cast<Real>(kind.strength) / 1000,
                        .key = keyOfFree(i),
                        .support = kind.support});
    }
}

void buildLinks(GameState& game) {
    const std::size_t first =
        game.origin.level->cells.size(); // free blocks follow those of the grid
    const auto bodyOf = [&](std::int32_t index, Vec2 place) {
        return index < 0 ? game.world.add(pivotDef(place))
                         : game.blocks[first + static_cast<std::size_t>(index)].body;
    };
    for (const LinkDef& def : game.origin.level->links) {
        const Vec2 place{static_cast<Real>(def.fromX) / 1000, static_cast<Real>(def.fromY) / 1000};
        const BodyId a = bodyOf(def.a, place);
        const BodyId b = bodyOf(def.b, place);
        const kodo::World& world = game.world;
        const kodo::JointDef joint = jointOf(def, world[a], world[b]);
        const kodo::JointId id =
            std::visit([&](const auto& alternative) { return game.world.add(alternative); }, joint);
        game.buildings.links.push_back(
            {def.kind,
             id, // its end at b
             {static_cast<Real>(def.toX) / 1000, static_cast<Real>(def.toY) / 1000}});
    }
}

void hang(GameState& game, Block& block) {
    const Vec2 up{0, static_cast<Real>(block.kind.arm) / 1000};
    kodo::BodyRef body = game.world[block.body];
    body.setType(kodo::BodyType::Dynamic);
    body.setFlags(flagsOf(Role::Block) | kFalls);
    block.pin = game.world.add(pinDef(body.position() + up));
    game.world.add(kodo::RevoluteJoint{.ends = {.a = block.pin, .b = block.body, .anchorB = up},
                                       .motorTorque = kHingeTorque});
}

void buildBoss(GameState& game) {
    Vec2 low{kFieldWidth, kFieldHeight};
    Vec2 high{-kFieldWidth, 0};
    for (const Block& block : game.blocks) {
        if (block.support == Support::Boss) {
            low = {std::min(low.x, block.local.x), std::min(low.y, block.local.y)};
            high = {std::max(high.x, block.local.x), std::max(high.y, block.local.y)};
        }
    }
    const Vec2 middle = (low + high) / Real(2);
    game.boss.home = middle.x;
    for (Block& block : game.blocks) {
        if (block.support != Support::Boss) {
            continue;
        }
        block.local -= middle;
        kodo::BodyDef def = blockDef(block.kind, middle);
        const kodo::Box box{kCellWidth, kCellHeight, block.local};
        if (game.world.contains(game.boss.body)) {
            block.part = game.world.weld(game.boss.body, box, def.material, def.density);
        } else {
            def.shape = box;
            game.boss.body = game.world.add(def);
        }
        block.body = game.boss.body;
    }
}

void buildObstructions(GameState& game) {
    for (const ObstructionDef& def : game.origin.level->obstructions) {
        Obstruction obstruction{.kind = def.kind, .body = game.world.add(obstructionDef(def))};
        const auto speed = static_cast<Real>(def.speed) / 1000;
        if (def.kind == ObstructionKind::Bumper) {
            obstruction.kick = speed;
        }
        if (def.kind == ObstructionKind::Motor) {
            obstruction.pivot = game.world.add(pivotDef(game.world[obstruction.body].position()));
            game.world.add(
                kodo::RevoluteJoint{.ends = {.a = obstruction.pivot, .b = obstruction.body},
                                    .motorSpeed = speed,
                                    .motorTorque = kMotorTorque});
        }
        game.obstructions.push_back(obstruction);
    }
}

void driveBoss(GameState& game) {
    if (!game.livingBoss() || game.origin.level->bossSpeed == 0) {
        return;
    }
    kodo::BodyRef body = game.world[game.boss.body];
    const kodo::Aabb bounds = body.bounds();
    const Vec2 place = body.position();
    const auto drift = static_cast<Real>(game.origin.level->bossDrift) / 1000;
    // The walls limit the amplitude.
    const Real left = std::max(game.boss.home - drift, place.x - bounds.lower.x - kFieldWidth / 2);
    const Real right = std::min(game.boss.home + drift, place.x - bounds.upper.x + kFieldWidth / 2);
    const Real way =
        static_cast<Real>(game.boss.way * game.origin.level->bossSpeed) / 1000 * kTickSeconds;
    const Real next = std::clamp(place.x + way, std::min(left, place.x), std::max(right, place.x));
    if (next <= left || next >= right) {
        game.boss.way = next <= left ? 1 : -1;
    }
    body.moveTo({next, place.y}, kTickSeconds);
}

void buildScene(GameState& game) {
    fillWaters(game);
    buildField(game);
    buildBlocks(game);
    buildBoss(game);
    buildObstructions(game);
    buildFreeBlocks(game);
    buildLinks(game);
}

} // namespace apart
