// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/play/session.hpp>

#include <algorithm>
#include <utility>

namespace apart {

namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;
constexpr double kLongestFrame = 0.1;              // s; longer frames lose the excess
constexpr int kEndTicks = kTicksPerSecond * 5 / 4; // from the end to the result screen
constexpr std::size_t kMostMarks = 96;             // of a show; then each second one is dropped
constexpr std::uint32_t kShowMark = 600;           // ticks; 5 s, doubled with each dropping
constexpr std::uint32_t kOwnMark = 60;             // ticks; how long before a collapse, at least
constexpr std::uint32_t kWorthKeeping = 240;       // ticks; shorter games are not kept
constexpr std::int32_t kWorthRerun = 5;            // blocks of the collapse that ends a game

/// The record of a game so far, with its result and score as expectations at its end.
Replay recordOf(const Recorder& recorder, const Game& game) {
    Replay replay = recorder.finish(game);
    for (const auto& [field, value] :
         {std::pair{Field::Result, static_cast<std::int64_t>(game.result())},
          std::pair{Field::Score, static_cast<std::int64_t>(game.score())}}) {
        replay.expectations.push_back({game.ticks(), field, Comparison::Equal, value});
    }
    return replay;
}

} // namespace

void Session::begin(std::unique_ptr<Play> play, Kind kind) {
    kind_ = kind;
    play_ = std::move(play);
    recorder_.reset();
    record_.reset();
    recorded_.clear();
    divergedAt_.reset();
    if (kind != Kind::Demo) {
        recorder_.emplace(play_->game());
    }
    statistics_ = {};
    fanfare_.stop();
    beforeFall_.reset();
    marks_.clear();
    markEvery_ = kind == Kind::Show ? kShowMark : kOwnMark;
    owed_ = 0;
    endTicks_ = 0;
    standsStill_ = false;
    kept_ = counted_ = false;
    ghost_.reset();
    mark();
}

void Session::elapse(double seconds, double pace, const Settings& settings) {
    play_->setPace(pace);
    camera_.advance(game(), seconds, kind_ == Kind::Demo ? 0 : apart::share(settings.zoom));
    pace *= timeScale_.next(game(), seconds) * settings.speed / 100;
    owed_ += pace * std::min(seconds, kLongestFrame);
}

bool Session::takeTick() {
    if (owed_ < kTick) {
        return false;
    }
    owed_ -= kTick;
    return true;
}

void Session::mark() {
    if (kind_ == Kind::Demo) {
        return;
    }
    if (kind_ != Kind::Show && marks_.size() >= 2) {
        marks_.erase(marks_.begin());
    }
    marks_.push_back({*play_, statistics_, recorder_});
    if (marks_.size() > kMostMarks) {
        for (std::size_t i = 1; i < marks_.size(); ++i) {
            marks_.erase(marks_.begin() + static_cast<std::ptrdiff_t>(i));
        }
        markEvery_ *= 2;
    }
}

void Session::tick(const std::optional<Input>& input, const Settings& settings, Speaker& speaker) {
    const bool wasPlaying = game().result() == Result::Playing;
    standsStill_ = !input && kind_ == Kind::Show && wasPlaying;
    if (standsStill_) {
        ++endTicks_;
        return;
    }
    const std::int32_t fallen = game().collapse().blocks;
    play_->tick(input.value_or(Input{}), speaker);
    if (ghost_) {
        ghost_->tick();
    }
    if (recorder_ && wasPlaying) {
        recorder_->record(input.value_or(Input{}), game());
        if (game().result() != Result::Playing) {
            record_ = recordOf(*recorder_, game());
        }
    }
    compare();
    timeScale_.tick(game(), settings);
    statistics_.update(game());
    if (fallen == 0 && game().collapse().blocks > 0 && kind_ == Kind::Own) {
        beforeFall_ = marks_.front().play;
    }
    if (!marks_.empty() && wasPlaying && game().ticks() % markEvery_ == 0 &&
        game().ticks() > marks_.back().play.game().ticks()) {
        mark();
    }
    if (!fanfare_.done()) {
        play_->celebrate(fanfare_, speaker);
    }
    if (wasPlaying && game().result() == Result::Won) {
        fanfare_.begin();
    }
    endTicks_ += !input || game().result() != Result::Playing ? 1 : 0;
}

void Session::compare() {
    if (kind_ != Kind::Show || divergedAt_) {
        return;
    }
    const std::uint32_t now = game().ticks();
    const auto mark = std::lower_bound(
        recorded_.begin(), recorded_.end(), now,
        [](const HashMark& known, std::uint32_t tick) { return known.tick < tick; });
    if (mark != recorded_.end() && mark->tick == now && mark->hash != game().stateHash()) {
        divergedAt_ = now;
    }
}

void Session::seek(std::int64_t tick, const Pilot& pilot, const Settings& settings) {
    const auto later = std::upper_bound(
        marks_.begin() + 1, marks_.end(), tick,
        [](std::int64_t wanted, const Mark& known) { return wanted < known.play.game().ticks(); });
    const Mark& from = *std::prev(later);
    const std::int64_t now = game().ticks();
    if (tick < now || from.play.game().ticks() > now) {
        *play_ = from.play;
        statistics_ = from.statistics;
        recorder_ = from.recorder;
        record_.reset();
        fanfare_.stop();
    }
    SilentSpeaker silence;
    while (game().ticks() < tick) {
        const std::optional<Input> input = pilot(game());
        if (!input) {
            break;
        }
        this->tick(input, settings, silence);
    }
    endTicks_ = 0;
    standsStill_ = false;
    owed_ = 0;
}

void Session::takeOver() {
    kind_ = Kind::WhatIf;
    endTicks_ = 0;
    standsStill_ = false;
    takenOverAt_ = game().ticks();
    marks_.erase(marks_.begin(), marks_.end() - 1);
    markEvery_ = kOwnMark;
}

std::optional<Replay> Session::record() const {
    if (record_ || !recorder_) {
        return record_;
    }
    return recordOf(*recorder_, game());
}

std::optional<Rerun> Session::rerun() const {
    const std::uint32_t down =
        game().counts().isDown() ? game().counts().downTick : statistics_.ticks;
    const bool ends = statistics_.lastFall >= kWorthRerun && game().result() == Result::Won &&
                      down <= statistics_.lastFallTick + kTicksPerSecond;
    if (!ends || !beforeFall_ || !record_) {
        return std::nullopt;
    }
    return Rerun(*beforeFall_, *record_);
}

bool Session::takeUnkept() {
    const bool own = kind_ == Kind::Own || kind_ == Kind::WhatIf;
    const bool fresh = own && !kept_ && game().ticks() > kWorthKeeping;
    kept_ = kept_ || fresh;
    return fresh;
}

bool Session::takeUncounted() {
    const bool fresh = kind_ == Kind::Own && !counted_ &&
                       (game().result() != Result::Playing || game().ticks() > kWorthKeeping);
    counted_ = counted_ || fresh;
    return fresh;
}

bool Session::overdue() const {
    return endTicks_ >= (game().result() == Result::Won ? Fanfare::kTicks : kEndTicks);
}

Real Session::share() const {
    if (standsStill_) {
        return 1;
    }
    return static_cast<Real>(std::min(owed_ * kTicksPerSecond, 1.0));
}

} // namespace apart
