// SPDX-License-Identifier: MIT
#include <apart/stage/block_painter.hpp>
#include <apart/stage/hud.hpp>
#include <apart/stage/palette.hpp>
#include <apart/stage/title.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr int kTilesInRow = 10;
constexpr Real kTile = Real(1.55); // m, from tile to tile
constexpr Real kTilesTop = Real(8.6);

std::array<Vec2, 4> cornersOf(const Aabb& box) {
    return {box.lower, Vec2{box.upper.x, box.lower.y}, box.upper, Vec2{box.lower.x, box.upper.y}};
}

/// Pieces that fly off the name, one for each stuff.
void drawPieces(Canvas& canvas, double seconds) {
    struct Piece {
        Vec2 place;
        Real size;
        Stuff stuff;
    };
    constexpr std::array<Piece, 8> kPieces = {
        Piece{{Real(5.6), Real(14.9)}, Real(0.50), Stuff::Brick},
        Piece{{Real(6.7), Real(13.8)}, Real(0.36), Stuff::Glass},
        Piece{{Real(7.4), Real(15.2)}, Real(0.28), Stuff::Wood},
        Piece{{Real(8.3), Real(14.2)}, Real(0.20), Stuff::Stone},
        Piece{{Real(-6.1), Real(14.6)}, Real(0.34), Stuff::Wood},
        Piece{{Real(-7.1), Real(13.7)}, Real(0.24), Stuff::Brick},
        Piece{{Real(-7.5), Real(15.2)}, Real(0.18), Stuff::Glass},
        Piece{{Real(6.2), Real(12.9)}, Real(0.18), Stuff::Stone}};
    for (std::size_t i = 0; i < kPieces.size(); ++i) {
        const Piece& piece = kPieces[i];
        const auto phase = static_cast<double>(i);
        const auto angle = static_cast<Real>(0.4 * seconds * (i % 2 == 0 ? 1 : -1) + 2 * phase);
        const auto rise = static_cast<Real>(0.18 * std::sin(0.9 * seconds + phase));
        std::array<Vec2, 5> corners;
        constexpr std::array<Real, 5> kReach = {1, Real(0.8), Real(1.15), Real(0.7), Real(0.95)};
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Real turn = angle + Real(1.2566) * static_cast<Real>(k);
            corners[k] = piece.place + Vec2{0, rise} +
                         piece.size * kReach[k] * Vec2{std::cos(turn), std::sin(turn)};
        }
        paintLit(canvas, corners, palette::of(piece.stuff));
        canvas.outline(corners, Real(0.05), lighter(palette::of(piece.stuff), 0.4f));
    }
}

} // namespace

Aabb Title::tile(std::size_t level) const {
    const int index = static_cast<int>(level);
    const int count = static_cast<int>(levels_);
    const int row = index / kTilesInRow;
    const int inRow = std::min(count - row * kTilesInRow, kTilesInRow);
    const Real left = Real(-0.5) * kTile * static_cast<Real>(inRow);
    const Vec2 lower{left + kTile * static_cast<Real>(index % kTilesInRow),
                     kTilesTop - kTile * static_cast<Real>(row + 1)};
    return {lower + Vec2{Real(0.1), Real(0.1)}, lower + Vec2{kTile - Real(0.1), kTile - Real(0.1)}};
}

void Title::move(int step) {
    const int count = static_cast<int>(levels_);
    const int next = static_cast<int>(chosen_) + step;
    if (next >= 0 && next < count) {
        chosen_ = static_cast<std::size_t>(next);
    }
}

std::optional<std::size_t> Title::take(const Signals& signals) {
    for (std::size_t i = 0; i < levels_; ++i) {
        if (signals.pointer && tile(i).contains(*signals.pointer)) {
            chosen_ = i;
        }
    }
    for (const Command command : signals.commands) {
        switch (command) {
        case Command::Left:
            move(-1);
            break;
        case Command::Right:
            move(1);
            break;
        case Command::Up:
            move(-kTilesInRow);
            break;
        case Command::Down:
            move(kTilesInRow);
            break;
        case Command::Launch:
        case Command::Confirm:
            return chosen_;
        default:
            break;
        }
    }
    return signals.clicked && levels_ > 0 ? std::optional(chosen_) : std::nullopt;
}

void Title::drawName(Canvas& canvas, double seconds) const {
    constexpr std::array<const char*, 5> kLetters = {"a", "P", "a", "r", "t"};
    constexpr std::array<Real, 5> kPlaces = {Real(-4.3), Real(-2.1), Real(0.15), Real(2.25),
                                             Real(3.95)};
    constexpr std::array<Stuff, 5> kStuffs = {Stuff::Glass, Stuff::Wood, Stuff::Brick, Stuff::Stone,
                                              Stuff::Glass};
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
        const double wave = std::sin(1.3 * seconds - 0.8 * static_cast<double>(i));
        const Vec2 place{kPlaces[i], Real(12.7) + static_cast<Real>(0.12 * wave)};
        Color color = lighter(palette::of(kStuffs[i]), 0.15f);
        color.a = 255;
        canvas.text(kLetters[i], place + Vec2{Real(0.1), Real(-0.1)},
                    {Real(3.6), palette::kInk, Typeface::Bold, Align::Middle});
        canvas.text(kLetters[i], place, {Real(3.6), color, Typeface::Bold, Align::Middle});
    }
    canvas.text("blocks that really come apart", {0, Real(11.2)},
                {Real(0.62), palette::kText, Typeface::Plain, Align::Middle});
}

void Title::drawTiles(Canvas& canvas) const {
    for (std::size_t i = 0; i < levels_; ++i) {
        const Aabb box = tile(i);
        const bool chosen = i == chosen_;
        const std::array<Vec2, 4> corners = cornersOf(box);
        canvas.polygon(corners, chosen ? faded(palette::kAccent, 0.25f) : Color{255, 255, 255, 16});
        canvas.outline(corners, Real(0.05),
                       chosen ? palette::kAccent : faded(palette::kQuiet, 0.5f));
        canvas.text(std::to_string(i + 1), {box.center().x, box.lower.y + Real(0.43)},
                    {Real(0.72), chosen ? palette::kAccent : palette::kText, Typeface::Bold,
                     Align::Middle});
    }
}

void Title::draw(Canvas& canvas, const Level& chosen, double seconds) const {
    drawPieces(canvas, seconds);
    drawName(canvas, seconds);
    canvas.text("CHOOSE A LEVEL", {0, Real(9.15)},
                {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Middle});
    drawTiles(canvas);
    Real y = tile(levels_ > 0 ? levels_ - 1 : 0).lower.y - Real(1.15);
    canvas.text(chosen.title, {0, y}, {Real(0.8), palette::kText, Typeface::Bold, Align::Middle});
    for (const std::string& line : wrapped(chosen.idea, 62)) {
        y -= Real(0.72);
        canvas.text(line, {0, y}, {Real(0.48), palette::kQuiet, Typeface::Plain, Align::Middle});
    }
    canvas.text("enter, space or a click: play      arrows: choose      escape: quit",
                {0, Real(0.9)}, {Real(0.42), palette::kQuiet, Typeface::Plain, Align::Middle});
}

} // namespace apart
