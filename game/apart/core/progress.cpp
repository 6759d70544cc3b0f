// SPDX-License-Identifier: MIT
#include <apart/core/generator.hpp>
#include <apart/core/progress.hpp>
#include <apart/core/tuning.hpp>
#include <kodo/state_hash.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

/// Index of the interval of this size that contains the value.
std::uint64_t cellOf(Real value, Real size) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / size)));
}

} // namespace

Patience ProgressClock::patience() const {
    if (idle_ < kGlowTicks) {
        return Patience::Calm;
    }
    if (idle_ < kShakeTicks) {
        return Patience::Glowing;
    }
    return idle_ < kFailTicks ? Patience::Shaking : Patience::Failing;
}

bool ProgressClock::tick(std::uint32_t hurry) {
    idle_ += hurry;
    return idle_ >= kFailTicks && (idle_ - kFailTicks) % kFailEvery < hurry;
}

void ProgressClock::progress() {
    idle_ = 0;
    met_ = 0;
}

bool ProgressClock::metPaddle(kodo::Vec2 place, kodo::Vec2 heading, Real paddleX) {
    const std::uint64_t where =
        mixKeys(cellOf(place.x, kLoopCell), cellOf(paddleX, kLoopCell), cellOf(place.y, kLoopCell));
    const std::uint64_t how =
        mixKeys(where, cellOf(heading.x, kLoopHeading), cellOf(heading.y, kLoopHeading));
    const auto meeting = static_cast<std::uint32_t>(how);
    const std::size_t known = std::min<std::size_t>(met_, kRemembered);
    const auto alike = std::count(meetings_.begin(),
                                  meetings_.begin() + static_cast<std::ptrdiff_t>(known), meeting);
    meetings_[met_ % kRemembered] = meeting;
    ++met_;
    if (alike + 1 < kLoopTimes || idle_ >= kShakeTicks) {
        return false;
    }
    idle_ = idle_ < kGlowTicks ? kGlowTicks : kShakeTicks; // to the next stage
    return true;
}

std::optional<Patience> ProgressClock::takeChange() {
    if (patience() == told_) {
        return std::nullopt;
    }
    told_ = patience();
    return told_;
}

std::uint64_t ProgressClock::stateHash() const {
    kodo::StateHash hash;
    hash.add(idle_);
    hash.add(met_);
    hash.add(static_cast<std::uint8_t>(told_));
    const std::size_t known = std::min<std::size_t>(met_, kRemembered);
    for (std::size_t i = 0; i < known; ++i) {
        hash.add(meetings_[i]);
    }
    return hash.value();
}

} // namespace apart
