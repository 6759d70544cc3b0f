// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/layout.hpp>
#include <apart/stage/palette.hpp>
#include <apart/stage/theatre.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace apart {

namespace {

std::string timeText(std::uint32_t ticks) {
    const std::uint32_t seconds = ticks / kTicksPerSecond;
    return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

} // namespace

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

void paintTheatre(Canvas& canvas, const Theatre& theatre, std::uint32_t tick,
                  const Bindings& keys) {
    const std::uint32_t end = theatre.show().end;
    constexpr Real kLow = Real(-0.2); // below the paddle
    constexpr Real kHigh = Real(-0.08);
    constexpr Real kHalf = Real(11.5); // m, half the length of the bar
    const Real share =
        end > 0 ? std::min(static_cast<Real>(tick) / static_cast<Real>(end), Real(1)) : Real(0);
    const Real place = -kHalf + 2 * kHalf * share;
    canvas.rectangle({{-kHalf, kLow}, {kHalf, kHigh}}, {255, 255, 255, 50}, {255, 255, 255, 50});
    canvas.rectangle({{-kHalf, kLow}, {place, kHigh}}, palette::kAccent, palette::kAccent);
    canvas.disc({place, (kLow + kHigh) / 2}, Real(0.18), palette::kText, palette::kAccent);
    const std::string state = fmt::format("{} of {}      {}", timeText(tick), timeText(end),
                                          theatre.paused() ? "paused" : theatre.speedText() + " x");
    canvas.text(state, {-kHalf, Real(0.2)}, {Real(0.42), palette::kText, Typeface::Bold});
    canvas.text(keys.prompt(Act::Serve) +
                    ": pause   left, right: 5 s   up, down: speed   N: one tick   enter: take over",
                {kHalf, Real(0.2)}, {Real(0.38), palette::kQuiet, Typeface::Plain, Align::Right});
}

} // namespace apart
