// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/rerun.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr double kRerunTick = 1.0 / kTicksPerSecond;
constexpr double kLongestRerun = 0.1;                 // s
constexpr std::uint32_t kAfter = 2 * kTicksPerSecond; // shown beyond the end of the game

} // namespace

Input inputAt(const Replay& replay, std::uint32_t tick) {
    const auto later = std::upper_bound(
        replay.inputs.begin(), replay.inputs.end(), tick,
        [](std::uint32_t t, const InputChange& change) { return t < change.tick; });
    return later == replay.inputs.begin() ? Input{} : std::prev(later)->input;
}

void Rerun::advance(double seconds) {
    SilentSpeaker silence;
    owed_ += kPace * std::min(seconds, kLongestRerun);
    for (; owed_ >= kRerunTick; owed_ -= kRerunTick) {
        const std::uint32_t tick = now_.game().ticks();
        if (tick >= record_.end + kAfter) {
            now_ = start_;
        } else {
            now_.tick(tick < record_.end ? inputAt(record_, tick) : Input{}, silence);
        }
    }
}

Real Rerun::share() const {
    return static_cast<Real>(std::min(owed_ * kTicksPerSecond, 1.0));
}

} // namespace apart
