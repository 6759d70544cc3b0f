// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/play/rerun.hpp>

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

double Rerun::seconds() const {
    return (record_.end + kAfter - start_.game().ticks()) * kRerunTick / kPace;
}

std::optional<Fall> largestFall(const Replay& replay, const std::shared_ptr<const Level>& level) {
    constexpr std::uint32_t kBefore = kTicksPerSecond / 2;
    SilentSpeaker silence;
    const auto playTo = [&](Play& play, std::uint32_t tick) {
        while (play.game().ticks() < tick) {
            play.tick(inputAt(replay, play.game().ticks()), silence);
        }
    };
    Play play(level, replay.seed, replay.mode, Settings{});
    const Play start = play;
    std::uint32_t began = 0; // tick of the current fall
    std::uint32_t from = 0;  // of the largest one
    std::uint32_t to = 0;
    std::int32_t most = 0;
    while (play.game().ticks() < replay.end) {
        const std::int32_t before = play.game().collapse().blocks;
        playTo(play, play.game().ticks() + 1);
        const Collapse& now = play.game().collapse();
        began = before == 0 ? play.game().ticks() : began;
        if (now.blocks > most) {
            most = now.blocks;
            from = began;
            to = now.lastTick;
        }
    }
    if (most == 0) {
        return std::nullopt;
    }
    Play first = start;
    playTo(first, from > kBefore ? from - kBefore : 0);
    Replay part = replay;
    part.end = to;
    return Fall{most, Rerun(first, std::move(part))};
}

Real Rerun::share() const {
    return static_cast<Real>(std::min(owed_ * kTicksPerSecond, 1.0));
}

} // namespace apart
