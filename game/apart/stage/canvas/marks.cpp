// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/marks.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

void bar(Canvas& canvas, const kodo::Transform& place, Vec2 half, Vec2 center, Color color) {
    const std::array<Vec2, 4> corners = {
        place * (center - half), place * (center + Vec2{half.x, -half.y}), place * (center + half),
        place * (center + Vec2{-half.x, half.y})};
    canvas.polygon(corners, color);
}

void plus(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    bar(canvas, place, {size, Real(0.3) * size}, {}, color);
    bar(canvas, place, {Real(0.3) * size, size}, {}, color);
}

void arrow(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    const std::array<Vec2, 3> head = {place * Vec2{-size, Real(-0.05) * size},
                                      place * Vec2{size, Real(-0.05) * size},
                                      place * Vec2{0, size}};
    canvas.polygon(head, color);
    bar(canvas, place, {Real(0.32) * size, Real(0.5) * size}, {0, Real(-0.5) * size}, color);
}

void threeBalls(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    const std::array<Vec2, 3> centers = {Vec2{0, Real(0.52) * size},
                                         Vec2{Real(-0.56) * size, Real(-0.45) * size},
                                         Vec2{Real(0.56) * size, Real(-0.45) * size}};
    for (const Vec2 center : centers) {
        canvas.disc(place * center, Real(0.46) * size, color, color);
    }
}

void weight(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    const std::array<Vec2, 4> body = {place * (size * Vec2{-1, Real(-0.9)}),
                                      place * (size * Vec2{1, Real(-0.9)}),
                                      place * (size * Vec2{Real(0.6), Real(0.35)}),
                                      place * (size * Vec2{Real(-0.6), Real(0.35)})};
    canvas.polygon(body, color);
    canvas.ring(place * Vec2{0, Real(0.55) * size}, Real(0.32) * size, Real(0.2) * size, color);
}

void lopsided(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    canvas.ring(place.position, Real(0.9) * size, Real(0.2) * size, color);
    canvas.disc(place * (size * Vec2{Real(0.4), Real(-0.25)}), Real(0.42) * size, color, color);
}

void egg(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    constexpr int kCorners = 14;
    std::array<Vec2, kCorners> corners;
    for (int i = 0; i < kCorners; ++i) {
        const Real angle = kTurn * static_cast<Real>(i) / kCorners;
        const Real narrow = Real(0.72) - Real(0.14) * std::sin(angle); // pointed at the upper end
        corners[static_cast<std::size_t>(i)] =
            place * (size * Vec2{narrow * std::cos(angle), std::sin(angle)});
    }
    canvas.polygon(corners, color);
}

void burr(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    canvas.disc(place.position, Real(0.55) * size, color, color);
    for (int i = 0; i < 8; ++i) {
        const Real angle = kTurn * static_cast<Real>(i) / 8;
        const Vec2 out = towards(angle);
        canvas.line(place * (Real(0.5) * size * out), place * (size * out), Real(0.26) * size,
                    color);
    }
}

void horseshoe(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    constexpr int kPieces = 8;
    const Vec2 middle{0, Real(-0.2) * size};
    const Real radius = Real(0.65) * size;
    Vec2 before = middle - Vec2{radius, 0};
    for (int i = 1; i <= kPieces; ++i) {
        const Real angle = Real(0.5) * kTurn * (1 + static_cast<Real>(i) / kPieces);
        const Vec2 here = middle + radius * towards(angle);
        canvas.line(place * before, place * here, Real(0.42) * size, color);
        before = here;
    }
    const Vec2 leg{Real(0.21) * size, Real(0.3) * size};
    bar(canvas, place, leg, {-radius, Real(0.1) * size}, color);
    bar(canvas, place, leg, {radius, Real(0.1) * size}, color);
    const Vec2 tip{Real(0.21) * size, Real(0.14) * size};
    bar(canvas, place, tip, {-radius, Real(0.72) * size}, color);
    bar(canvas, place, tip, {radius, Real(0.72) * size}, color);
}

void coil(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    Vec2 before{Real(-0.7) * size, -size};
    for (int i = 1; i <= 4; ++i) {
        const Real side = i % 2 == 0 ? Real(-0.7) : Real(0.7);
        const Vec2 here = size * Vec2{side, static_cast<Real>(i) * Real(0.5) - 1};
        canvas.line(place * before, place * here, Real(0.28) * size, color);
        before = here;
    }
}

void wings(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    for (const Real side : {Real(-1), Real(1)}) {
        const std::array<Vec2, 3> wing = {place * (size * Vec2{side * Real(0.2), Real(-0.5)}),
                                          place * (size * Vec2{side * Real(1.1), Real(0.7)}),
                                          place * (size * Vec2{side * Real(0.2), Real(0.35)})};
        canvas.polygon(wing, color);
    }
}

void well(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    canvas.ring(place.position, Real(0.9) * size, Real(0.16) * size, color);
    canvas.ring(place.position, Real(0.5) * size, Real(0.18) * size, color);
    canvas.disc(place.position, Real(0.2) * size, color, color);
}

void wind(Canvas& canvas, const kodo::Transform& place, Real size, Color color) {
    constexpr std::array<Real, 3> kShift = {Real(0.2), Real(-0.2), Real(0.1)};
    for (std::size_t i = 0; i < kShift.size(); ++i) {
        const Real y = (static_cast<Real>(i) - 1) * Real(0.6);
        canvas.line(place * (size * Vec2{Real(-0.9) + kShift[i], y}),
                    place * (size * Vec2{Real(0.8) + kShift[i], y}), Real(0.24) * size, color);
    }
}

} // namespace

void paintMark(Canvas& canvas, Power power, const kodo::Transform& place, Real size, Color color) {
    switch (power) {
    case Power::None:
        return;
    case Power::Weld:
        return plus(canvas, place, size, color);
    case Power::Launch:
        return arrow(canvas, place, size, color);
    case Power::Split:
        return threeBalls(canvas, place, size, color);
    case Power::Heavy:
        return weight(canvas, place, size, color);
    case Power::Lopsided:
        return lopsided(canvas, place, size, color);
    case Power::Egg:
        return egg(canvas, place, size, color);
    case Power::Rough:
        return burr(canvas, place, size, color);
    case Power::Magnet:
        return horseshoe(canvas, place, size, color);
    case Power::Spring:
        return coil(canvas, place, size, color);
    case Power::Wings:
        return wings(canvas, place, size, color);
    case Power::Well:
        return well(canvas, place, size, color);
    case Power::Wind:
        return wind(canvas, place, size, color);
    }
}

void paintMood(Canvas& canvas, Mood mood, Vec2 middle, const MoodStyle& style) {
    const Real size = style.size;
    std::array<Vec2, 4> corners;
    switch (mood) {
    case Mood::Good:
        canvas.disc(middle, size, style.fill, style.fill);
        return canvas.ring(middle, size, style.width, style.rim);
    case Mood::Mixed:
        corners = {middle - Vec2{0, Real(1.25) * size}, middle + Vec2{Real(1.25) * size, 0},
                   middle + Vec2{0, Real(1.25) * size}, middle - Vec2{Real(1.25) * size, 0}};
        break;
    case Mood::Bad: // pointing down
        corners = {
            middle + size * Vec2{0, Real(-1.5)}, middle + size * Vec2{Real(1.45), Real(0.95)},
            middle + size * Vec2{0, Real(0.95)}, middle + size * Vec2{Real(-1.45), Real(0.95)}};
        break;
    }
    canvas.polygon(corners, style.fill);
    canvas.outline(corners, style.width, style.rim);
}

std::string_view wordsOf(Power power) {
    constexpr std::array<std::string_view, kPowerNames.size()> kWords = {
        "",
        "welds to paddle",
        "sticks, then fires",
        "becomes balls",
        "heavy balls",
        "lopsided balls",
        "egg-shaped balls",
        "rough balls, spin",
        "the paddle draws in",
        "the paddle leaps",
        "wings for paddle",
        "a gravity well",
        "wind blows across",
    };
    return kWords[static_cast<std::size_t>(power)];
}

std::vector<Power> powersOf(const Level& level) {
    std::array<bool, kPowerNames.size()> held{};
    for (const Cell& cell : level.cells) {
        held[static_cast<std::size_t>(level.kinds[cell.kind].power)] = true;
    }
    for (const FreeBlock& block : level.freeBlocks) {
        held[static_cast<std::size_t>(level.kinds[block.kind].power)] = true;
    }
    std::vector<Power> powers;
    for (std::size_t i = 1; i < held.size(); ++i) {
        if (held[i]) {
            powers.push_back(static_cast<Power>(i));
        }
    }
    return powers;
}

void paintWay(Canvas& canvas, Vec2 middle, Real size, Color color, bool elegant) {
    const Real width = Real(0.3) * size;
    const Vec2 top = middle + size * Vec2{Real(0.1), Real(0.7)};
    const Vec2 tip = middle + size * Vec2{Real(0.6), Real(-0.75)};
    canvas.line(middle + size * Vec2{Real(-0.7), Real(-0.75)}, top, width, color);
    canvas.line(top, tip, width, color);
    canvas.line(tip, tip + size * Vec2{Real(-0.5), Real(0.3)}, width, color);
    canvas.line(tip, tip + size * Vec2{Real(0.35), Real(0.5)}, width, color);
    if (elegant) {
        canvas.disc(top, Real(0.36) * size, color, color);
    }
}

} // namespace apart
