// SPDX-License-Identifier: MIT
// Evaluation of the collisions of a tick.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
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

} // namespace

void Game::judge() {
    if (result_ != Result::Playing) {
        return;
    }
    for (const CollisionRecord& hit : world_.collisions()) {
        if (hit.maxPointImpulse() <= 0) {
            continue;
        }
        for (const BodyId body : {hit.a, hit.b}) {
            // An earlier record may have removed a body.
            if (!world_.contains(hit.a) || !world_.contains(hit.b)) {
                break;
            }
            judgeAlive(hit, body);
        }
        for (const BodyId body : {hit.a, hit.b}) {
            if (world_.contains(body)) {
                judgeBreakable(hit, body);
            }
        }
    }
    // After all records, because these refer to parts of bodies by index.
    judgeBoss();
    knockOffWorn();
    refreshPowers();
}

void Game::judgeAlive(const CollisionRecord& hit, BodyId body) {
    switch (roleOf(world_[body].flags())) {
    case Role::Ball:
        judgeBall(hit, body);
        break;
    case Role::Part:
        judgePart(hit, body);
        break;
    case Role::Paddle:
        judgePaddle(hit);
        break;
    case Role::Obstruction:
        judgeObstruction(hit, body);
        break;
    default:
        break;
    }
}

void Game::judgeBreakable(const CollisionRecord& hit, BodyId body) {
    switch (roleOf(world_[body].flags())) {
    case Role::Block:
        judgeBlock(hit, body);
        break;
    case Role::Shard:
        judgeShard(hit, body);
        break;
    default:
        break;
    }
}

void Game::judgeBall(const CollisionRecord& hit, BodyId ball) {
    const BodyId other = hit.other(ball);
    const Role what = roleOf(world_[other].flags());
    if (what == Role::Paddle) {
        combo_ = 0;
        const auto met = std::find_if(balls_.begin(), balls_.end(),
                                      [&](const Ball& b) { return b.body == ball; });
        const bool begins = hit.phase == kodo::TouchPhase::Begin;
        if (begins &&
            clock_.metPaddle(world_[ball].position(), met->heading, world_[paddle_].position().x)) {
            events_.emplace_back(LoopSeen{ball});
        }
    }
    if (hit.maxPointImpulse() < kSlightestImpact) {
        return;
    }
    events_.emplace_back(Struck{.ball = ball,
                                .other = other,
                                .what = what,
                                .stuff = stuffOf(other, partOf(hit, other)),
                                .point = hit.point,
                                .normal = normalTowards(hit, ball),
                                .impulse = hit.maxPointImpulse()});
}

void Game::judgeBlock(const CollisionRecord& hit, BodyId body) {
    const bool drawnIn = force_ == Force::Pull && hit.other(body) == paddle_;
    if (!drawnIn && hit.maxPointImpulse() < kSlightestImpact) {
        return; // most records: resting contacts
    }
    const auto index =
        static_cast<std::size_t>(findBlock(body, partOf(hit, body)) - blocks_.data());
    Block& block = blocks_[index];
    if (drawnIn && block.support == Support::Fallen) {
        catchBlock(index, hit.point);
        return;
    }
    // A resting load on a block of a building is not an impact: its approach speed is small.
    const BodyId other = hit.other(body);
    const bool byBall = world_.contains(other) && roleOf(world_[other].flags()) == Role::Ball;
    const bool pressed =
        (world_[body].flags() & kStands) != 0 && !byBall && hit.approachSpeed < kHarmlessSpeed;
    if (!block.kind.breakable() || hit.maxPointImpulse() < kSlightestImpact || pressed) {
        return;
    }
    if (block.counts()) {
        clock_.progress();
    }
    if (hit.maxPointImpulse() > block.strengthLeft) {
        const Vec2 impact = hit.totalImpulse * normalTowards(hit, body);
        if (block.support == Support::Boss) {
            bossImpacts_.push_back({block.key, hit.point, impact});
        } else {
            breakBlock(index, hit.point, impact);
        }
        return;
    }
    block.strengthLeft -= hit.maxPointImpulse();
    const Real full = static_cast<Real>(block.kind.strength) / 1000;
    events_.emplace_back(Cracked{.block = body,
                                 .key = block.key,
                                 .stuff = block.kind.stuff,
                                 .point = hit.point,
                                 .impulse = hit.maxPointImpulse(),
                                 .strengthLeft = block.strengthLeft / full});
}

void Game::judgeShard(const CollisionRecord& hit, BodyId body) {
    const bool drawnIn = force_ == Force::Pull && hit.other(body) == paddle_;
    if (!drawnIn && hit.maxPointImpulse() < kSlightestImpact) {
        return; // most records: resting contacts of shards
    }
    const auto found = std::find_if(shards_.begin(), shards_.end(),
                                    [&](const Shard& shard) { return shard.body == body; });
    const auto index = static_cast<std::size_t>(found - shards_.begin());
    if (drawnIn) {
        catchShard(index, hit.point);
        return;
    }
    if (found->stuff == Stuff::Steel) {
        return;
    }
    found->strengthLeft -= hit.maxPointImpulse();
    if (found->strengthLeft < 0) {
        breakShard(index, hit.point, hit.maxPointImpulse());
    }
}

void Game::catchShard(std::size_t index, Vec2 point) {
    const Shard shard = shards_[index];
    const Real mass = world_[shard.body].mass();
    world_.remove(shard.body);
    shards_.erase(shards_.begin() + static_cast<std::ptrdiff_t>(index));
    addToMeter(shard.stuff, mass, point);
}

void Game::catchBlock(std::size_t index, Vec2 point) {
    const Block block = blocks_[index];
    const Real mass = world_[block.body].mass();
    world_.remove(block.body);
    blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(index));
    addToMeter(block.kind.stuff, mass, point);
}

void Game::addToMeter(Stuff stuff, Real mass, Vec2 point) {
    ledger_.removedMass += static_cast<double>(mass);
    meter_ = std::min(meter_ + kMeterPerKilogram * mass, Real(1));
    events_.emplace_back(ShardCaught{stuff, point, meter_});
}

void Game::judgePart(const CollisionRecord& hit, BodyId body) {
    const auto found = std::find_if(parts_.begin(), parts_.end(),
                                    [&](const Part& part) { return part.body == body; });
    const BodyId other = hit.other(body);
    if (found->state == PartState::Launched) {
        const Block* block = findBlock(other, partOf(hit, other));
        if (block != nullptr && !block->kind.breakable()) {
            events_.emplace_back(Spent{hit.point, true});
            ledger_.removedMass += static_cast<double>(world_[body].mass());
            world_.remove(body);
            parts_.erase(found);
        }
        return;
    }
    if (found->state == PartState::Loose && other == paddle_) {
        catchPart(static_cast<std::size_t>(found - parts_.begin()), hit);
    }
}

void Game::catchPart(std::size_t index, const CollisionRecord& hit) {
    Part& part = parts_[index];
    const BodyId body = part.body;
    const Power power = part.power;
    if (power == Power::Weld && weldedParts() >= kMostWelded) {
        return; // the part bounces off
    }
    if (power == Power::Wings && !weldWings()) {
        return;
    }
    score_ += kCatchPoints;
    events_.emplace_back(Caught{body, power, hit.point, hit.maxPointImpulse()});
    if (power == Power::Launch) {
        kodo::BodyRef stuck = world_[body];
        stuck.setType(kodo::BodyType::Kinematic);
        stuck.setFlags(flagsOf(Role::Part));
        stuck.setMaterial(kPaddleMaterial);
        stuck.setAngularVelocity(0);
        part.state = PartState::Stuck;
        part.sinceTick = tick_;
        const kodo::BodyView paddle = world_[paddle_];
        part.offset = unrotate(paddle.rotation(), stuck.position() - paddle.position());
        events_.emplace_back(Stuck{body, hit.point});
        return;
    }
    const Vec2 origin = part.origin;
    parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(index));
    if (power == Power::Weld) {
        world_.weld(paddle_, body);
        world_[paddle_].setMaterial(kPaddleMaterial); // for all parts
        welds_.push_back({.strengthLeft = kWeldStrength});
    } else {
        ledger_.removedMass += static_cast<double>(world_[body].mass());
        world_.remove(body);
    }
    if (power == Power::Weld || power == Power::Wings) {
        events_.emplace_back(Welded{hit.point, world_[paddle_].mass(), weldedParts()});
    } else {
        beginPower(power, hit.point, origin);
    }
}

void Game::judgePaddle(const CollisionRecord& hit) {
    const kodo::BodyView paddle = world_[paddle_];
    sway_ = pushed(sway_, paddleKind(), {paddle.mass(), {}, paddle.inertia()},
                   hit.point - paddle.center(), hit.totalImpulse * normalTowards(hit, paddle_));
    const std::size_t part = partOf(hit, paddle_);
    if (part == 0 || hit.maxPointImpulse() < kSlightestImpact) {
        return;
    }
    Weld& weld = welds_[part - 1];
    weld.strengthLeft = hit.maxPointImpulse() < kKnockOffImpact
                            ? weld.strengthLeft - hit.maxPointImpulse()
                            : Real(-1);
    weld.lastPoint = hit.point;
    weld.lastImpulse = hit.maxPointImpulse();
}

void Game::judgeObstruction(const CollisionRecord& hit, BodyId body) {
    const auto found = std::find_if(obstructions_.begin(), obstructions_.end(),
                                    [&](const Obstruction& o) { return o.body == body; });
    if (found == obstructions_.end() || found->kind != ObstructionKind::Bumper) {
        return; // the pin of a hanging block, or a passive obstruction
    }
    kodo::BodyRef other = world_[hit.other(body)];
    const bool impact =
        hit.phase == kodo::TouchPhase::Begin || hit.maxPointImpulse() >= kSlightestImpact;
    if (!impact || other.type() != kodo::BodyType::Dynamic) {
        return;
    }
    const Vec2 normal = normalTowards(hit, other.id());
    drive(other, other.velocity() + found->kick * normal, ledger_.kickWork);
    found->hitTick = tick_;
    events_.emplace_back(Bumped{other.id(), body, hit.point, normal});
}

void Game::knockOffWorn() {
    for (std::size_t i = welds_.size(); i-- > 0;) {
        if (welds_[i].strengthLeft < 0) {
            knockOff(i);
        }
    }
}

void Game::knockOff(std::size_t weld) {
    const BodyId body = world_.unweld(paddle_, weld + 1, flagsOf(Role::Shard) | kFalls);
    kodo::BodyRef part = world_[body];
    const Vec2 away = normalize(part.center() - world_[paddle_].position());
    part.setMaterial(kShardMaterial);
    drive(part, part.velocity() + kKnockOffSpeed * away, ledger_.kickWork);
    const Weld worn = welds_[weld];
    welds_.erase(welds_.begin() + static_cast<std::ptrdiff_t>(weld));
    shards_.push_back({body, Stuff::Steel, tick_, 0});
    events_.emplace_back(KnockedOff{body, worn.lastPoint, worn.lastImpulse, weldedParts()});
}

Stuff Game::stuffOf(BodyId body, std::size_t part) const {
    if (const Block* block = findBlock(body, part)) {
        return block->kind.stuff;
    }
    const auto shard = std::find_if(shards_.begin(), shards_.end(),
                                    [&](const Shard& piece) { return piece.body == body; });
    return shard == shards_.end() ? Stuff::Steel : shard->stuff;
}

} // namespace apart
