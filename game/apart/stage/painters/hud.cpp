// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/core/way_watch.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/hud.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

using layout::kPanelLeft;
using layout::kPanelRight;

constexpr Real kPanelRoom =
    kPanelRight - kPanelLeft + Real(0.3); // m, up to the edge of the picture

TextStyle quiet(Real height) {
    return {height, palette::kQuiet, Typeface::Plain, Align::Left, kPanelRoom};
}
TextStyle strong(Real height, Color color = palette::kText) {
    return {height, color, Typeface::Bold, Align::Left, kPanelRoom};
}
/// The height is limited so that nine digits fit into the panel.
TextStyle display(Real height, Color color = palette::kText) {
    return {height, color, Typeface::Display, Align::Left};
}

Aabb barAt(Real y) {
    return {{kPanelLeft, y}, {kPanelRight, y + Real(0.22)}};
}

/// A name at the left, and a value at the right.
void paintPair(Canvas& canvas, std::string_view name, std::string_view value, Real y,
               Color color = palette::kQuiet) {
    canvas.text(name, {kPanelLeft, y},
                {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Left, Real(2.6)});
    canvas.text(value, {kPanelRight, y},
                {Real(0.42), color, Typeface::Plain, Align::Right, Real(1.9)});
}

void paintLevel(Canvas& canvas, const Game& game, const HudLook& look) {
    canvas.text("aPart", {kPanelLeft, Real(17.05)}, display(Real(1.15), palette::kAccent));
    canvas.text(look.place, {kPanelLeft, Real(16.0)}, quiet(Real(0.42)));
    if (game.mode() != Mode::Standard) {
        canvas.text(game.mode() == Mode::Pure ? "PURE" : "ASSISTED", {kPanelLeft, Real(18.1)},
                    strong(Real(0.42), palette::kAccent));
    }
    Real y = Real(15.3);
    for (const std::string& line : wrappedInto(2, game.level().title, 14, 18)) {
        canvas.text(line, {kPanelLeft, y}, strong(line.size() > 10 ? Real(0.52) : Real(0.58)));
        y -= Real(0.72) + Real(0.25) * (canvas.textScale() - 1);
    }
}

void paintScore(Canvas& canvas, const Game& game, const HudLook& look) {
    const std::int32_t score = look.scoreBefore + game.score();
    const bool beaten = look.best > 0 && score > look.best;
    const std::uint32_t seconds = look.ticks / kTicksPerSecond;
    paintPair(canvas, "SCORE", fmt::format("{}:{:02}", seconds / 60, seconds % 60), Real(13.75));
    canvas.text(grouped(score), {kPanelLeft, Real(12.8)},
                display(Real(1), beaten ? palette::kAccent : palette::kText));
    if (look.best > 0) {
        const std::string best = beaten ? "best so far" : "best  " + grouped(look.best);
        canvas.text(best, {kPanelLeft, Real(12.2)}, quiet(Real(0.42)));
    }
    canvas.text(look.medal, {kPanelLeft, Real(11.6)}, quiet(Real(0.42)));
}

void paintHits(Canvas& canvas, const Game& game) {
    paintPair(canvas, "BALLS", countText(game.counts().hits, "hit"), Real(10.7));
    paintLives(canvas, game, {kPanelLeft, Real(10.1)}, kPanelRight - kPanelLeft, Real(0.62));
}

/// The best blow so far, and its prize.
void paintBlow(Canvas& canvas, const Game& game) {
    paintPair(canvas, "BEST BLOW", countText(game.counts().bestBlow, "block"), Real(9.2));
    paintPair(canvas, "PRIZE", grouped(payable(game)), Real(8.5),
              game.result() == Result::Lost ? palette::kQuiet : palette::kAccent);
}

void paintProgress(Canvas& canvas, const Game& game) {
    const int all = std::max<int>(game.blocksAtStart(), 1);
    const int left = game.blocksLeft();
    canvas.text(fmt::format("BLOCKS LEFT  {}", left), {kPanelLeft, Real(7.6)}, quiet(Real(0.42)));
    paintBar(canvas, barAt(Real(7.15)), static_cast<Real>(left) / static_cast<Real>(all),
             palette::kText);
}

void paintMeter(Canvas& canvas, const Game& game) {
    const bool acts = game.force() != Force::None;
    const char* word = game.force() == Force::Pull   ? "PULL"
                       : game.force() == Force::Push ? "PUSH"
                                                     : "PULL / PUSH";
    canvas.text(word, {kPanelLeft, Real(6.45)},
                {Real(0.42), acts ? palette::kPaddle : palette::kQuiet, Typeface::Plain,
                 Align::Left, kPanelRoom});
    paintBar(canvas, barAt(Real(6)), game.meter(),
             game.meter() > Real(0.15) ? palette::kPaddle : palette::kDanger);
}

void paintCombo(Canvas& canvas, const Game& game) {
    if (game.counts().combo < 2) {
        return;
    }
    // The size grows with the combo while there is room for its digits.
    const bool wide = game.counts().combo >= 10;
    const Real size =
        wide ? Real(0.7) : Real(0.56) + Real(0.022) * static_cast<Real>(game.counts().combo);
    canvas.text(fmt::format("combo x{}", game.counts().combo), {kPanelLeft, Real(5.2)},
                display(size, palette::kAccent));
}

/// Paints the powers of this level with their remaining time, active ones first. Returns the next
/// free height.
Real paintPowers(Canvas& canvas, const Game& game) {
    constexpr Real kLongest = static_cast<Real>(kEffectTicks) / kTicksPerSecond; // s
    constexpr std::size_t kMost = 5; // limited by the height of the panel
    std::vector<Power> powers = powersOf(game.level());
    std::stable_partition(powers.begin(), powers.end(),
                          [&](Power power) { return game.state().secondsLeft(power) > 0; });
    powers.resize(std::min(powers.size(), kMost));
    Real y = Real(4.4);
    for (const Power power : powers) {
        const Real left = game.state().secondsLeft(power);
        const Color color = canvas.palette().of(power);
        const Vec2 middle{kPanelLeft + Real(0.3), y + Real(0.13)};
        paintMood(canvas, moodOf(power), middle,
                  {Real(0.24), {12, 14, 26, 235}, color, Real(0.04)});
        paintMark(canvas, power, {middle, {}}, Real(0.15), color);
        const Color text = left > 0 ? color : palette::kQuiet;
        canvas.text(wordsOf(power), {kPanelLeft + Real(0.85), y},
                    {Real(0.38), text, Typeface::Plain, Align::Left, kPanelRoom - Real(0.85)});
        if (left > 0) {
            const Real top = y - Real(0.1);
            paintBar(canvas, {{kPanelLeft + Real(0.85), top - Real(0.08)}, {kPanelRight, top}},
                     left / kLongest, color);
        }
        y -= Real(0.68);
    }
    return y;
}

/// Paints the ways of the building from a height down; those of the largest fall so far are lit.
/// Returns the next free height.
Real paintWays(Canvas& canvas, const Level& level, std::uint32_t ways, Real y) {
    if (level.ways.empty()) {
        return y;
    }
    y -= Real(0.2);
    canvas.text("WAYS DOWN", {kPanelLeft, y}, quiet(Real(0.42)));
    for (std::size_t i = 0; i < level.ways.size(); ++i) {
        y -= Real(0.72);
        const Color color = isWayIn(ways, i) ? palette::kAccent : palette::kQuiet;
        paintWay(canvas, {kPanelLeft + Real(0.3), y + Real(0.13)}, Real(0.24), color, i == 0);
        canvas.text(level.ways[i].name, {kPanelLeft + Real(0.85), y},
                    {Real(0.38), color, Typeface::Plain, Align::Left, kPanelRoom - Real(0.85)});
    }
    return y - Real(0.72);
}

/// Paints the honours that the game still has or has not yet from a height down, as many as there
/// is room for.
void paintHonours(Canvas& canvas, const HudLook& look, Real y) {
    constexpr Real kPitch = Real(0.72);
    const Real lowest = look.pilot.empty() ? Real(0.7) : Real(1.5);
    y -= Real(0.2);
    if (look.honours.empty() || y - kPitch < lowest) {
        return;
    }
    canvas.text("HONOURS", {kPanelLeft, y}, quiet(Real(0.42)));
    for (const HudHonour& honour : look.honours) {
        y -= kPitch;
        if (y < lowest) {
            return;
        }
        const Color color = honour.kept ? palette::kAccent : palette::kQuiet;
        canvas.disc({kPanelLeft + Real(0.3), y + Real(0.13)}, Real(0.1), color, color);
        canvas.text(honour.name, {kPanelLeft + Real(0.85), y},
                    {Real(0.38), color, Typeface::Plain, Align::Left, kPanelRoom - Real(0.85)});
    }
}

void paintFoot(Canvas& canvas, const HudLook& look) {
    if (!look.pilot.empty()) {
        canvas.text(look.pilot, {kPanelLeft, Real(0.9)}, strong(Real(0.5), palette::kAccent));
    }
    const std::string pause = fmt::format("{}: pause", look.keys.firstKey(Act::Pause));
    const std::string sound = fmt::format("sound off ({})", look.keys.firstKey(Act::Mute));
    if (!look.foot.empty()) {
        return canvas.text(look.foot, {kPanelLeft, Real(0.2)}, quiet(Real(0.42)));
    }
    if (look.keys.fingers && !look.muted) {
        return; // the page has a button
    }
    canvas.text(look.muted ? sound : pause, {kPanelLeft, Real(0.2)}, quiet(Real(0.36)));
}

} // namespace

void paintBar(Canvas& canvas, const Aabb& where, Real share, Color color) {
    const Real right = where.lower.x + std::clamp(share, Real(0), Real(1)) * where.extent().x;
    canvas.rectangle(where, {255, 255, 255, 26}, {255, 255, 255, 26});
    canvas.rectangle({where.lower, {right, where.upper.y}}, darker(color, 0.15f), color);
}

void paintQuestion(Canvas& canvas, std::string_view question, Real bottom) {
    constexpr std::size_t kShort = 40; // letters
    if (!question.empty()) {
        const Real half = question.size() > kShort ? Real(11.5) : Real(5.5);
        canvas.rectangle({{-half, bottom}, {half, bottom + Real(1.1)}}, faded(palette::kInk, 0.9f),
                         faded(palette::kInk, 0.9f));
        canvas.text(
            question, {0, bottom + Real(0.35)},
            {Real(0.6), palette::kAccent, Typeface::Bold, Align::Middle, 2 * half - Real(0.4)});
    }
}

std::string grouped(int number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3 + (number < 0 ? 1u : 0u);) {
        i -= 3;
        digits.insert(i, 1, ' ');
    }
    return digits;
}

/// True for the second and further bytes of a letter in UTF-8.
static bool isInner(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

static std::size_t lettersOf(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), isInner));
}

std::string countText(std::int64_t count, std::string_view what) {
    return fmt::format("{} {}{}", grouped(static_cast<int>(count)), what, count == 1 ? "" : "s");
}

std::vector<std::string> wrapped(std::string_view text, std::size_t letters) {
    std::vector<std::string> lines;
    std::string line;
    while (!text.empty()) {
        const std::size_t space = text.find(' ');
        const std::string_view word = text.substr(0, space);
        text = space == std::string_view::npos ? std::string_view{} : text.substr(space + 1);
        if (!line.empty() && lettersOf(line) + 1 + lettersOf(word) > letters) {
            lines.push_back(line);
            line.clear();
        }
        line += line.empty() ? "" : " ";
        line += word;
    }
    if (!line.empty()) {
        lines.push_back(line);
    }
    return lines;
}

std::vector<std::string> wrappedInto(std::size_t lines, std::string_view text, std::size_t letters,
                                     std::size_t most) {
    std::vector<std::string> found = wrapped(text, letters);
    while (found.size() > lines && letters < most) {
        found = wrapped(text, ++letters);
    }
    while (found.size() > lines) {
        found[lines - 1] += " " + found[lines];
        found.erase(found.begin() + static_cast<std::ptrdiff_t>(lines));
    }
    for (std::string& line : found) {
        line = shortened(line, most);
    }
    return found;
}

std::string shortened(std::string_view text, std::size_t most) {
    constexpr std::string_view kCut = "...";
    if (lettersOf(text) <= most) {
        return std::string(text);
    }
    std::size_t end = 0; // of the last letter that stays
    for (std::size_t letters = 0; letters + kCut.size() < most; ++letters) {
        do {
            ++end;
        } while (end < text.size() && isInner(text[end]));
    }
    const std::size_t last = text.substr(0, end).find_last_not_of(' ');
    return std::string(text.substr(0, last + 1)) + std::string(kCut);
}

Real evenHeight(const Canvas& canvas, const std::vector<std::string>& lines, Real height,
                Real width) {
    constexpr Real kLetter = Real(0.6); // of its height: mean width of a letter, rather too much
    std::size_t most = 1;
    for (const std::string& line : lines) {
        most = std::max(most, lettersOf(line));
    }
    return std::min(height, width / (kLetter * canvas.textScale() * static_cast<Real>(most)));
}

std::size_t fitting(const Canvas& canvas, std::size_t letters) {
    return static_cast<std::size_t>(static_cast<Real>(letters) / canvas.textScale());
}

void paintLives(Canvas& canvas, const Game& game, Vec2 from, Real room, Real step) {
    const Real edge = Real(0.45) * step; // from an end of the row to the middle of a ball
    const int shown = std::min<int>(game.lives(), 12);
    const Real closest = (room - 2 * edge) / static_cast<Real>(std::max(shown - 1, 1));
    for (int i = 0; i < shown; ++i) {
        const Vec2 center = from + Vec2{edge + std::min(step, closest) * static_cast<Real>(i), 0};
        canvas.disc(center, (i > 0 ? Real(0.32) : Real(0.42)) * step, palette::kBall,
                    darker(palette::kBall, 0.2f));
    }
}

void paintHud(Canvas& canvas, const Game& game, const HudLook& look) {
    paintLevel(canvas, game, look);
    paintScore(canvas, game, look);
    paintHits(canvas, game);
    paintBlow(canvas, game);
    paintProgress(canvas, game);
    paintMeter(canvas, game);
    paintCombo(canvas, game);
    const Real y = paintPowers(canvas, game);
    paintHonours(canvas, look, paintWays(canvas, game.level(), look.ways, y));
    paintFoot(canvas, look);
}

} // namespace apart
