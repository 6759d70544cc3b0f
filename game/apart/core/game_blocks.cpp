// SPDX-License-Identifier: MIT
// Blocks that lose their support: parts of the boss, and failing mounts.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <optional>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

/// True if two cells of the grid share a side.
bool areNeighbours(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = std::min(a, b);
    const std::uint32_t high = std::max(a, b);
    return high - low == kColumns || (high - low == 1 && high % kColumns != 0);
}

} // namespace

/// Lets go nextToFall(). It, and what falls with it, counts for no blow: the next hit begins one.
static void letGoNext(GameState& game, LetGo::Why why);
static void dropUnsupported(GameState& game, Vec2 last);

/// Gives the block its own body.
BodyId detach(GameState& game, std::size_t index) {
    Block& block = game.blocks[index];
    const BodyId whole = block.body;
    if (block.ownsBody() || game.world[whole].partCount() == 1) {
        return whole;
    }
    const std::size_t place = block.part;
    block.body = game.world.unweld(whole, place, flagsOf(Role::Block) | kFalls);
    block.part = 0;
    for (Block& other : game.blocks) {
        if (other.body == whole && other.part > place) {
            --other.part;
        }
    }
    return block.body;
}

void letGo(GameState& game, std::size_t index, LetGo::Why why) {
    if (game.blocks[index].support == Support::Standing) {
        markFallen(game, index, why);
        return;
    }
    const BodyId body = detach(game, index);
    Block& block = game.blocks[index];
    game.world[body].setType(kodo::BodyType::Dynamic);
    game.world[body].setFlags(flagsOf(Role::Block) | kFalls);
    game.world[body].setMaterial(kLooseMaterial);
    if (game.world.contains(block.pin)) {
        game.world.remove(block.pin); // with its joint
    }
    block.pin = {};
    block.support = Support::Loose;
    block.looseTick = game.tick;
    game.events.emplace_back(LetGo{.block = body,
                                   .key = block.key,
                                   .stuff = block.kind.stuff,
                                   .point = game.frameOf(block).position,
                                   .why = why});
}

void judgeBoss(GameState& game) {
    if (game.boss.impacts.empty()) {
        return;
    }
    std::optional<Vec2> last; // centre of the block detached last
    for (const Boss::Impact& impact : game.boss.impacts) {
        const auto found =
            std::find_if(game.blocks.begin(), game.blocks.end(), [&](const Block& block) {
                return block.key == impact.key && block.support == Support::Boss;
            });
        if (found == game.blocks.end()) {
            continue; // already detached by another ball in this tick
        }
        const auto index = static_cast<std::size_t>(found - game.blocks.begin());
        last = game.frameOf(*found).position;
        if (found->kind.core) {
            breakBlock(game, index, impact.point, impact.impulse);
            continue;
        }
        const Real strength = found->strengthLeft;
        letGo(game, index, LetGo::Why::BrokeOff);
        Block& block = game.blocks[index];
        block.strengthLeft = kBossBreakOff * static_cast<Real>(block.kind.strength) / 1000;
        kodo::BodyRef body = game.world[block.body];
        body.applyImpulse(impulseOnPieces(impact.impulse, strength, body.mass()), impact.point);
    }
    game.boss.impacts.clear();
    if (last) {
        dropUnsupported(game, *last);
    }
}

/// Lets go boss blocks without connection to a core. `last`: centre of the block detached last.
void dropUnsupported(GameState& game, Vec2 last) {
    std::vector<std::size_t> boss;
    std::vector<std::size_t> held; // cores, and blocks connected to one by cell sides
    for (std::size_t i = 0; i < game.blocks.size(); ++i) {
        if (game.blocks[i].support == Support::Boss) {
            (game.blocks[i].kind.core ? held : boss).push_back(i);
        }
    }
    if (held.empty()) {
        game.events.emplace_back(
            BossDown{boss.empty() ? last : game.frameOf(game.blocks[boss.front()]).position});
    }
    for (std::size_t next = 0; next < held.size(); ++next) {
        for (std::size_t i = 0; i < boss.size();) {
            if (areNeighbours(game.blocks[held[next]].key, game.blocks[boss[i]].key)) {
                held.push_back(boss[i]);
                boss.erase(boss.begin() + static_cast<std::ptrdiff_t>(i));
            } else {
                ++i;
            }
        }
    }
    for (const std::size_t index : boss) {
        letGo(game, index, LetGo::Why::Unsupported);
    }
}

void letGoNext(GameState& game, LetGo::Why why) {
    game.paddle.field.tornSpeed = 0; // it belongs to one block
    const Block* block = game.nextToFall();
    if (block == nullptr) {
        return;
    }
    game.counts.blow = false;
    const bool boss = block->support == Support::Boss;
    const Vec2 place = game.frameOf(*block).position;
    letGo(game, static_cast<std::size_t>(block - game.blocks.data()), why);
    if (boss) {
        dropUnsupported(game, place);
    }
}

/// Balls that are hollow for so long, since they do not come down, are served again.
static void takeBack(GameState& game) {
    for (const Ball& ball : game.balls) {
        game.events.emplace_back(BallLost{game.world[ball.body].position(), 1});
        game.world.remove(ball.body);
    }
    game.balls.clear();
    newServe(game);
    game.clock.progress();
}

void watchProgress(GameState& game) {
    const std::uint32_t hurry = game.counts.blocksLeft <= kLastBlocks ? kLastHurry : 1;
    if (game.counts.isDown()) {
        return;
    }
    const bool fails = game.result == Result::Playing && !game.serving() && game.clock.tick(hurry);
    if (fails && game.armed()) {
        letGoNext(game, LetGo::Why::Fatigue);
    } else if (fails) {
        takeBack(game);
    } else if (game.paddle.field.tornSpeed >= kTornSpeed) {
        letGoNext(game, LetGo::Why::Torn);
        game.clock.progress(); // counts as damage by the player
    }
    if (game.patience() == Patience::Calm) {
        game.paddle.field.tornSpeed = 0;
    }
    if (const std::optional<Patience> patience = game.clock.takeChange()) {
        game.events.emplace_back(PatienceChanged{*patience});
    }
}

void removeGoneBlocks(GameState& game) {
    for (std::size_t i = 0; i < game.blocks.size();) {
        const Block block = game.blocks[i];
        const bool fallen = block.support == Support::Fallen;
        if (!fallen && block.support != Support::Loose && block.support != Support::Moving) {
            ++i;
            continue;
        }
        const Vec2 place = game.frameOf(block).position;
        if (!isGone(place)) {
            const bool old = block.support != Support::Moving &&
                             game.tick - block.looseTick > (fallen ? kFallenTicks : kLooseTicks);
            if (old && game.result == Result::Playing) { // after the end nothing is scored
                breakBlock(game, i, place, {});
            } else {
                ++i;
            }
            continue;
        }
        if (game.result == Result::Playing) {
            land(game, game.blocks[i]);
        }
        game.ledger.removedMass += static_cast<double>(game.world[block.body].mass());
        game.world.remove(block.body);
        game.blocks.erase(game.blocks.begin() + static_cast<std::ptrdiff_t>(i));
        if (block.counts() && game.result == Result::Playing) {
            const std::int32_t worth =
                kPoints[static_cast<std::size_t>(block.kind.stuff)] / kFallDivisor;
            const std::int32_t points = game.counts.hits > 0 ? worth : 0;
            --game.counts.blocksLeft;
            game.counts.score += points;
            game.events.emplace_back(Landed{block.body, block.kind.stuff, place, points});
        }
    }
}

} // namespace apart
