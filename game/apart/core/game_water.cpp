// SPDX-License-Identifier: MIT
// Water: what floats on it, what splashes, and how it runs out.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>
#include <apart/core/water.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

/// Index into Level::kinds of a block with this key; -1: it is not of the level.
std::int32_t kindOfKey(const Level& level, std::uint32_t key) {
    if (key >= keyOfFree(0)) {
        const std::size_t index = key - keyOfFree(0);
        return index < level.freeBlocks.size() ? level.freeBlocks[index].kind : -1;
    }
    const auto found = std::find_if(level.cells.begin(), level.cells.end(), [&](const Cell& cell) {
        return static_cast<std::uint32_t>(cell.row * kColumns + cell.column) == key;
    });
    return found == level.cells.end() ? -1 : found->kind;
}

} // namespace

static void openDams(GameState& game);
static void runOut(GameState& game);
static void splash(GameState& game, kodo::BodyId id);

Real Water::floor() const {
    return std::clamp(breach.y - kBreachDepth, region.lower.y,
                      std::max(region.upper.y, region.lower.y));
}

void fillWaters(GameState& game) {
    for (const WaterDef& def : game.origin.level->waters) {
        const auto metres = [](std::int32_t milli) { return static_cast<Real>(milli) / 1000; };
        const Real half = metres(def.width) / 2;
        const Vec2 top{metres(def.x), metres(def.y)};
        game.waters.push_back(
            {.region = {{top.x - half, top.y - metres(def.depth)}, {top.x + half, top.y}},
             .density = metres(def.density),
             .dam = def.dam});
    }
}

void addWaterFields(const GameState& game, std::vector<kodo::FieldEntry>& fields) {
    for (const Water& water : game.waters) {
        if (water.isEmpty()) {
            continue;
        }
        const bool flows = water.open && water.region.upper.y > water.floor();
        const Vec2 way = water.breach - water.region.center();
        const Vec2 flow = flows ? kCurrent * normalize(way) : Vec2{};
        fields.push_back(
            {std::make_shared<Pool>(Pool::Fluid{water.density, kWaterDrag, flow}, water.region),
             {.flags = kodo::kMatchAny, .required = kFalls | kStands}});
    }
}

void watchWaters(GameState& game) {
    if (game.waters.empty()) {
        return;
    }
    openDams(game);
    runOut(game);
    for (const Ball& ball : game.balls) {
        splash(game, ball.body);
    }
    for (Block& block : game.blocks) {
        const std::size_t before = game.events.size();
        splash(game, block.body);
        if (game.events.size() > before) {
            land(game, block);
        }
    }
    for (const Shard& shard : game.shards) {
        splash(game, shard.body);
    }
    for (const Part& part : game.parts) {
        splash(game, part.body);
    }
}

void openDams(GameState& game) {
    const std::size_t count = game.events.size(); // Breached is appended
    for (std::size_t i = 0; i < count; ++i) {
        const auto* broke = std::get_if<Broke>(&game.events[i]);
        const auto* let = std::get_if<LetGo>(&game.events[i]);
        if (broke == nullptr && let == nullptr) {
            continue;
        }
        const std::uint32_t key = broke != nullptr ? broke->key : let->key;
        const Vec2 place = broke != nullptr ? broke->center : let->point;
        for (Water& water : game.waters) {
            if (!water.open && water.dam >= 0 && water.dam == kindOfKey(*game.origin.level, key)) {
                water.open = true;
                water.breach = place;
                game.events.emplace_back(Breached{place});
            }
        }
    }
}

void runOut(GameState& game) {
    bool sinks = false;
    for (Water& water : game.waters) {
        if (water.open && water.region.upper.y > water.floor()) {
            water.region.upper.y =
                std::max(water.region.upper.y - kOutflow * kTickSeconds, water.floor());
            sinks = true;
        }
    }
    if (sinks) {
        renewFields(game);
    }
}

void splash(GameState& game, kodo::BodyId id) {
    const kodo::BodyView body = std::as_const(game.world)[id];
    const Real speed = body.velocity().y;
    if (body.isAsleep() || std::abs(speed) < kSplashSpeed) {
        return;
    }
    const Vec2 place = body.center();
    for (const Water& water : game.waters) {
        const Real height = place.y - water.region.upper.y;
        const Real before = height - speed * kTickSeconds;
        const bool within = place.x > water.region.lower.x && place.x < water.region.upper.x;
        if (within && !water.isEmpty() && (height < 0) != (before < 0)) {
            game.events.emplace_back(
                Splashed{id, {place.x, water.region.upper.y}, speed, body.mass()});
        }
    }
}

} // namespace apart
