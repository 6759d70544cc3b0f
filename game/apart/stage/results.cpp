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

std::string countText(int count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// The score line by line: what was counted, and its points. The lines add up to the score.
void paintScoreLines(Canvas& canvas, const ResultsLook& look) {
    const RunStatistics& run = look.statistics;
    Real y = Real(10.75);
    const auto line = [&](std::string_view name, const std::string& count, std::int32_t points) {
        canvas.text(name, {Real(-2.6), y},
                    {Real(0.46), palette::kQuiet, Typeface::Plain, Align::Right});
        canvas.text(count, {Real(-2.2), y}, {Real(0.46), palette::kText, Typeface::Plain});
        canvas.text(grouped(points), {Real(5.6), y},
                    {Real(0.46), palette::kText, Typeface::Bold, Align::Right});
        y -= Real(0.56);
    };
    line("broken", countText(run.broken, "block") + fmt::format(", combo {}", run.bestCombo),
         run.points.broken);
    if (run.fallen > 0) {
        line("fallen",
             countText(run.fallen, "block") + fmt::format(", {} at a blow", run.largestFall),
             run.points.fallen);
    }
    if (run.dropped > 0) {
        line("dropped", countText(run.dropped, "block"), run.points.dropped);
    }
    if (run.caught > 0) {
        line("caught", countText(run.caught, "part"), run.points.caught);
    }
    if (look.game.result() == Result::Won) {
        line("left", countText(look.game.lives(), "ball"), run.points.lives);
    }
    if (look.score != run.points.sum()) {
        line("before", "earlier levels", look.score - run.points.sum());
    }
    const std::uint32_t seconds = run.ticks / kTicksPerSecond;
    canvas.text(fmt::format("{} of {} blocks in {}:{:02}", run.cleared, look.game.blocksAtStart(),
                            seconds / 60, seconds % 60),
                {0, y - Real(0.08)}, {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Middle});
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
                {Real(1.7), kColors[result], Typeface::Display, Align::Middle});
    canvas.text(game.level().title, {0, Real(14.2)},
                {Real(0.6), palette::kQuiet, Typeface::Plain, Align::Middle});
    const double share = std::clamp(look.seconds / kCountSeconds, 0.0, 1.0);
    const auto shown = static_cast<int>(share * look.score);
    canvas.text(grouped(shown), {0, Real(12.3)},
                {Real(1.6), palette::kText, Typeface::Display, Align::Middle});
    canvas.text(look.newBest ? "your best so far" : "points", {0, Real(11.6)},
                {Real(0.5), look.newBest ? palette::kAccent : palette::kQuiet, Typeface::Plain,
                 Align::Middle});
    paintScoreLines(canvas, look);
    Best best = look.statistics.bestOf(game);
    best.cleared = best.cleared || look.before.cleared;
    best.unhurt = best.unhurt || look.before.unhurt;
    best.chain = best.chain || look.before.chain;
    constexpr std::array<const char*, 3> kHonours = {"cleared", "no ball lost", "chain of 8"};
    const Vec2 step{Real(3.4), 0};
    paintHonours(canvas, Vec2{0, Real(6.95)} - step, step, Real(0.42), best);
    for (std::size_t i = 0; i < kHonours.size(); ++i) {
        const Vec2 place = Vec2{0, Real(6.1)} + (static_cast<Real>(i) - 1) * step;
        canvas.text(kHonours[i], place,
                    {Real(0.4), palette::kQuiet, Typeface::Plain, Align::Middle});
    }
}

} // namespace apart
