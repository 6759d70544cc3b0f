// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <kodo/kodo.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace apart {

/// Games that do not begin with a serve. No replay holds them.
struct Trial {
    /// The ball of the serve flies down from a place (m), above what is there, and is never hollow.
    /// The paddle is below it.
    static void dropBall(Game& game, kodo::Vec2 place);
    /// What a ball from below does to a block: one that can break breaks at `point` (m); another
    /// one gets the impulse of a ball that is reflected.
    static void strike(Game& game, std::uint32_t key, kodo::Vec2 point);
};

/// What comes down after a hit on one block, played in slices without a player.
class FallForecast {
public:
    /// `block`: index into Level::freeBlocks. `point`: m, of the hit.
    FallForecast(std::shared_ptr<const Level> level, std::size_t block, kodo::Vec2 point);

    void advance(std::uint32_t ticks);
    bool done() const;

    /// A block that has fallen, broken or left the field, with its last pose.
    struct Fallen {
        std::size_t block = 0; // index into Level::freeBlocks
        kodo::Transform pose;
    };
    const std::vector<Fallen>& fallen() const { return fallen_; }
    std::size_t struck() const { return block_; }

private:
    void look();

    Game game_;
    std::size_t block_;
    kodo::Vec2 point_;
    std::vector<kodo::Transform> poses_; // by index into Level::freeBlocks; the last ones
    std::vector<Fallen> fallen_;
};

/// How often serves clear each block: kServes games with serves of all directions, each played by a
/// bot for kSeconds at most, in slices. A game is over before what comes down by itself does so,
/// after a long wait or at the end of a building.
class ServeMap {
public:
    static constexpr std::uint32_t kServes = 200;
    static constexpr std::uint32_t kSeconds = 8;

    explicit ServeMap(std::shared_ptr<const Level> level);

    void advance(std::uint32_t ticks);
    bool done() const { return served_ == kServes; }
    std::uint32_t served() const { return served_; } // serves that are over
    double share() const { return static_cast<double>(served_) / kServes; }
    /// Share of the serves so far that cleared a block, 0..1, by index into Level::cells and then
    /// Level::freeBlocks.
    double clearedBy(std::size_t block) const;

private:
    void begin();
    void look();
    void finish();

    Game start_;
    Game game_;
    std::uint32_t served_ = 0;
    std::vector<std::uint32_t> keys_;    // of the blocks
    std::vector<std::uint32_t> cleared_; // by serves that are over
    std::vector<bool> gone_;             // in this game
};

} // namespace apart
