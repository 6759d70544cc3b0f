// SPDX-License-Identifier: MIT
// The picture of a duel: two fields side by side, and a panel below each.
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/inset_canvas.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/backdrop.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/screens/duel.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

// m, in the picture
constexpr Real kBoxTop = Real(16.8);
constexpr Real kBoxInner = Real(0.15); // from the middle of the picture
constexpr Real kBoxOuter = Real(15.4);
constexpr Real kBoxMargin = Real(0.6);
/// What is shown of a field (m).
constexpr Aabb kFieldShown{{layout::kLeft - kBoxMargin, layout::kShown.lower.y},
                           {layout::kRight + kBoxMargin, layout::kTop + kBoxMargin}};

constexpr std::array<const char*, kSeats> kPlayers = {"Player 1", "Player 2"};
constexpr std::array<Color, kSeats> kPlayerColors = {palette::kPaddle, palette::kBumper};

TextStyle small(Color color, Real room, Align align = Align::Left) {
    return {Real(0.42), color, Typeface::Plain, align, room};
}

/// Paints the page around the boxes: it covers what crosses their edges.
void paintPage(Canvas& canvas, const Level& level, Mode mode, bool heads) {
    const Color color = lookOf(level.theme).night;
    const Aabb all = canvas.visible().grown(1);
    const Aabb left = Duel::boxOf(0);
    const Aabb right = Duel::boxOf(1);
    for (const Aabb& bar : {Aabb{all.lower, {left.lower.x, all.upper.y}},
                            Aabb{{right.upper.x, all.lower.y}, all.upper},
                            Aabb{{left.upper.x, all.lower.y}, {right.lower.x, all.upper.y}},
                            Aabb{{left.lower.x, all.lower.y}, {right.upper.x, left.lower.y}},
                            Aabb{{left.lower.x, left.upper.y}, {right.upper.x, all.upper.y}}}) {
        canvas.rectangle(bar, color, color);
    }
    if (!heads) {
        return;
    }
    const std::string name(kModeNames[static_cast<std::size_t>(mode)]);
    const std::string title = shortened(level.title, 48);
    canvas.text(mode == Mode::Standard ? title : title + " (" + name + ")", {0, Real(17.95)},
                {Real(0.62), palette::kAccent, Typeface::Bold, Align::Middle, Real(28)});
    canvas.text(shortened(level.idea, 140), {0, Real(17.2)},
                small(palette::kText, Real(30), Align::Middle));
}

/// Columns and lines of the panel of a player (m).
struct Panel {
    Real left;
    Real bars = Real(1.55); // lower edge
    static constexpr Real kColumn = Real(6.8);
    static constexpr Real kGap = Real(1.2);

    Real right() const { return left + kColumn; }
    Real left2() const { return right() + kGap; }
    Real right2() const { return left2() + kColumn; }
    Aabb bar(Real from) const { return {{from, bars}, {from + kColumn, bars + Real(0.2)}}; }
};

void paintPoints(Canvas& canvas, const Panel& at, const Game& game) {
    canvas.text(grouped(game.score()), {at.left, Real(2.9)},
                {Real(1.25), palette::kText, Typeface::Display});
    canvas.text(fmt::format("BLOCKS LEFT  {}", game.blocksLeft()), {at.left, Real(2)},
                small(palette::kQuiet, Panel::kColumn));
    paintBar(canvas, at.bar(at.left),
             static_cast<Real>(game.blocksLeft()) /
                 static_cast<Real>(std::max<std::int32_t>(game.blocksAtStart(), 1)),
             palette::kText);
}

void paintHits(Canvas& canvas, const Panel& at, const Game& game) {
    const Real half = Panel::kColumn / 2;
    canvas.text("BALLS", {at.left2(), Real(4.4)}, small(palette::kQuiet, Real(2)));
    constexpr Real kHits = Real(1.7); // room of their number
    paintLives(canvas, game, {at.left2() + 2, Real(4.55)}, Panel::kColumn - 2 - kHits, Real(0.5));
    canvas.text(countText(game.counts().hits, "hit"), {at.right2(), Real(4.4)},
                small(palette::kQuiet, kHits, Align::Right));
    canvas.text(fmt::format("BEST BLOW  {}", game.counts().bestBlow), {at.left2(), Real(3.6)},
                small(palette::kQuiet, half - Real(0.2)));
    canvas.text("prize " + grouped(payable(game)), {at.right2(), Real(3.6)},
                small(game.result() == Result::Lost ? palette::kQuiet : palette::kAccent, half,
                      Align::Right));
    const char* word = game.force() == Force::Pull   ? "PULL"
                       : game.force() == Force::Push ? "PUSH"
                                                     : "PULL / PUSH";
    canvas.text(
        word, {at.left2(), Real(2)},
        small(game.force() != Force::None ? palette::kPaddle : palette::kQuiet, Panel::kColumn));
    paintBar(canvas, at.bar(at.left2()), game.meter(),
             game.meter() > Real(0.15) ? palette::kPaddle : palette::kDanger);
}

/// The powers that act, with their remaining time.
void paintActing(Canvas& canvas, const Panel& at, const Game& game) {
    constexpr Real kLongest = static_cast<Real>(kEffectTicks) / kTicksPerSecond; // s
    Vec2 place{at.left2() + Real(0.3), Real(3)};
    for (const Effect& effect : game.effects()) {
        const Color color = canvas.palette().of(effect.power);
        paintMood(canvas, moodOf(effect.power), place,
                  {Real(0.26), {12, 14, 26, 235}, color, Real(0.04)});
        paintMark(canvas, effect.power, {place, {}}, Real(0.16), color);
        const Vec2 corner = place - Vec2{Real(0.3), Real(0.42)};
        paintBar(canvas, {corner, corner + Vec2{Real(0.6), Real(0.08)}},
                 game.state().secondsLeft(effect.power) / kLongest, color);
        place.x += Real(0.95);
    }
}

/// The keys of a player: the first line for the serve too.
std::array<std::string, 2> keyLines(std::size_t player, const Bindings& keys) {
    const auto key = [&](Act act) { return keys.text(act, kColumnOfSeat[player]); };
    if (player == 0) {
        return {fmt::format("{} and {}, or the mouse: move      {} or click: serve", key(Act::Left),
                            key(Act::Right), keys.prompt(Act::Serve)),
                fmt::format("{} or left button: pull      {} or right button: push      "
                            "or gamepad 1",
                            key(Act::Pull), key(Act::Push))};
    }
    return {
        fmt::format("{} and {}: move      enter: serve", key(Act::Left), key(Act::Right)),
        fmt::format("{}: pull      {}: push      or gamepad 2", key(Act::Pull), key(Act::Push))};
}

void paintPlayer(Canvas& canvas, std::size_t player, const Game& game, const Bindings& keys) {
    const Panel at{Duel::boxOf(player).lower.x + Real(0.2)};
    canvas.text(kPlayers[player], {at.left, Real(4.3)},
                {Real(0.62), kPlayerColors[player], Typeface::Bold, Align::Left, Real(4)});
    if (game.counts().combo >= 2) {
        canvas.text(fmt::format("combo x{}", game.counts().combo), {at.right(), Real(4.3)},
                    {Real(0.6), palette::kAccent, Typeface::Display, Align::Right, Real(2.7)});
    }
    paintPoints(canvas, at, game);
    paintHits(canvas, at, game);
    paintActing(canvas, at, game);
    const std::array<std::string, 2> lines = keyLines(player, keys);
    const Real room = at.right2() - at.left;
    const Color serve = game.serving() ? palette::kAccent : palette::kQuiet;
    canvas.text(lines[0], {at.left, Real(0.75)}, small(serve, room));
    canvas.text(lines[1], {at.left, Real(0.05)}, small(palette::kQuiet, room));
}

/// The result of one player, in a column around `x` (m).
void paintColumn(Canvas& canvas, Real x, const Duel::Half& half, std::size_t player, bool wins) {
    const Game& game = half.game();
    const auto line = [&](const std::string& text, Real y, TextStyle style) {
        style.align = Align::Middle;
        canvas.text(text, {x, y}, style);
    };
    const std::uint32_t seconds = half.statistics.ticks / kTicksPerSecond;
    line(kPlayers[player], Real(14.4), {Real(0.8), kPlayerColors[player], Typeface::Bold});
    line(grouped(game.score()), Real(12),
         {Real(2), wins ? palette::kAccent : palette::kText, Typeface::Display});
    const std::array<std::string, 4> lines = {
        fmt::format("{} after {}:{:02}",
                    game.result() == Result::Won ? "level cleared" : "no ball left", seconds / 60,
                    seconds % 60),
        fmt::format("{} of {}", half.statistics.cleared, countText(game.blocksAtStart(), "block")),
        fmt::format("{}, {} left", countText(game.counts().hits, "hit"),
                    countText(game.lives(), "ball")),
        fmt::format("best blow: {}, prize {}", countText(game.counts().bestBlow, "block"),
                    grouped(half.statistics.points.prize))};
    Real y = Real(10.4);
    for (const std::string& text : lines) {
        line(text, y, {Real(0.52), palette::kText, Typeface::Plain, Align::Middle, Real(14)});
        y -= Real(1);
    }
}

} // namespace

Real Duel::scale() {
    return (kBoxOuter - kBoxInner) / kFieldShown.extent().x;
}

Aabb Duel::boxOf(std::size_t player) {
    const Real low = kBoxTop - scale() * kFieldShown.extent().y;
    const Real left = player == 0 ? -kBoxOuter : kBoxInner;
    return {{left, low}, {left + kBoxOuter - kBoxInner, kBoxTop}};
}

void Duel::paintHalf(Canvas& canvas, std::size_t player) const {
    const Half& half = halves_[player];
    const Aabb box = boxOf(player);
    const Vec2 shake = scale() * half.play.juice().shake();
    InsetCanvas inset(canvas, kFieldShown, {box.lower + shake, box.upper + shake},
                      static_cast<Vision>(std::clamp(half.play.juice().settings().colors, 0, 3)));
    const auto share = static_cast<Real>(std::min(owed_ * kTicksPerSecond, 1.0));
    paintBackdrop(inset, half.game().level().theme, now_);
    half.play.draw(inset, share, kFieldShown, phase_ == Phase::Playing && !half.ended());
    if (half.ended() && phase_ == Phase::Playing) {
        const bool won = half.game().result() == Result::Won;
        canvas.rectangle(box, faded(palette::kNight, 0.6f), faded(palette::kNight, 0.6f));
        canvas.text(won ? "Cleared" : "No ball left", box.center(),
                    {Real(1.2), won ? palette::kAccent : palette::kDanger, Typeface::Display,
                     Align::Middle});
        if (!halves_[1 - player].ended()) {
            canvas.text("waits for the other player", box.center() - Vec2{0, Real(1.1)},
                        small(palette::kText, Real(14), Align::Middle));
        }
    }
}

void Duel::paintResult(Canvas& canvas) const {
    const std::optional<std::size_t> best = winner();
    canvas.text(best ? std::string(kPlayers[*best]) + " wins" : "A tie", {0, Real(17.25)},
                {Real(1.6), best ? kPlayerColors[*best] : palette::kText, Typeface::Display,
                 Align::Middle});
    for (std::size_t i = 0; i < kSeats; ++i) {
        paintColumn(canvas, boxOf(i).center().x, halves_[i], i, best == i);
    }
    canvas.text(shortened(game(0).level().title, 56) +
                    "      a duel enters no scores, medals or replays",
                {0, Real(0.1)}, small(palette::kQuiet, Real(28), Align::Middle));
}

void Duel::draw(Canvas& canvas, const Bindings& keys) const {
    const bool over = phase_ == Phase::Over;
    for (std::size_t i = 0; i < kSeats; ++i) {
        paintHalf(canvas, i);
    }
    paintPage(canvas, game(0).level(), game(0).mode(), !over);
    for (std::size_t i = 0; i < kSeats && !over; ++i) {
        paintPlayer(canvas, i, game(i), keys);
    }
    if (phase_ == Phase::Playing) {
        return paintQuestion(canvas, confirm_.question(now_), Real(10.5));
    }
    paintVeil(canvas, faded(palette::kNight, 0.72f));
    if (over) {
        paintResult(canvas);
    } else {
        canvas.text("Paused", {0, menu_.place(0).upper.y + Real(1.4)},
                    {Real(1.6), palette::kText, Typeface::Display, Align::Middle});
    }
    menu_.draw(canvas);
}

} // namespace apart
