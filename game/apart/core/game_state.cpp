// SPDX-License-Identifier: MIT
#include <apart/core/field.hpp>
#include <apart/core/game_state.hpp>
#include <apart/core/tuning.hpp>
#include <kodo/query.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

const Block* GameState::findBlock(BodyId body, std::size_t part) const {
    const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const Block& block) {
        return block.body == body && (block.ownsBody() || block.part == part);
    });
    return found == blocks.end() ? nullptr : &*found;
}

bool GameState::keeps() const {
    if (origin.level->keep < 0) {
        return false;
    }
    const std::uint32_t key = keyOfFree(static_cast<std::size_t>(origin.level->keep));
    return std::any_of(blocks.begin(), blocks.end(), [&](const Block& block) {
        const bool held = block.support == Support::Standing || block.support == Support::Moving;
        return block.key == key && held &&
               world[block.body].position().y > block.home.position.y - kFallenWay;
    });
}

bool GameState::serving() const {
    return std::any_of(balls.begin(), balls.end(), [](const Ball& ball) { return ball.riding; });
}

bool GameState::armed() const {
    return std::any_of(balls.begin(), balls.end(),
                       [](const Ball& ball) { return !ball.riding && !ball.hollow; });
}

Real GameState::ballSpeed() const {
    const auto broken = static_cast<Real>(counts.blocksAtStart - counts.blocksLeft);
    const Real share =
        counts.blocksAtStart > 0 ? broken / static_cast<Real>(counts.blocksAtStart) : Real(0);
    const Real speed = static_cast<Real>(origin.level->ballSpeed) / 1000 * (1 + kSpeedUp * share);
    return origin.mode == Mode::Assisted ? kAssistedSpeed * speed : speed;
}

bool GameState::beginsBlow(const Ball& ball) const {
    const bool asked = origin.mode == Mode::Pure && asksForReturn(*origin.level);
    return !ball.hollow && (!asked || paddle.moved > kMovedWay);
}

void Counts::hit(std::uint32_t tick, bool begins) {
    const bool apart = hits == 0 || tick - hitTick >= kHitTicks;
    if (apart && !isDown()) {
        ++hits;
        blow = begins;
        leftAtHit = blocksLeft;
    }
    hitTick = tick;
}

void Counts::watchBlow() {
    if (!blow) {
        leftAtHit = blocksLeft;
    }
    if (!isDown()) { // what comes down by itself is part of no blow
        bestBlow = std::max(bestBlow, leftAtHit - blocksLeft);
    }
}

kodo::Transform GameState::frameOf(const Block& block) const {
    const kodo::BodyView body = world[block.body];
    const kodo::Transform frame{body.position(), body.rotation()};
    return {frame * block.local, frame.rotation};
}

const Block* GameState::nextToFall() const {
    const Block* lowest = nullptr;
    Real height = 0;
    for (const Block& block : blocks) {
        if (block.support == Support::Loose || !block.counts()) {
            continue;
        }
        const Real y = frameOf(block).position.y;
        if (lowest == nullptr || y < height) { // ties: the first in grid order
            lowest = &block;
            height = y;
        }
    }
    return lowest;
}

Real GameState::tornShare() const {
    return std::min(paddle.field.tornSpeed / kTornSpeed, Real(1));
}

Real GameState::idleSeconds() const {
    return static_cast<Real>(clock.idleTicks()) * kTickSeconds;
}

bool GameState::tears() const {
    return paddle.field.force == Force::Pull && patience() != Patience::Calm && armed() &&
           nextToFall() != nullptr;
}

std::optional<kodo::QueryHit> GameState::ahead(Vec2 from, Vec2 way) const {
    constexpr Real kSlim = Real(0.9); // share of the radius: the ball may touch a surface
    const auto what = static_cast<std::uint16_t>(flagsOf(Role::Wall) | flagsOf(Role::Block) |
                                                 flagsOf(Role::Obstruction));
    return shapeCast(world, kodo::Circle{kSlim * kBallRadius}, {from, {}}, way,
                     {kodo::kMatchAny, what});
}

bool GameState::meetsBlock(Vec2 from, Vec2 way) const {
    const std::optional<kodo::QueryHit> hit = ahead(from, way);
    const Block* block = hit ? findBlock(hit->body, hit->part) : nullptr;
    return block != nullptr && block->counts();
}

std::optional<Real> GameState::wayToBlock(Vec2 from, Vec2 heading) const {
    constexpr int kForesight = 6;     // bounces
    constexpr Real kOff = Real(0.01); // m; distance from the surface after a bounce
    Real way = 0;
    for (int bounce = 0; bounce < kForesight && from.y > kPaddleY; ++bounce) {
        const std::optional<kodo::QueryHit> hit = ahead(from, kFarSight * heading);
        if (!hit || hit->normal == Vec2{}) {
            break;
        }
        way += hit->fraction * kFarSight;
        const Block* block = findBlock(hit->body, hit->part);
        if (block != nullptr && block->counts()) {
            return way;
        }
        from += hit->fraction * kFarSight * heading + kOff * hit->normal;
        heading -= 2 * dot(heading, hit->normal) * hit->normal;
    }
    return std::nullopt;
}

bool GameState::canCarry(BodyId body) const {
    if (!world.contains(body)) {
        return false;
    }
    const kodo::BodyView view = world[body];
    const Role role = roleOf(view.flags());
    return (role == Role::Obstruction || role == Role::Block) &&
           view.type() == kodo::BodyType::Dynamic;
}

bool GameState::isRubble(BodyId body) const {
    if (!world.contains(body)) {
        return false;
    }
    const kodo::Flags flags = world[body].flags();
    const Role role = roleOf(flags);
    // A block of a building falls as rubble does.
    return role == Role::Shard || role == Role::Part ||
           (role == Role::Block && (flags & kStands) != 0);
}

BallKind GameState::ballKind() const {
    for (const Effect& effect : powers.effects) {
        if (const std::optional<BallKind> kind = ballKindOf(effect.power)) {
            return *kind;
        }
    }
    return origin.level->ball;
}

PaddleKind GameState::paddleKind() const {
    if (secondsLeft(Power::Spring) <= 0) {
        return origin.level->paddle;
    }
    return tilts(origin.level->paddle) ? PaddleKind::Loose : PaddleKind::Recoiling;
}

Real GameState::secondsLeft(Power power) const {
    for (const Effect& effect : powers.effects) {
        if (effect.power == power && effect.untilTick > tick) {
            return static_cast<Real>(effect.untilTick - tick) * kTickSeconds;
        }
    }
    return 0;
}

Real GameState::windSpeed() const {
    Real speed = static_cast<Real>(origin.level->wind) / 1000;
    for (const Effect& effect : powers.effects) {
        if (effect.power == Power::Wind) {
            speed += static_cast<Real>(effect.side) * kWindSpeed;
        }
    }
    return speed;
}

std::optional<BodyId> GameState::livingBoss() const {
    const bool lives = std::any_of(blocks.begin(), blocks.end(), [](const Block& block) {
        return block.support == Support::Boss;
    });
    return lives ? std::optional(boss.body) : std::nullopt;
}

Stuff GameState::stuffOf(BodyId body, std::size_t part) const {
    if (const Block* block = findBlock(body, part)) {
        return block->kind.stuff;
    }
    const auto shard = std::find_if(shards.begin(), shards.end(),
                                    [&](const Shard& piece) { return piece.body == body; });
    return shard == shards.end() ? Stuff::Steel : shard->stuff;
}

} // namespace apart
