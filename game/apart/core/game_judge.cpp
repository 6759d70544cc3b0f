// SPDX-License-Identifier: MIT
// Evaluation of the collisions of a tick.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::CollisionRecord;
using kodo::Real;
using kodo::Vec2;

namespace {

/// Normal of the record, towards the body.
Vec2 normalTowards(const CollisionRecord& hit, BodyId body) {
    return hit.b == body ? hit.normal : -hit.normal;
}

std::size_t partOf(const CollisionRecord& hit, BodyId body) {
    return hit.a == body ? hit.partA : hit.partB;
}

bool isSolid(const kodo::World& world, BodyId body) {
    const Role role = world.contains(body) ? roleOf(world[body].flags()) : Role::Wall;
    return role == Role::Block || role == Role::Shard || role == Role::Wall;
}

/// True for most records: a resting contact between blocks, shards and walls changes nothing.
bool isRest(const GameState& game, const CollisionRecord& hit) {
    return hit.maxImpulse < kSlightestImpact && isSolid(game.world, hit.a) &&
           isSolid(game.world, hit.b);
}

} // namespace

static void judgeAlive(GameState& game, const CollisionRecord& hit, BodyId body);
static void judgeBreakable(GameState& game, const CollisionRecord& hit, BodyId body);
static void judgeBall(GameState& game, const CollisionRecord& hit, BodyId ball);
static void judgeBlock(GameState& game, const CollisionRecord& hit, BodyId body);
static void judgeShard(GameState& game, const CollisionRecord& hit, BodyId body);
static void judgePart(GameState& game, const CollisionRecord& hit, BodyId body);
static void judgePaddle(GameState& game, const CollisionRecord& hit);
static void judgeObstruction(GameState& game, const CollisionRecord& hit, BodyId body);
static void catchPart(GameState& game, std::size_t index, const CollisionRecord& hit);
static void catchShard(GameState& game, std::size_t index, Vec2 point);
static void catchBlock(GameState& game, std::size_t index, Vec2 point);
static void addToMeter(GameState& game, Stuff stuff, Real mass, Vec2 point);
static void knockOffWorn(GameState& game);
static void knockOff(GameState& game, std::size_t weld);

void judge(GameState& game) {
    if (game.result != Result::Playing) {
        return;
    }
    for (const CollisionRecord& hit : game.world.collisions()) {
        if (hit.maxImpulse <= 0 || isRest(game, hit)) {
            continue;
        }
        for (const BodyId body : {hit.a, hit.b}) {
            // An earlier record may have removed a body.
            if (!game.world.contains(hit.a) || !game.world.contains(hit.b)) {
                break;
            }
            judgeAlive(game, hit, body);
        }
        for (const BodyId body : {hit.a, hit.b}) {
            if (game.world.contains(body)) {
                judgeBreakable(game, hit, body);
            }
        }
    }
    // After all records, because these refer to parts of bodies by index.
    judgeBoss(game);
    knockOffWorn(game);
    refreshPowers(game);
}

void judgeAlive(GameState& game, const CollisionRecord& hit, BodyId body) {
    switch (roleOf(game.world[body].flags())) {
    case Role::Ball:
        judgeBall(game, hit, body);
        break;
    case Role::Part:
        judgePart(game, hit, body);
        break;
    case Role::Paddle:
        judgePaddle(game, hit);
        break;
    case Role::Obstruction:
        judgeObstruction(game, hit, body);
        break;
    default:
        break;
    }
}

void judgeBreakable(GameState& game, const CollisionRecord& hit, BodyId body) {
    switch (roleOf(game.world[body].flags())) {
    case Role::Block:
        judgeBlock(game, hit, body);
        break;
    case Role::Shard:
        judgeShard(game, hit, body);
        break;
    default:
        break;
    }
}

void judgeBall(GameState& game, const CollisionRecord& hit, BodyId ball) {
    const BodyId other = hit.other(ball);
    const Role what = roleOf(game.world[other].flags());
    const auto met = std::find_if(game.balls.begin(), game.balls.end(),
                                  [&](const Ball& b) { return b.body == ball; });
    const Real slightest = (met->hollow ? kHollowShare : Real(1)) * kSlightestImpact;
    if (what == Role::Paddle) {
        game.counts.combo = 0;
        const bool begins = hit.phase == kodo::TouchPhase::Begin;
        if (begins && game.clock.metPaddle(game.world[ball].position(), met->heading,
                                           game.world[game.paddle.body].position().x)) {
            game.events.emplace_back(LoopSeen{ball});
        }
        if (met->hollow && game.paddle.moved > kMovedWay) {
            met->hollow = false;
            game.counts.blow = true; // even if a touch of the hollow ball was the hit
            game.world[ball].setMassFromDensity();
        }
    }
    if (hit.maxImpulse < slightest) {
        return;
    }
    if (what == Role::Paddle) {
        game.counts.hit(game.tick, game.beginsBlow(*met));
    }
    const Block* block = game.findBlock(other, partOf(hit, other));
    game.events.emplace_back(Struck{.ball = ball,
                                    .other = other,
                                    .what = what,
                                    .stuff = game.stuffOf(other, partOf(hit, other)),
                                    .letter = block != nullptr ? block->kind.letter : char{0},
                                    .point = hit.point,
                                    .normal = normalTowards(hit, ball),
                                    .impulse = hit.maxImpulse});
}

void judgeBlock(GameState& game, const CollisionRecord& hit, BodyId body) {
    const bool drawnIn =
        game.paddle.field.force == Force::Pull && hit.other(body) == game.paddle.body;
    if (!drawnIn && hit.maxImpulse < kSlightestImpact) {
        return; // most records: resting contacts
    }
    const auto index =
        static_cast<std::size_t>(game.findBlock(body, partOf(hit, body)) - game.blocks.data());
    Block& block = game.blocks[index];
    if (drawnIn && block.support == Support::Fallen) {
        catchBlock(game, index, hit.point);
        return;
    }
    if (block.support == Support::Fallen && hit.approachSpeed > kLandingSpeed &&
        normalTowards(hit, body).y > Real(0.5)) {
        land(game, block, &hit);
    }
    // A resting load is not an impact: its approach speed is small.
    const BodyId other = hit.other(body);
    const bool byBall =
        game.world.contains(other) && roleOf(game.world[other].flags()) == Role::Ball;
    const bool pressed = !byBall && hit.approachSpeed < kHarmlessSpeed;
    if (!block.kind.breakable() || hit.maxImpulse < kSlightestImpact || pressed) {
        return;
    }
    const bool hollow =
        byBall && std::any_of(game.balls.begin(), game.balls.end(),
                              [&](const Ball& ball) { return ball.body == other && ball.hollow; });
    if (block.counts() && !hollow) { // a hollow ball clears nothing
        game.clock.progress();
    }
    const Real damage = hollow ? std::min(hit.maxImpulse, block.strengthLeft / 2) : hit.maxImpulse;
    if (damage > block.strengthLeft) {
        const Vec2 impact = hit.totalImpulse * normalTowards(hit, body);
        if (block.support == Support::Boss) {
            game.boss.impacts.push_back({block.key, hit.point, impact});
        } else {
            breakBlock(game, index, hit.point, impact);
        }
        return;
    }
    block.strengthLeft -= damage;
    const Real full = static_cast<Real>(block.kind.strength) / 1000;
    game.events.emplace_back(Cracked{.block = body,
                                     .key = block.key,
                                     .stuff = block.kind.stuff,
                                     .point = hit.point,
                                     .impulse = hit.maxImpulse,
                                     .strengthLeft = block.strengthLeft / full});
}

void judgeShard(GameState& game, const CollisionRecord& hit, BodyId body) {
    const bool drawnIn =
        game.paddle.field.force == Force::Pull && hit.other(body) == game.paddle.body;
    if (!drawnIn && hit.maxImpulse < kSlightestImpact) {
        return; // most records: resting contacts of shards
    }
    const auto found = std::find_if(game.shards.begin(), game.shards.end(),
                                    [&](const Shard& shard) { return shard.body == body; });
    const auto index = static_cast<std::size_t>(found - game.shards.begin());
    if (drawnIn) {
        catchShard(game, index, hit.point);
        return;
    }
    if (found->stuff == Stuff::Steel) {
        return;
    }
    found->strengthLeft -= hit.maxImpulse;
    if (found->strengthLeft < 0) {
        breakShard(game, index, hit.point, hit.maxImpulse);
    }
}

void catchShard(GameState& game, std::size_t index, Vec2 point) {
    const Shard shard = game.shards[index];
    const Real mass = game.world[shard.body].mass();
    game.world.remove(shard.body);
    game.shards.erase(game.shards.begin() + static_cast<std::ptrdiff_t>(index));
    addToMeter(game, shard.stuff, mass, point);
}

void catchBlock(GameState& game, std::size_t index, Vec2 point) {
    land(game, game.blocks[index]);
    const Block block = game.blocks[index];
    const Real mass = game.world[block.body].mass();
    game.world.remove(block.body);
    game.blocks.erase(game.blocks.begin() + static_cast<std::ptrdiff_t>(index));
    addToMeter(game, block.kind.stuff, mass, point);
}

void addToMeter(GameState& game, Stuff stuff, Real mass, Vec2 point) {
    game.ledger.removedMass += static_cast<double>(mass);
    game.paddle.field.meter = std::min(game.paddle.field.meter + kMeterPerKilogram * mass, Real(1));
    game.events.emplace_back(ShardCaught{stuff, point, game.paddle.field.meter});
}

void judgePart(GameState& game, const CollisionRecord& hit, BodyId body) {
    const auto found = std::find_if(game.parts.begin(), game.parts.end(),
                                    [&](const Part& part) { return part.body == body; });
    const BodyId other = hit.other(body);
    if (found->state == PartState::Launched) {
        const Block* block = game.findBlock(other, partOf(hit, other));
        if (block != nullptr && !block->kind.breakable()) {
            game.events.emplace_back(Spent{hit.point, true});
            game.ledger.removedMass += static_cast<double>(game.world[body].mass());
            game.world.remove(body);
            game.parts.erase(found);
        }
        return;
    }
    if (found->state == PartState::Loose && other == game.paddle.body) {
        catchPart(game, static_cast<std::size_t>(found - game.parts.begin()), hit);
    }
}

void catchPart(GameState& game, std::size_t index, const CollisionRecord& hit) {
    Part& part = game.parts[index];
    const BodyId body = part.body;
    const Power power = part.power;
    if (power == Power::Weld && game.weldedParts() >= kMostWelded) {
        return; // the part bounces off
    }
    if (power == Power::Wings && !weldWings(game)) {
        return;
    }
    game.counts.score += game.counts.hits > 0 ? kCatchPoints : 0;
    game.events.emplace_back(Caught{body, power, hit.point, hit.maxImpulse});
    if (power == Power::Launch) {
        kodo::BodyRef stuck = game.world[body];
        stuck.setType(kodo::BodyType::Kinematic);
        stuck.setFlags(flagsOf(Role::Part));
        stuck.setMaterial(kPaddleMaterial);
        stuck.setAngularVelocity(0);
        part.state = PartState::Stuck;
        part.sinceTick = game.tick;
        const kodo::BodyView paddle = game.world[game.paddle.body];
        part.offset = unrotate(paddle.rotation(), stuck.position() - paddle.position());
        game.events.emplace_back(Stuck{body, hit.point});
        return;
    }
    const Vec2 origin = part.origin;
    game.parts.erase(game.parts.begin() + static_cast<std::ptrdiff_t>(index));
    if (power == Power::Weld) {
        game.world.weld(game.paddle.body, body);
        game.world[game.paddle.body].setMaterial(kPaddleMaterial); // for all parts
        game.paddle.welds.push_back({.strengthLeft = kWeldStrength});
    } else {
        game.ledger.removedMass += static_cast<double>(game.world[body].mass());
        game.world.remove(body);
    }
    if (power == Power::Weld || power == Power::Wings) {
        game.events.emplace_back(
            Welded{hit.point, game.world[game.paddle.body].mass(), game.weldedParts()});
    } else {
        beginPower(game, power, hit.point, origin);
    }
}

void judgePaddle(GameState& game, const CollisionRecord& hit) {
    const kodo::BodyView paddle = game.world[game.paddle.body];
    game.paddle.sway = pushed(game.paddle.sway, game.paddleKind(),
                              {paddle.mass(), {}, paddle.inertia()}, hit.point - paddle.center(),
                              hit.totalImpulse * normalTowards(hit, game.paddle.body));
    const std::size_t part = partOf(hit, game.paddle.body);
    if (part == 0 || hit.maxImpulse < kSlightestImpact) {
        return;
    }
    Weld& weld = game.paddle.welds[part - 1];
    weld.strengthLeft =
        hit.maxImpulse < kKnockOffImpact ? weld.strengthLeft - hit.maxImpulse : Real(-1);
    weld.lastPoint = hit.point;
    weld.lastImpulse = hit.maxImpulse;
}

void judgeObstruction(GameState& game, const CollisionRecord& hit, BodyId body) {
    const auto found = std::find_if(game.obstructions.begin(), game.obstructions.end(),
                                    [&](const Obstruction& o) { return o.body == body; });
    if (found == game.obstructions.end() || found->kind != ObstructionKind::Bumper) {
        return; // the pin of a hanging block, or a passive obstruction
    }
    kodo::BodyRef other = game.world[hit.other(body)];
    const bool impact = hit.phase == kodo::TouchPhase::Begin || hit.maxImpulse >= kSlightestImpact;
    if (!impact || other.type() != kodo::BodyType::Dynamic) {
        return;
    }
    const Vec2 normal = normalTowards(hit, other.id());
    drive(other, other.velocity() + found->kick * normal, game.ledger.kickWork);
    found->hitTick = game.tick;
    game.events.emplace_back(Bumped{other.id(), body, hit.point, normal});
}

void knockOffWorn(GameState& game) {
    for (std::size_t i = game.paddle.welds.size(); i-- > 0;) {
        if (game.paddle.welds[i].strengthLeft < 0) {
            knockOff(game, i);
        }
    }
}

void knockOff(GameState& game, std::size_t weld) {
    const BodyId body =
        game.world.unweld(game.paddle.body, weld + 1, flagsOf(Role::Shard) | kFalls);
    kodo::BodyRef part = game.world[body];
    const Vec2 away = normalize(part.center() - game.world[game.paddle.body].position());
    part.setMaterial(kShardMaterial);
    drive(part, part.velocity() + kKnockOffSpeed * away, game.ledger.kickWork);
    const Weld worn = game.paddle.welds[weld];
    game.paddle.welds.erase(game.paddle.welds.begin() + static_cast<std::ptrdiff_t>(weld));
    game.shards.push_back({body, Stuff::Steel, game.tick, 0});
    game.events.emplace_back(
        KnockedOff{body, worn.lastPoint, worn.lastImpulse, game.weldedParts()});
}

} // namespace apart
