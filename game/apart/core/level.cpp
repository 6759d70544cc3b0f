// SPDX-License-Identifier: MIT
#include <apart/core/level.hpp>
#include <kodo/state_hash.hpp>

#include <algorithm>

namespace apart {

namespace {

void add(kodo::StateHash& hash, const BlockKind& kind) {
    hash.add(static_cast<std::uint8_t>(kind.stuff));
    hash.add(static_cast<std::uint8_t>(kind.power));
    hash.add(static_cast<std::uint8_t>(kind.pattern));
    hash.add(kind.strength);
    hash.add(static_cast<std::uint8_t>(kind.support));
    hash.add(kind.arm);
    hash.add(static_cast<std::uint8_t>(kind.core));
}

void add(kodo::StateHash& hash, const ObstructionDef& def) {
    hash.add(static_cast<std::uint8_t>(def.kind));
    for (const std::int32_t number : {def.x, def.y, def.size, def.speed, def.spacing}) {
        hash.add(number);
    }
    hash.add(def.height);
    hash.add(def.turn);
    hash.add(static_cast<std::uint8_t>(def.facing));
    hash.add(static_cast<std::uint64_t>(def.heights.size()));
    for (const std::int32_t height : def.heights) {
        hash.add(height);
    }
    for (const GroundPoint& point :
         def.points) { // without an outline: the digest of older versions
        hash.add(point.x);
        hash.add(point.y);
    }
}

void add(kodo::StateHash& hash, const FreeBlock& block) {
    hash.add(static_cast<std::uint8_t>(block.form));
    hash.add(static_cast<std::uint8_t>(block.mirrored));
    for (const std::int32_t number :
         {block.x, block.y, block.turn, block.width, block.height, block.extra}) {
        hash.add(number);
    }
}

void add(kodo::StateHash& hash, const LinkDef& link) {
    hash.add(static_cast<std::uint8_t>(link.kind));
    hash.add(static_cast<std::uint8_t>(link.limited));
    for (const std::int32_t number :
         {link.a, link.b, link.fromX, link.fromY, link.toX, link.toY, link.slack, link.hertz,
          link.axis, link.low, link.high, link.speed, link.torque, link.strength}) {
        hash.add(number);
    }
}

} // namespace

bool hasGround(const Level& level) {
    return std::any_of(
        level.obstructions.begin(), level.obstructions.end(),
        [](const ObstructionDef& def) { return def.kind == ObstructionKind::Ground; });
}

bool isBuilding(const Level& level) {
    const auto breaks = [&](const auto& block) { return level.kinds[block.kind].breakable(); };
    const auto stands = [&](const FreeBlock& block) {
        return breaks(block) && level.kinds[block.kind].support == Support::Standing;
    };
    const auto all = std::count_if(level.cells.begin(), level.cells.end(), breaks) +
                     std::count_if(level.freeBlocks.begin(), level.freeBlocks.end(), breaks);
    return 2 * std::count_if(level.freeBlocks.begin(), level.freeBlocks.end(), stands) >= all &&
           all > 0;
}

bool asksForReturn(const Level& level) {
    return isBuilding(level) || !level.links.empty();
}

std::uint64_t digestOf(const Level& level) {
    kodo::StateHash hash;
    hash.add(level.ballSpeed);
    hash.add(level.lives);
    hash.add(static_cast<std::uint8_t>(level.ball));
    hash.add(static_cast<std::uint8_t>(level.paddle));
    for (const std::int32_t number : {level.wind, level.bossDrift, level.bossSpeed}) {
        hash.add(number);
    }
    hash.add(static_cast<std::uint64_t>(level.cells.size()));
    for (const Cell& cell : level.cells) {
        hash.add(cell.row);
        hash.add(cell.column);
        add(hash, level.kinds[cell.kind]);
    }
    hash.add(static_cast<std::uint64_t>(level.freeBlocks.size()));
    for (const FreeBlock& block : level.freeBlocks) {
        add(hash, block);
        add(hash, level.kinds[block.kind]);
    }
    hash.add(static_cast<std::uint64_t>(level.links.size()));
    for (const LinkDef& link : level.links) {
        add(hash, link);
    }
    hash.add(static_cast<std::uint64_t>(level.obstructions.size()));
    for (const ObstructionDef& def : level.obstructions) {
        add(hash, def);
    }
    hash.add(static_cast<std::uint64_t>(level.wells.size()));
    for (const WellDef& well : level.wells) {
        for (const std::int32_t number : {well.x, well.y, well.strength}) {
            hash.add(number);
        }
    }
    for (const WaterDef& water : level.waters) { // without water: the digest of older versions
        for (const std::int32_t number :
             {water.x, water.y, water.width, water.depth, water.density, water.dam}) {
            hash.add(number);
        }
    }
    if (level.keep >= 0) {
        hash.add(level.keep);
    }
    return hash.value();
}

} // namespace apart
