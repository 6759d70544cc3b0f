// SPDX-License-Identifier: MIT
#include <apart/stage/marks.hpp>

#include <array>

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
    default:
        return;
    }
}

} // namespace apart
