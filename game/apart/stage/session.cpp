// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/session.hpp>

#include <algorithm>
#include <utility>

namespace apart {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;
constexpr double kLongestFrame = 0.1;              // s; longer frames lose the excess
constexpr int kEndTicks = kTicksPerSecond * 5 / 4; // from the end to the result screen

} // namespace

void Session::begin(std::unique_ptr<Play> play, bool recorded) {
    play_ = std::move(play);
    recorder_.reset();
    record_.reset();
    if (recorded) {
        recorder_.emplace(play_->game());
    }
    statistics_ = {};
    fanfare_.stop();
    owed_ = 0;
    endTicks_ = 0;
}

void Session::elapse(double seconds, const Settings& settings) {
    const double pace = timeScale_.next(game(), seconds) * settings.speed / 100;
    owed_ += pace * std::min(seconds, kLongestFrame);
}

bool Session::takeTick() {
    if (owed_ < kTick) {
        return false;
    }
    owed_ -= kTick;
    return true;
}

void Session::tick(const std::optional<Input>& input, const Settings& settings, Speaker& speaker) {
    const bool wasPlaying = game().result() == Result::Playing;
    play_->tick(input.value_or(Input{}), speaker);
    if (recorder_ && wasPlaying) {
        recorder_->record(input.value_or(Input{}), game());
        if (game().result() != Result::Playing) {
            record_ = recorder_->finish(game());
        }
    }
    timeScale_.tick(game(), settings);
    statistics_.hear(game());
    if (!fanfare_.done()) {
        play_->celebrate(fanfare_, speaker);
    }
    if (wasPlaying && game().result() == Result::Won) {
        fanfare_.begin();
    }
    endTicks_ += !input || game().result() != Result::Playing ? 1 : 0;
}

std::optional<Replay> Session::record() const {
    if (record_ || !recorder_) {
        return record_;
    }
    return recorder_->finish(game());
}

bool Session::overdue() const {
    return endTicks_ >= (game().result() == Result::Won ? Fanfare::kTicks : kEndTicks);
}

Real Session::share() const {
    return static_cast<Real>(std::min(owed_ * kTicksPerSecond, 1.0));
}

} // namespace apart
