// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/results.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace apart {

namespace {

constexpr Real kHonoursRoom = Real(23.4); // m, of the row of honours
constexpr double kCountSeconds = 1.2;     // duration of the score counter

/// The score line by line: what was counted, and its points. The lines add up to the score.
void paintScoreLines(Canvas& canvas, const ResultsLook& look) {
    const RunStatistics& run = look.statistics;
    const Real pitch = Real(0.56) + Real(0.18) * (canvas.textScale() - 1); // m
    Real y = Real(10.8);
    const auto line = [&](std::string_view name, const std::string& count, std::int32_t points) {
        canvas.text(name, {Real(-4.4), y},
                    {Real(0.46), palette::kQuiet, Typeface::Plain, Align::Right, Real(4)});
        canvas.text(count, {Real(-4), y},
                    {Real(0.46), palette::kText, Typeface::Plain, Align::Left, Real(8)});
        canvas.text(grouped(points), {Real(7.6), y},
                    {Real(0.46), palette::kText, Typeface::Bold, Align::Right, Real(3.4)});
        y -= pitch;
    };
    line("broken", countText(run.broken, "block") + fmt::format(", combo {}", run.bestCombo),
         run.points.broken);
    if (run.fallen > 0) {
        line("fallen", countText(run.fallen, "block"), run.points.fallen);
    }
    if (run.caught > 0) {
        line("caught", countText(run.caught, "part"), run.points.caught);
    }
    if (look.game.result() == Result::Won) {
        line("left", countText(look.game.lives(), "ball"), run.points.lives);
        const std::int32_t blow = look.game.counts().bestBlow;
        line("prize",
             blow > 0 ? fmt::format("best blow: {}, {} left", countText(blow, "block"),
                                    look.game.blocksAtStart() - blow)
                      : "no block fell by a blow",
             run.points.prize);
    }
    if (run.points.spared > 0) {
        line("spared", "the " + look.game.level().keepName, run.points.spared);
    }
    if (look.score != run.points.sum()) {
        line("before", "earlier levels", look.score - run.points.sum());
    }
    const std::uint32_t seconds = run.ticks / kTicksPerSecond;
    // A fall holds blocks that broke in it too, which are not among the fallen ones.
    const std::string fall =
        run.largestFall > 0 ? fmt::format(", {} fell or broke in one fall", run.largestFall) : "";
    canvas.text(fmt::format("{} of {} in {}:{:02}{}", run.cleared,
                            countText(look.game.blocksAtStart(), "block"), seconds / 60,
                            seconds % 60, fall),
                {0, y}, {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Middle});
}

constexpr std::array<Color, kMedalNames.size()> kMedalColors = {
    palette::kQuiet, Color{214, 142, 88}, Color{206, 214, 228}, Color{255, 204, 92}};

/// What the score is worth: "points, silver medal, gold from 12 300".
std::string worthText(const ResultsLook& look) {
    const std::string& level = look.game.level().name;
    const bool won = look.game.result() == Result::Won;
    const auto worth = static_cast<std::size_t>(medalOf(look.score, level, look.marks));
    const auto medal = static_cast<std::size_t>(medalWon(look.score, won, level, look.marks));
    std::string text = look.newBest ? "your best so far" : "points";
    if (medal > 0) {
        text += fmt::format(", {} medal", kMedalNames[medal]);
    }
    if (worth > medal) {
        text += fmt::format(", {} had it been won", kMedalNames[worth]);
    } else if (const std::int32_t next = nextMark(look.score, level, look.marks); next > 0) {
        text += fmt::format(", {} from {}", kMedalNames[medal + 1], grouped(next));
    }
    return text;
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

/// A ball over a paddle.
void paintFewHits(Canvas& canvas, Vec2 middle, Real size, Color color) {
    canvas.disc(middle + size * Vec2{0, Real(0.45)}, Real(0.32) * size, color, color);
    canvas.line(middle + size * Vec2{Real(-0.85), Real(-0.5)},
                middle + size * Vec2{Real(0.85), Real(-0.5)}, Real(0.32) * size, color);
}

/// Two blocks and one that has tipped over.
void paintOneFall(Canvas& canvas, Vec2 middle, Real size, Color color) {
    const Real width = Real(0.42) * size;
    canvas.line(middle + size * Vec2{Real(-0.7), Real(-0.7)},
                middle + size * Vec2{Real(-0.7), Real(0.7)}, width, color);
    canvas.line(middle + size * Vec2{Real(-0.1), Real(-0.7)},
                middle + size * Vec2{Real(0.25), Real(0.6)}, width, color);
    canvas.line(middle + size * Vec2{Real(0.35), Real(-0.6)},
                middle + size * Vec2{Real(1.0), Real(-0.1)}, width, color);
}

/// A bell.
void paintKept(Canvas& canvas, Vec2 middle, Real size, Color color) {
    const std::array<Vec2, 6> body = {middle + size * Vec2{Real(-0.8), Real(-0.45)},
                                      middle + size * Vec2{Real(0.8), Real(-0.45)},
                                      middle + size * Vec2{Real(0.5), Real(-0.05)},
                                      middle + size * Vec2{Real(0.4), Real(0.7)},
                                      middle + size * Vec2{Real(-0.4), Real(0.7)},
                                      middle + size * Vec2{Real(-0.5), Real(-0.05)}};
    const std::array<Vec2, 4> skirt = {body[0], body[1], body[2], body[5]};
    const std::array<Vec2, 4> crown = {body[5], body[2], body[3], body[4]};
    canvas.polygon(skirt, color);
    canvas.polygon(crown, color);
    canvas.disc(middle + size * Vec2{0, Real(-0.68)}, Real(0.24) * size, color, color);
}

/// True if so many blocks are to be cleared as one combo or fall must have.
bool offersChain(const Level& level) {
    const auto counts = [&](const auto& block) { return level.kinds[block.kind].breakable(); };
    const auto count = std::count_if(level.cells.begin(), level.cells.end(), counts) +
                       std::count_if(level.freeBlocks.begin(), level.freeBlocks.end(), counts);
    return count >= kMostCombo;
}

struct Honour {
    std::string name;
    bool won = false;
    std::function<void(Canvas&, Vec2 middle, Real size, Color)> paint; // its sign
};

/// The honours that a level and its marks offer, the usual ones first.
std::vector<Honour> honoursOf(const HonoursLook& look) {
    const auto& [best, level, marks] = look;
    std::vector<Honour> all = {{"cleared", best.cleared, &paintCleared},
                               {"no ball lost", best.unhurt, &paintUnhurt}};
    if (offersChain(level)) {
        all.push_back(
            {fmt::format("{} in one combo or fall", kMostCombo), best.chain, &paintChain});
    }
    if (marks != nullptr && marks->fewHits > 0) {
        all.push_back({countText(marks->fewHits, "hit") + " at most", best.fewHits, &paintFewHits});
    }
    if (marks != nullptr && marks->oneFall > 0) {
        all.push_back({fmt::format("a fall of {}", marks->oneFall), best.oneFall, &paintOneFall});
    }
    if (level.keep >= 0) {
        all.push_back({"keep the " + level.keepName, best.kept, &paintKept});
    }
    for (std::size_t i = 0; i < level.ways.size(); ++i) {
        all.push_back({level.ways[i].name, isWayIn(best.ways, i),
                       [first = i == 0](Canvas& canvas, Vec2 middle, Real size, Color color) {
                           paintWay(canvas, middle, size, color, first);
                       }});
    }
    return all;
}

} // namespace

void paintMedal(Canvas& canvas, Vec2 middle, Real size, Medal medal) {
    if (medal == Medal::None) {
        return;
    }
    const Color color = kMedalColors[static_cast<std::size_t>(medal)];
    canvas.disc(middle, size, lighter(color, 0.25f), darker(color, 0.25f));
    canvas.ring(middle, Real(0.82) * size, Real(0.14) * size, darker(color, 0.5f));
    const auto dots = static_cast<int>(medal);
    for (int i = 0; i < dots; ++i) {
        const Real x = Real(0.42) * size * (static_cast<Real>(i) - Real(dots - 1) / 2);
        canvas.disc(middle + Vec2{x, 0}, Real(0.16) * size, palette::kInk, palette::kInk);
    }
}

std::vector<std::string> honourNames(const Level& level, const MedalMarks* marks) {
    std::vector<std::string> names;
    for (Honour& honour : honoursOf({{}, level, marks})) {
        names.push_back(std::move(honour.name));
    }
    return names;
}

std::size_t usualHonours(const Level& level) {
    return offersChain(level) ? 3 : 2;
}

std::vector<bool> honoursWon(const HonoursLook& look) {
    std::vector<bool> won;
    for (const Honour& honour : honoursOf(look)) {
        won.push_back(honour.won);
    }
    return won;
}

void paintHonours(Canvas& canvas, Vec2 place, Vec2 step, Real size, const HonoursLook& look) {
    for (const Honour& honour : honoursOf(look)) {
        const Color color = honour.won ? palette::kAccent : faded(palette::kQuiet, 0.35f);
        honour.paint(canvas, place, size, color);
        place += step;
    }
}

void paintResults(Canvas& canvas, const ResultsLook& look) {
    const Game& game = look.game;
    constexpr std::array<const char*, 3> kTitles = {"The replay ends", "Level cleared",
                                                    "Game over"};
    constexpr std::array<Color, 3> kColors = {palette::kText, palette::kAccent, palette::kDanger};
    const auto result = static_cast<std::size_t>(game.result());
    canvas.text(kTitles[result], {0, Real(15.2)},
                {Real(1.7), kColors[result], Typeface::Display, Align::Middle});
    canvas.text(shortened(game.level().title, 56), {0, Real(14.2)},
                {Real(0.6), palette::kQuiet, Typeface::Plain, Align::Middle, Real(22)});
    const double share = std::clamp(look.seconds / kCountSeconds, 0.0, 1.0);
    const auto shown = static_cast<int>(share * look.score);
    canvas.text(grouped(shown), {0, Real(12.3)},
                {Real(1.6), palette::kText, Typeface::Display, Align::Middle});
    canvas.text(worthText(look), {0, Real(11.6)},
                {Real(0.5), look.newBest ? palette::kAccent : palette::kQuiet, Typeface::Plain,
                 Align::Middle, Real(22)});
    const bool won = game.result() == Result::Won;
    paintMedal(canvas, {Real(-4.8), Real(12.8)}, Real(0.62),
               medalWon(look.score, won, game.level().name, look.marks));
    paintScoreLines(canvas, look);
    const MedalMarks* marks = marksFor(game.level().name, look.marks);
    const Best best = look.statistics.bestOf(game, marks); // honours of this game alone
    const HonoursLook honours{best, game.level(), marks};
    const std::vector<bool> given = honoursWon(honours);
    const std::vector<std::string> names = honourNames(game.level(), marks);
    const Vec2 step{std::min(Real(3.9), kHonoursRoom / static_cast<Real>(names.size())), 0};
    const Vec2 first = Vec2{0, Real(6.8)} - static_cast<Real>(names.size() - 1) / 2 * step;
    paintHonours(canvas, first, step, Real(0.42), honours);
    const Real room = step.x - Real(0.3);
    for (std::size_t i = 0; i < names.size(); ++i) {
        Vec2 place = first + static_cast<Real>(i) * step - Vec2{0, Real(0.85)};
        const std::vector<std::string> lines = wrappedInto(2, names[i], 15, 22);
        const Real height = evenHeight(canvas, lines, Real(0.38), room);
        const Color color = given[i] ? palette::kAccent : palette::kQuiet;
        for (const std::string& line : lines) {
            canvas.text(line, place, {height, color, Typeface::Plain, Align::Middle, room});
            place.y -= Real(0.54);
        }
    }
}

} // namespace apart
