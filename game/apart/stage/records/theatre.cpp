// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/records/theatre.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace apart {

namespace {

// The bar, below the paddle (m).
constexpr Real kLow = Real(-0.2);
constexpr Real kHigh = Real(-0.08);
constexpr Real kHalf = Real(11.5);

} // namespace

std::string clockText(std::uint32_t ticks) {
    const std::uint32_t seconds = ticks / kTicksPerSecond;
    return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

void Theatre::begin(Show show) {
    *this = {};
    show_ = std::move(show);
}

bool Theatre::next(std::string& problem) {
    if (!show_.next) {
        return false;
    }
    std::variant<Show, std::string> following = show_.next();
    if (auto* show = std::get_if<Show>(&following)) {
        show_ = std::move(*show);
        held_ = false;
        return true;
    }
    problem = std::get<std::string>(following);
    return false;
}

Theatre::Request Theatre::take(Command command, std::uint32_t tick) {
    const std::int64_t now = tick;
    switch (command) {
    case Command::Launch:
    case Command::Pause:
        paused_ = !paused_;
        return {};
    case Command::Up:
        speed_ = std::min(speed_ + 1, kFastest);
        return {};
    case Command::Down:
        speed_ = std::max(speed_ - 1, kSlowest);
        return {};
    case Command::Left:
        return {.tick = now - kSkip};
    case Command::Right:
        return {.tick = now + kSkip};
    case Command::Next:
        paused_ = true;
        return {.tick = now + 1};
    case Command::Restart:
        return {.tick = 0};
    case Command::Confirm:
        return {.takeOver = true};
    default:
        return {};
    }
}

double Theatre::pace() const {
    if (paused_) {
        return 0;
    }
    return speed_ < 0 ? 1.0 / (1 << -speed_) : 1 << speed_;
}

std::string Theatre::speedText() const {
    return speed_ < 0 ? fmt::format("1/{}", 1 << -speed_) : fmt::format("{}", 1 << speed_);
}

Aabb Theatre::barPlace() {
    return {{-kHalf - Real(0.2), kLow - Real(0.3)}, {kHalf + Real(0.2), kHigh + Real(0.15)}};
}

std::optional<std::int64_t> Theatre::drag(const Signals& signals) {
    held_ = held_ || (signals.clicked && barPlace().contains(signals.pointerNow));
    std::optional<std::int64_t> tick;
    if (held_ && (signals.clicked || signals.pointer)) {
        const Real share = (signals.pointerNow.x + kHalf) / (2 * kHalf);
        tick = static_cast<std::int64_t>(std::clamp(share, Real(0), Real(1)) *
                                         static_cast<Real>(show_.end));
    }
    held_ = held_ && signals.dragging;
    return tick;
}

std::string Theatre::timeText(std::uint32_t tick) const {
    return clockText(std::min(tick, show_.end)) + " of " + clockText(show_.end);
}

void paintTheatre(Canvas& canvas, const Theatre& theatre, std::uint32_t tick,
                  std::string_view back) {
    const std::uint32_t end = theatre.show().end;
    const Real share =
        end > 0 ? std::min(static_cast<Real>(tick) / static_cast<Real>(end), Real(1)) : Real(0);
    const Real place = -kHalf + 2 * kHalf * share;
    canvas.rectangle({{-kHalf, kLow}, {kHalf, kHigh}}, {255, 255, 255, 50}, {255, 255, 255, 50});
    canvas.rectangle({{-kHalf, kLow}, {place, kHigh}}, palette::kAccent, palette::kAccent);
    canvas.disc({place, (kLow + kHigh) / 2}, Real(0.18), palette::kText, palette::kAccent);
    canvas.text(fmt::format("space: pause   arrows: 5 s, speed   N: one tick   enter: take over   "
                            "click on the bar: go there   escape: {}",
                            back),
                {0, Real(0.2)},
                {Real(0.38), palette::kQuiet, Typeface::Plain, Align::Middle, 2 * kHalf});
}

} // namespace apart
