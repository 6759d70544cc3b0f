// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/logo.hpp>
#include <apart/stage/screens/title.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

/// Paints the flying pieces, one per stuff.
void paintPieces(Canvas& canvas, double seconds) {
    struct Piece {
        Vec2 place;
        Real size;
        Stuff stuff;
    };
    constexpr std::array<Piece, 8> kPieces = {
        Piece{{Real(7.6), Real(14.9)}, Real(0.50), Stuff::Brick},
        Piece{{Real(8.6), Real(13.6)}, Real(0.36), Stuff::Glass},
        Piece{{Real(8.9), Real(15.3)}, Real(0.28), Stuff::Wood},
        Piece{{Real(9.8), Real(14.3)}, Real(0.20), Stuff::Stone},
        Piece{{Real(-7.5), Real(14.8)}, Real(0.34), Stuff::Wood},
        Piece{{Real(-8.6), Real(13.7)}, Real(0.24), Stuff::Brick},
        Piece{{Real(-8.9), Real(15.3)}, Real(0.18), Stuff::Glass},
        Piece{{Real(7.2), Real(12.9)}, Real(0.18), Stuff::Stone}};
    for (std::size_t i = 0; i < kPieces.size(); ++i) {
        const Piece& piece = kPieces[i];
        const auto phase = static_cast<double>(i);
        const auto angle = static_cast<Real>(0.4 * seconds * (i % 2 == 0 ? 1 : -1) + 2 * phase);
        const auto rise = static_cast<Real>(0.18 * std::sin(0.9 * seconds + phase));
        std::array<Vec2, 5> corners;
        constexpr std::array<Real, 5> kReach = {1, Real(0.8), Real(1.15), Real(0.7), Real(0.95)};
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Real turn = angle + kTurn * static_cast<Real>(k) / 5;
            corners[k] = piece.place + Vec2{0, rise} + piece.size * kReach[k] * towards(turn);
        }
        const Color color = canvas.palette().of(piece.stuff);
        paintLit(canvas, corners, color, {Real(0.05), lighter(color, 0.4f)});
    }
}

} // namespace

void paintTitle(Canvas& canvas, double seconds) {
    paintPieces(canvas, seconds);
    paintLogo(canvas, {0, Real(13.2)}, Real(2.9), seconds);
    canvas.text("blocks that really come apart", {0, Real(11.9)},
                {Real(0.62), palette::kText, Typeface::Plain, Align::Middle});
}

} // namespace apart
