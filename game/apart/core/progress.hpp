// SPDX-License-Identifier: MIT
#pragma once

#include <kodo/kodo.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace apart {

/// How long nothing has been damaged, in stages. From Glowing on, a pull tears blocks off.
enum class Patience : std::uint8_t {
    Calm,
    Glowing, // what is worth hitting is shown, and the meter of the field fills faster
    Shaking, // the mounts that will give way can be seen to shake
    Failing, // one block after the other is let go, the lowest first
};
inline constexpr std::array<std::string_view, 4> kPatienceNames = {"calm", "glowing", "shaking",
                                                                   "failing"};

/// Bounds the time that a player can wait for something to happen, without a hand on the ball: it
/// counts the ticks in which no block was damaged, and after kFailTicks of them blocks fall by
/// themselves, one each kFailEvery ticks. So a level takes at most
///
///   ticks of progress + kFailTicks + kFailEvery x blocks + the time that the last one falls.
///
/// For the last blocks, which nobody likes to wait for, it goes kLastHurry times as fast.
///
/// A ball that meets the paddle in the same way again and again is in a loop, and the clock need
/// not wait to know it.
class ProgressClock {
public:
    Patience patience() const;
    std::uint32_t idleTicks() const { return idle_; } // by this clock

    /// One tick in which a ball was in play. True when a block should be let go.
    bool tick(std::uint32_t hurry = 1);
    /// A block was damaged.
    void progress();
    /// A ball met the paddle: at this place, along this heading (unit), with the paddle at this x.
    /// True when it has done so kLoopTimes since the last progress; the clock is moved on then.
    bool metPaddle(kodo::Vec2 place, kodo::Vec2 heading, kodo::Real paddleX);

    std::uint64_t stateHash() const;

private:
    static constexpr std::size_t kRemembered = 32;

    std::uint32_t idle_ = 0;
    std::array<std::uint32_t, kRemembered> meetings_{}; // how the last ones were; a ring
    std::uint32_t met_ = 0;                             // since the last progress
};

} // namespace apart
