// SPDX-License-Identifier: MIT
#include <apart/core/game.hpp>
#include <kodo/base/hash.hpp>

namespace apart {

namespace {

void add(kodo::StateHash& hash, kodo::BodyId id) {
    hash.add(id.index);
    hash.add(id.generation);
}

void add(kodo::StateHash& hash, kodo::Vec2 v) {
    hash.add(v.x);
    hash.add(v.y);
}

} // namespace

std::uint64_t Game::stateHash() const {
    kodo::StateHash hash;
    hash.add(world_.stateHash());
    hash.add(seed_);
    hash.add(tick_);
    hash.add(static_cast<std::uint8_t>(result_));
    for (const std::int32_t number : {score_, lives_, combo_, blocksLeft_, blocksAtStart_}) {
        hash.add(number);
    }
    hash.add(serves_);
    add(hash, paddle_);
    hash.add(paddleSpeed_);
    for (const Weld& weld : welds_) {
        hash.add(weld.strengthLeft);
    }
    add(hash, serveHeading_);
    for (const Block& block : blocks_) {
        add(hash, block.body);
        hash.add(block.strengthLeft);
    }
    for (const Ball& ball : balls_) {
        add(hash, ball.body);
        add(hash, ball.heading);
        hash.add(static_cast<std::uint8_t>(ball.riding));
    }
    for (const Shard& shard : shards_) {
        add(hash, shard.body);
        hash.add(shard.bornTick);
    }
    for (const Part& part : parts_) {
        add(hash, part.body);
        hash.add(static_cast<std::uint8_t>(part.state));
        hash.add(part.sinceTick);
        add(hash, part.offset);
    }
    return hash.value();
}

} // namespace apart
