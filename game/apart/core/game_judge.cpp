// SPDX-License-Identifier: MIT
// What the collisions of a tick mean to the game.
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::CollisionRecord;
using kodo::Real;
using kodo::Vec2;

namespace {

/// Of a record, towards the body.
Vec2 normalTowards(const CollisionRecord& hit, BodyId body) {
    return hit.b == body ? hit.normal : -hit.normal;
}

} // namespace

void Game::judge() {
    if (result_ != Result::Playing) {
        return;
    }
    for (const CollisionRecord& hit : world_.collisions()) {
        if (hit.maxImpulse <= 0) {
            continue;
        }
        for (const BodyId body : {hit.a, hit.b}) {
            // What an earlier record broke has no say any more.
            if (!world_.contains(hit.a) || !world_.contains(hit.b)) {
                break;
            }
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
            default:
                break;
            }
        }
        for (const BodyId body : {hit.a, hit.b}) {
            if (world_.contains(body) && roleOf(world_[body].flags()) == Role::Block) {
                judgeBlock(hit, body);
            }
        }
    }
    knockOffWorn(); // not before: the records name the parts by their place
}

void Game::judgeBall(const CollisionRecord& hit, BodyId ball) {
    const BodyId other = hit.other(ball);
    const Role what = roleOf(world_[other].flags());
    if (what == Role::Paddle) {
        combo_ = 0;
    }
    if (hit.maxImpulse < kSlightestBlow) {
        return;
    }
    events_.emplace_back(Struck{.ball = ball,
                                .other = other,
                                .what = what,
                                .stuff = stuffOf(other),
                                .point = hit.point,
                                .normal = normalTowards(hit, ball),
                                .impulse = hit.maxImpulse});
}

void Game::judgeBlock(const CollisionRecord& hit, BodyId body) {
    const auto found = std::find_if(blocks_.begin(), blocks_.end(),
                                    [&](const Block& block) { return block.body == body; });
    Block& block = *found;
    if (!block.kind.breakable() || hit.maxImpulse < kSlightestBlow) {
        return;
    }
    if (hit.maxImpulse > block.strengthLeft) {
        breakBlock(static_cast<std::size_t>(found - blocks_.begin()), hit.point,
                   hit.totalImpulse * normalTowards(hit, body));
        return;
    }
    block.strengthLeft -= hit.maxImpulse;
    const Real full = static_cast<Real>(block.kind.strength) / 1000;
    events_.emplace_back(Cracked{.block = body,
                                 .stuff = block.kind.stuff,
                                 .point = hit.point,
                                 .impulse = hit.maxImpulse,
                                 .strengthLeft = block.strengthLeft / full});
}

void Game::judgePart(const CollisionRecord& hit, BodyId body) {
    const auto found = std::find_if(parts_.begin(), parts_.end(),
                                    [&](const Part& part) { return part.body == body; });
    const BodyId other = hit.other(body);
    if (found->state == PartState::Launched) {
        const Block* block = findBlock(other);
        if (block != nullptr && !block->kind.breakable()) {
            events_.emplace_back(Spent{hit.point, true});
            world_.remove(body);
            parts_.erase(found);
        }
        return;
    }
    if (found->state != PartState::Loose || other != paddle_) {
        return;
    }
    if (found->power == Power::Weld && weldedParts() >= kMostWelded) {
        return;
    }
    score_ += kCatchPoints;
    events_.emplace_back(Caught{body, found->power, hit.point, hit.maxImpulse});
    if (found->power == Power::Weld) {
        world_.weld(paddle_, body);
        world_[paddle_].setMaterial(kPaddleMaterial); // what is welded bounces like the rest
        parts_.erase(found);
        welds_.push_back({.strengthLeft = kWeldStrength});
        events_.emplace_back(Welded{hit.point, world_[paddle_].mass(), weldedParts()});
        return;
    }
    kodo::BodyRef part = world_[body];
    part.setFlags(flagsOf(Role::Part) | kodo::kLocked);
    part.setMaterial(kPaddleMaterial);
    part.setAngularVelocity(0);
    found->state = PartState::Stuck;
    found->sinceTick = tick_;
    found->offset = part.position() - world_[paddle_].position();
    events_.emplace_back(Stuck{body, hit.point});
}

void Game::judgePaddle(const CollisionRecord& hit) {
    const std::size_t part = hit.a == paddle_ ? hit.partA : hit.partB;
    if (part == 0 || hit.maxImpulse < kSlightestBlow) {
        return;
    }
    Weld& weld = welds_[part - 1];
    weld.strengthLeft -= hit.maxImpulse;
    weld.lastPoint = hit.point;
    weld.lastImpulse = hit.maxImpulse;
}

void Game::knockOffWorn() {
    for (std::size_t i = welds_.size(); i-- > 0;) {
        if (welds_[i].strengthLeft < 0) {
            knockOff(i);
        }
    }
}

Stuff Game::stuffOf(BodyId body) const {
    if (const Block* block = findBlock(body)) {
        return block->kind.stuff;
    }
    const auto shard = std::find_if(shards_.begin(), shards_.end(),
                                    [&](const Shard& piece) { return piece.body == body; });
    return shard == shards_.end() ? Stuff::Steel : shard->stuff;
}

} // namespace apart
