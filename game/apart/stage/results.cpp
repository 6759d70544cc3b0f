// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/hud.hpp>
#include <apart/stage/palette.hpp>
#include <apart/stage/results.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace apart {

namespace {

constexpr double kCountSeconds = 1.2; // duration of the score counter

void line(Canvas& canvas, Real y, std::string_view name, const std::string& value) {
    canvas.text(name, {Real(-0.3), y}, {Real(0.5), palette::kQuiet, Typeface::Plain, Align::Right});
    canvas.text(value, {Real(0.3), y}, {Real(0.5), palette::kText, Typeface::Bold});
}

std::string countText(int blocks) {
    return blocks == 0 ? "-" : fmt::format("{} block{}", blocks, blocks == 1 ? "" : "s");
}

/// A check mark.
void paintCleared(Canvas& canvas, Vec2 middle, Real size, Color color) {
    const Vec2 foot = middle + size * Vec2{Real(-0.25), Real(-0.6)};
    canvas.line(middle + size * Vec2{Real(-0.9), Real(0.1)}, foot, Real(0.35) * size, color);
    canvas.line(foot, middle + size * Vec2{Real(0.9), Real(0.75)}, Real(0.35) * size, color);
}

/// A ball.
void paintUnhurt(Canvas& canvas, Vec2 middle, Real size, Color color) {
    canvas.ring(middle, Real(0.75) * size, Real(0.28) * size, color);
    canvas.disc(middle, Real(0.3) * size, color, color);
}

/// Two chain links.
void paintChain(Canvas& canvas, Vec2 middle, Real size, Color color) {
    const Vec2 step = size * Vec2{Real(0.42), Real(0.25)};
    canvas.ring(middle - step, Real(0.5) * size, Real(0.26) * size, color);
    canvas.ring(middle + step, Real(0.5) * size, Real(0.26) * size, color);
}

} // namespace

void paintHonours(Canvas& canvas, Vec2 place, Vec2 step, Real size, Best best) {
    const auto colorOf = [](bool won) {
        return won ? palette::kAccent : faded(palette::kQuiet, 0.35f);
    };
    paintCleared(canvas, place, size, colorOf(best.cleared));
    paintUnhurt(canvas, place + step, size, colorOf(best.unhurt));
    paintChain(canvas, place + Real(2) * step, size, colorOf(best.chain));
}

void paintResults(Canvas& canvas, const ResultsLook& look) {
    const Game& game = look.game;
    constexpr std::array<const char*, 3> kTitles = {"The replay ends", "Level cleared",
                                                    "Game over"};
    constexpr std::array<Color, 3> kColors = {palette::kText, palette::kAccent, palette::kDanger};
    const auto result = static_cast<std::size_t>(game.result());
    canvas.text(kTitles[result], {0, Real(15.2)},
                {Real(1.8), kColors[result], Typeface::Bold, Align::Middle});
    canvas.text(game.level().title, {0, Real(14.2)},
                {Real(0.6), palette::kQuiet, Typeface::Plain, Align::Middle});
    const double share = std::clamp(look.seconds / kCountSeconds, 0.0, 1.0);
    const auto shown = static_cast<int>(share * look.score);
    canvas.text(grouped(shown), {0, Real(12.3)},
                {Real(1.6), palette::kText, Typeface::Bold, Align::Middle});
    canvas.text(look.newBest ? "your best so far" : "points", {0, Real(11.5)},
                {Real(0.5), look.newBest ? palette::kAccent : palette::kQuiet, Typeface::Plain,
                 Align::Middle});
    const std::uint32_t seconds = look.statistics.ticks / kTicksPerSecond;
    line(canvas, Real(10.6), "blocks cleared",
         fmt::format("{} of {}", look.statistics.cleared, game.blocksAtStart()));
    line(canvas, Real(9.95), "largest fall", countText(look.statistics.largestFall));
    line(canvas, Real(9.3), "best combo", fmt::format("{}", look.statistics.bestCombo));
    line(canvas, Real(8.65), "time", fmt::format("{}:{:02}", seconds / 60, seconds % 60));
    Best best = look.statistics.bestOf(game);
    best.cleared = best.cleared || look.before.cleared;
    best.unhurt = best.unhurt || look.before.unhurt;
    best.chain = best.chain || look.before.chain;
    constexpr std::array<const char*, 3> kHonours = {"cleared", "no ball lost", "chain of 8"};
    const Vec2 step{Real(3.4), 0};
    paintHonours(canvas, Vec2{0, Real(7.75)} - step, step, Real(0.42), best);
    for (std::size_t i = 0; i < kHonours.size(); ++i) {
        const Vec2 place = Vec2{0, Real(6.85)} + (static_cast<Real>(i) - 1) * step;
        canvas.text(kHonours[i], place,
                    {Real(0.4), palette::kQuiet, Typeface::Plain, Align::Middle});
    }
}

} // namespace apart
