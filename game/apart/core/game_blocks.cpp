// SPDX-License-Identifier: MIT
// Blocks that lose their support: parts of the boss, and failing mounts.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
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

kodo::Transform Game::frameOf(const Block& block) const {
    const kodo::BodyView body = world_[block.body];
    const kodo::Transform frame{body.position(), body.rotation()};
    return {frame * block.local, frame.rotation};
}

/// Gives the block its own body.
BodyId Game::detach(std::size_t index) {
    Block& block = blocks_[index];
    const BodyId whole = block.body;
    if (block.ownsBody() || world_[whole].partCount() == 1) {
        return whole;
    }
    const std::size_t place = block.part;
    block.body = world_.unweld(whole, place, flagsOf(Role::Block) | kFalls);
    block.part = 0;
    for (Block& other : blocks_) {
        if (other.body == whole && other.part > place) {
            --other.part;
        }
    }
    return block.body;
}

void Game::letGo(std::size_t index, LetGo::Why why) {
    if (blocks_[index].support == Support::Standing) {
        markFallen(index, why);
        return;
    }
    const BodyId body = detach(index);
    Block& block = blocks_[index];
    world_[body].setType(kodo::BodyType::Dynamic);
    world_[body].setFlags(flagsOf(Role::Block) | kFalls);
    world_[body].setMaterial(kLooseMaterial);
    if (world_.contains(block.pin)) {
        world_.remove(block.pin); // with its joint
    }
    block.pin = {};
    block.support = Support::Loose;
    block.looseTick = tick_;
    events_.emplace_back(LetGo{.block = body,
                               .key = block.key,
                               .stuff = block.kind.stuff,
                               .point = frameOf(block).position,
                               .why = why});
}

void Game::judgeBoss() {
    if (bossImpacts_.empty()) {
        return;
    }
    std::optional<Vec2> last; // centre of the block detached last
    for (const BossImpact& impact : bossImpacts_) {
        const auto found = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& block) {
            return block.key == impact.key && block.support == Support::Boss;
        });
        if (found == blocks_.end()) {
            continue; // already detached by another ball in this tick
        }
        const auto index = static_cast<std::size_t>(found - blocks_.begin());
        last = frameOf(*found).position;
        if (found->kind.core) {
            breakBlock(index, impact.point, impact.impulse);
            continue;
        }
        const Real strength = found->strengthLeft;
        letGo(index, LetGo::Why::BrokeOff);
        Block& block = blocks_[index];
        block.strengthLeft = kBossBreakOff * static_cast<Real>(block.kind.strength) / 1000;
        kodo::BodyRef body = world_[block.body];
        body.applyImpulse(impulseOnPieces(impact.impulse, strength, body.mass()), impact.point);
    }
    bossImpacts_.clear();
    if (last) {
        dropUnsupported(*last);
    }
}

/// Lets go boss blocks without connection to a core. `last`: centre of the block detached last.
void Game::dropUnsupported(Vec2 last) {
    std::vector<std::size_t> boss;
    std::vector<std::size_t> held; // cores, and blocks connected to one by cell sides
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        if (blocks_[i].support == Support::Boss) {
            (blocks_[i].kind.core ? held : boss).push_back(i);
        }
    }
    if (held.empty()) {
        events_.emplace_back(
            BossDown{boss.empty() ? last : frameOf(blocks_[boss.front()]).position});
    }
    for (std::size_t next = 0; next < held.size(); ++next) {
        for (std::size_t i = 0; i < boss.size();) {
            if (areNeighbours(blocks_[held[next]].key, blocks_[boss[i]].key)) {
                held.push_back(boss[i]);
                boss.erase(boss.begin() + static_cast<std::ptrdiff_t>(i));
            } else {
                ++i;
            }
        }
    }
    for (const std::size_t index : boss) {
        letGo(index, LetGo::Why::Unsupported);
    }
}

const Block* Game::nextToFall() const {
    const Block* lowest = nullptr;
    Real height = 0;
    for (const Block& block : blocks_) {
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

void Game::letGoNext(LetGo::Why why) {
    tornSpeed_ = 0; // it belongs to one block
    const Block* block = nextToFall();
    if (block == nullptr) {
        return;
    }
    const bool boss = block->support == Support::Boss;
    const Vec2 place = frameOf(*block).position;
    letGo(static_cast<std::size_t>(block - blocks_.data()), why);
    if (boss) {
        dropUnsupported(place);
    }
}

void Game::watchProgress() {
    const std::uint32_t hurry = blocksLeft_ <= kLastBlocks ? kLastHurry : 1;
    if (result_ == Result::Playing && !serving() && clock_.tick(hurry)) {
        letGoNext(LetGo::Why::Fatigue);
    } else if (tornSpeed_ >= kTornSpeed) {
        letGoNext(LetGo::Why::Torn);
        clock_.progress(); // counts as damage by the player
    }
    if (patience() == Patience::Calm) {
        tornSpeed_ = 0;
    }
    if (patience() != shownPatience_) {
        shownPatience_ = patience();
        events_.emplace_back(PatienceChanged{shownPatience_});
    }
}

Real Game::tornShare() const {
    return std::min(tornSpeed_ / kTornSpeed, Real(1));
}

Real Game::idleSeconds() const {
    return static_cast<Real>(clock_.idleTicks()) * kTickSeconds;
}

void Game::removeGoneBlocks() {
    for (std::size_t i = 0; i < blocks_.size();) {
        const Block block = blocks_[i];
        const bool fallen = block.support == Support::Fallen;
        if (!fallen && block.support != Support::Loose && block.support != Support::Moving) {
            ++i;
            continue;
        }
        const Vec2 place = frameOf(block).position;
        if (!isGone(place)) {
            const bool old = block.support != Support::Moving &&
                             tick_ - block.looseTick > (fallen ? kFallenTicks : kLooseTicks);
            if (old && result_ == Result::Playing) { // after the end nothing is scored
                breakBlock(i, place, {});
            } else {
                ++i;
            }
            continue;
        }
        ledger_.removedMass += static_cast<double>(world_[block.body].mass());
        world_.remove(block.body);
        blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(i));
        if (block.counts() && result_ == Result::Playing) {
            const std::int32_t points =
                kPoints[static_cast<std::size_t>(block.kind.stuff)] / kFallDivisor;
            --blocksLeft_;
            score_ += points;
            events_.emplace_back(Fell{block.kind.stuff, place, points});
        }
    }
}

} // namespace apart
