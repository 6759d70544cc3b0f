// SPDX-License-Identifier: MIT
#include <apart/core/game.hpp>
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
}

void add(kodo::StateHash& hash, const Ball& ball) {
    add(hash, ball.body);
    add(hash, ball.heading);
    hash.add(static_cast<std::uint8_t>(ball.riding));
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
    for (const std::int32_t number : {collapse.blocks, collapse.points, collapse.largest}) {
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

std::uint64_t Game::stateHash() const {
    kodo::StateHash hash;
    hash.add(world_.stateHash());
    hash.add(seed_);
    hash.add(static_cast<std::uint8_t>(mode_));
    hash.add(tick_);
    hash.add(static_cast<std::uint8_t>(result_));
    for (const std::int32_t number : {score_, lives_, combo_, blocksLeft_, blocksAtStart_}) {
        hash.add(number);
    }
    hash.add(serves_);
    add(hash, paddle_);
    for (const Real number : {paddleSpeed_, sway_.tilt, sway_.tiltSpeed, sway_.lift,
                              sway_.liftSpeed, meter_, bossHome_}) {
        hash.add(number);
    }
    hash.add(static_cast<std::uint8_t>(force_));
    add(hash, boss_);
    hash.add(bossWay_);
    add(hash, serveHeading_);
    add(hash, welds_);
    add(hash, blocks_);
    add(hash, balls_);
    add(hash, shards_);
    add(hash, parts_);
    add(hash, obstructions_);
    hash.add(static_cast<std::uint64_t>(links_.size()));
    add(hash, collapse_);
    add(hash, effects_);
    hash.add(clock_.stateHash());
    hash.add(static_cast<std::uint8_t>(shownPatience_));
    hash.add(tornSpeed_);
    add(hash, ledger_);
    return hash.value();
}

} // namespace apart
