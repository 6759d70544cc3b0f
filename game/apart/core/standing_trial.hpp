// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace apart {

/// Plays a level without a player for a minute, in slices, to learn whether it stands.
class StandingTrial {
public:
    static constexpr std::uint32_t kTicks = 60 * kTicksPerSecond;
    static constexpr kodo::Real kStill = kodo::Real(0.05); // m; a block that moves less stands

    explicit StandingTrial(std::shared_ptr<const Level> level);

    /// Plays at most so many ticks.
    void advance(std::uint32_t ticks);
    bool done() const { return game_.ticks() >= kTicks || blocks_.empty(); }
    double share() const {
        return blocks_.empty() ? 1 : static_cast<double>(game_.ticks()) / kTicks;
    }

    /// A standing block that has moved farther than kStill, as it was at the start.
    struct Moved {
        Block block;
        std::uint32_t tick = 0;
        kodo::Real way = 0; // m
    };
    const std::optional<Moved>& first() const { return first_; }
    const std::optional<Moved>& farthest() const { return farthest_; }

private:
    Game game_;
    std::vector<Block> blocks_; // that stand, at the start
    std::optional<Moved> first_;
    std::optional<Moved> farthest_;
};

} // namespace apart
