// SPDX-License-Identifier: MIT
// Initial scene of a game, and the motion of the boss.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

void Game::buildField() {
    renewFields();
    for (const kodo::BodyDef& def : wallDefs()) {
        walls_.push_back(world_.add(def));
    }
}

void Game::buildBlocks() {
    for (const Cell& cell : level_->cells) {
        const BlockKind& kind = level_->kinds[cell.kind];
        Block block{.kind = kind,
                    .strengthLeft = static_cast<Real>(kind.strength) / 1000,
                    .key = static_cast<std::uint32_t>(cell.row * kColumns + cell.column),
                    .support = kind.support};
        if (kind.support == Support::Boss) {
            block.local = centerOf(cell); // m, world; until buildBoss()
        } else {
            block.body = world_.add(blockDef(kind, centerOf(cell)));
        }
        if (kind.support == Support::Hanging) {
            hang(block);
        }
        addBlock(block);
    }
}

/// Appends a block that has its body, unless it belongs to the boss.
void Game::addBlock(Block block) {
    if (block.support == Support::Standing || block.support == Support::Moving) {
        kodo::BodyRef body = world_[block.body];
        body.setType(kodo::BodyType::Dynamic);
        body.setFlags(flagsOf(Role::Block) | kStands);
        body.setMaterial(kStandingMaterial);
        block.home = body.transform();
    }
    blocks_.push_back(block);
    blocksAtStart_ += block.kind.breakable() ? 1 : 0;
    blocksLeft_ = blocksAtStart_;
}

void Game::buildFreeBlocks() {
    if (!level_->freeBlocks.empty()) { // a tower sinks less into itself
        kodo::StepSettings settings = world_.settings();
        settings.soft().contactHertz = kBuildingHertz;
        world_.setSettings(settings);
    }
    for (std::size_t i = 0; i < level_->freeBlocks.size(); ++i) {
        const FreeBlock& def = level_->freeBlocks[i];
        const BlockKind& kind = level_->kinds[def.kind];
        addBlock({.body = world_.add(blockDef(kind, placedShapeOf(def))),
                  .kind = kind,
                  .strengthLeft = static_cast<Real>(kind.strength) / 1000,
                  .key = keyOfFree(i),
                  .support = kind.support});
    }
}

void Game::buildLinks() {
    const std::size_t first = level_->cells.size(); // free blocks follow those of the grid
    const auto bodyOf = [&](std::int32_t index, Vec2 place) {
        return index < 0 ? world_.add(pivotDef(place))
                         : blocks_[first + static_cast<std::size_t>(index)].body;
    };
    for (const LinkDef& def : level_->links) {
        const Vec2 place{static_cast<Real>(def.fromX) / 1000, static_cast<Real>(def.fromY) / 1000};
        const BodyId a = bodyOf(def.a, place);
        const BodyId b = bodyOf(def.b, place);
        const kodo::World& world = world_;
        const kodo::JointDef joint = jointOf(def, world[a], world[b]);
        const kodo::JointId id =
            std::visit([&](const auto& alternative) { return world_.add(alternative); }, joint);
        links_.push_back({def.kind,
                          id, // its end at b
                          {static_cast<Real>(def.toX) / 1000, static_cast<Real>(def.toY) / 1000}});
    }
}

void Game::hang(Block& block) {
    const Vec2 up{0, static_cast<Real>(block.kind.arm) / 1000};
    kodo::BodyRef body = world_[block.body];
    body.setType(kodo::BodyType::Dynamic);
    body.setFlags(flagsOf(Role::Block) | kFalls);
    block.pin = world_.add(pinDef(body.position() + up));
    world_.add(kodo::RevoluteJoint{.ends = {.a = block.pin, .b = block.body, .anchorB = up},
                                   .motorTorque = kHingeTorque});
}

void Game::buildBoss() {
    Vec2 low{kFieldWidth, kFieldHeight};
    Vec2 high{-kFieldWidth, 0};
    for (const Block& block : blocks_) {
        if (block.support == Support::Boss) {
            low = {std::min(low.x, block.local.x), std::min(low.y, block.local.y)};
            high = {std::max(high.x, block.local.x), std::max(high.y, block.local.y)};
        }
    }
    const Vec2 middle = (low + high) / Real(2);
    bossHome_ = middle.x;
    for (Block& block : blocks_) {
        if (block.support != Support::Boss) {
            continue;
        }
        block.local -= middle;
        kodo::BodyDef def = blockDef(block.kind, middle);
        const kodo::Box box{kCellWidth, kCellHeight, block.local};
        if (world_.contains(boss_)) {
            block.part = world_.weld(boss_, box, def.material, def.density);
        } else {
            def.shape = box;
            boss_ = world_.add(def);
        }
        block.body = boss_;
    }
}

void Game::buildObstructions() {
    for (const ObstructionDef& def : level_->obstructions) {
        Obstruction obstruction{.kind = def.kind, .body = world_.add(obstructionDef(def))};
        const auto speed = static_cast<Real>(def.speed) / 1000;
        if (def.kind == ObstructionKind::Bumper) {
            obstruction.kick = speed;
        }
        if (def.kind == ObstructionKind::Motor) {
            obstruction.pivot = world_.add(pivotDef(world_[obstruction.body].position()));
            world_.add(kodo::RevoluteJoint{.ends = {.a = obstruction.pivot, .b = obstruction.body},
                                           .motorSpeed = speed,
                                           .motorTorque = kMotorTorque});
        }
        obstructions_.push_back(obstruction);
    }
}

void Game::driveBoss() {
    if (!boss() || level_->bossSpeed == 0) {
        return;
    }
    kodo::BodyRef body = world_[boss_];
    const kodo::Aabb bounds = body.bounds();
    const Vec2 place = body.position();
    const auto drift = static_cast<Real>(level_->bossDrift) / 1000;
    // The walls limit the amplitude.
    const Real left = std::max(bossHome_ - drift, place.x - bounds.lower.x - kFieldWidth / 2);
    const Real right = std::min(bossHome_ + drift, place.x - bounds.upper.x + kFieldWidth / 2);
    const Real way = static_cast<Real>(bossWay_ * level_->bossSpeed) / 1000 * kTickSeconds;
    const Real next = std::clamp(place.x + way, std::min(left, place.x), std::max(right, place.x));
    if (next <= left || next >= right) {
        bossWay_ = next <= left ? 1 : -1;
    }
    body.moveTo({next, place.y}, kTickSeconds);
}

std::optional<BodyId> Game::boss() const {
    const bool lives = std::any_of(blocks_.begin(), blocks_.end(), [](const Block& block) {
        return block.support == Support::Boss;
    });
    return lives ? std::optional(boss_) : std::nullopt;
}

} // namespace apart
