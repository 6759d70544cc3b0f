// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace apart {

/// Stages of the time without damage to a block. From Glowing on, a pull tears blocks off.
enum class Patience : std::uint8_t {
    Calm,
    Glowing, // targets are highlighted; the meter of the force field fills faster
    Shaking, // the next mounts to fail are shown shaking
    Failing, // blocks are let go one by one, the lowest first
};
inline constexpr std::array<std::string_view, 4> kPatienceNames = {"calm", "glowing", "shaking",
                                                                   "failing"};

/// Bounds the time without progress, and does not touch the balls. It counts the ticks in which no
/// block was damaged. After kFailTicks of them blocks fall, one each kFailEvery ticks. A level
/// therefore takes at most
///
///   ticks of progress + kFailTicks + kFailEvery x blocks + fall time of the last block.
///
/// For the last kLastBlocks blocks the clock runs kLastHurry times as fast.
///
/// A ball that hits the paddle repeatedly in the same way is in a loop. The clock is then advanced
/// at once.
class ProgressClock {
public:
    Patience patience() const;
    /// The stage, if it is another one than at the last call.
    std::optional<Patience> takeChange();
    std::uint32_t idleTicks() const { return idle_; } // of this clock, its faster rate included

    /// Counts a tick with a ball in play. True if a block must be let go.
    bool tick(std::uint32_t hurry = 1);
    /// A block was damaged.
    void progress();
    /// A ball hit the paddle: at `place` (m), along `heading` (unit), with the paddle at x (m).
    /// True, and the clock advances, at the kLoopTimes-th similar hit since the last progress.
    bool metPaddle(kodo::Vec2 place, kodo::Vec2 heading, kodo::Real paddleX);

    std::uint64_t stateHash() const;

private:
    static constexpr std::size_t kRemembered = 32;

    std::uint32_t idle_ = 0;
    Patience told_ = Patience::Calm;                    // by takeChange()
    std::array<std::uint32_t, kRemembered> meetings_{}; // keys of the last paddle hits; a ring
    std::uint32_t met_ = 0;                             // paddle hits since the last progress
};

} // namespace apart
