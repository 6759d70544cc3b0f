// SPDX-License-Identifier: MIT
#include <apart/core/game_state.hpp>
#include <kodo/state_hash.hpp>

namespace apart {

using kodo::Real;

namespace {

void add(kodo::StateHash& hash, kodo::BodyId id) {
    hash.add(id.index);
    hash.add(id.generation);
}

void add(kodo::StateHash& hash, kodo::Vec2 v) {
    hash.add(v.x);
    hash.add(v.y);
}

void add(kodo::StateHash& hash, const Block& block) {
    add(hash, block.body);
    hash.add(block.strengthLeft);
    hash.add(static_cast<std::uint64_t>(block.part));
    hash.add(static_cast<std::uint8_t>(block.support));
    add(hash, block.pin);
    hash.add(block.looseTick);
    hash.add(block.due);
}

void add(kodo::StateHash& hash, const Ball& ball) {
    add(hash, ball.body);
    add(hash, ball.heading);
    hash.add(static_cast<std::uint8_t>(ball.riding));
    hash.add(static_cast<std::uint8_t>(ball.hollow));
    hash.add(static_cast<std::uint8_t>(ball.kind));
    hash.add(ball.carriedTicks);
}

void add(kodo::StateHash& hash, const Shard& shard) {
    add(hash, shard.body);
    hash.add(shard.bornTick);
    hash.add(shard.strengthLeft);
}

void add(kodo::StateHash& hash, const Part& part) {
    add(hash, part.body);
    hash.add(static_cast<std::uint8_t>(part.power));
    hash.add(static_cast<std::uint8_t>(part.state));
    hash.add(part.sinceTick);
    add(hash, part.offset);
    add(hash, part.origin);
}

void add(kodo::StateHash& hash, const Weld& weld) {
    hash.add(weld.strengthLeft);
    hash.add(static_cast<std::uint8_t>(weld.wing));
}

void add(kodo::StateHash& hash, const Obstruction& obstruction) {
    add(hash, obstruction.body);
    hash.add(obstruction.hitTick);
}

void add(kodo::StateHash& hash, const Collapse& collapse) {
    for (const std::int32_t number :
         {collapse.blocks, collapse.points, collapse.landed, collapse.largest}) {
        hash.add(number);
    }
    hash.add(collapse.lastTick);
    add(hash, collapse.sum);
}

void add(kodo::StateHash& hash, const Effect& effect) {
    hash.add(static_cast<std::uint8_t>(effect.power));
    hash.add(effect.untilTick);
    add(hash, effect.place);
    hash.add(effect.side);
}

void add(kodo::StateHash& hash, const Ledger& ledger) {
    for (const double booked :
         {ledger.servoWork, ledger.fieldWork, ledger.breakWork, ledger.kickWork,
          ledger.fieldImpulseX, ledger.fieldImpulseY, ledger.mountImpulseX, ledger.mountImpulseY,
          ledger.mountTurn, ledger.removedMass}) {
        hash.add(booked);
    }
    hash.add(ledger.bounces);
    hash.add(ledger.bentBounces);
    hash.add(ledger.thrownBounces);
}

template <typename T>
void add(kodo::StateHash& hash, const std::vector<T>& list) {
    for (const T& entry : list) {
        add(hash, entry);
    }
}

} // namespace

std::uint64_t GameState::hash() const {
    kodo::StateHash sum;
    sum.add(world.stateHash());
    sum.add(origin.seed);
    sum.add(static_cast<std::uint8_t>(origin.mode));
    sum.add(tick);
    sum.add(static_cast<std::uint8_t>(result));
    for (const std::int32_t number :
         {counts.score, counts.lives, counts.combo, counts.blocksLeft, counts.blocksAtStart,
          counts.hits, counts.leftAtHit, counts.bestBlow, counts.prizeUnit}) {
        sum.add(number);
    }
    sum.add(static_cast<std::uint8_t>(counts.blow));
    sum.add(counts.serves);
    sum.add(counts.downTick);
    sum.add(counts.hitTick);
    sum.add(static_cast<std::uint64_t>(buildings.carriers.size()));
    add(sum, paddle.body);
    for (const Real number :
         {paddle.speed, paddle.sway.tilt, paddle.sway.tiltSpeed, paddle.sway.lift,
          paddle.sway.liftSpeed, paddle.field.meter, boss.home}) {
        sum.add(number);
    }
    sum.add(static_cast<std::uint8_t>(paddle.field.force));
    add(sum, boss.body);
    sum.add(boss.way);
    add(sum, paddle.serveHeading);
    sum.add(paddle.servedFrom);
    sum.add(paddle.moved);
    add(sum, paddle.welds);
    add(sum, blocks);
    add(sum, balls);
    add(sum, shards);
    add(sum, parts);
    add(sum, obstructions);
    sum.add(static_cast<std::uint64_t>(buildings.links.size()));
    add(sum, buildings.collapse);
    for (const Water& water : waters) { // without water: the hash of older versions
        sum.add(water.region.upper.y);
        sum.add(static_cast<std::uint8_t>(water.open));
    }
    add(sum, powers.effects);
    sum.add(clock.stateHash());
    sum.add(paddle.field.tornSpeed);
    add(sum, ledger);
    return sum.value();
}

} // namespace apart
