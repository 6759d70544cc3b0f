// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/backdrop.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr Real kDot = Real(0.07); // m

/// Paints a night sky with a glow around one height of the field: rows of rectangles with matching
/// edge colours.
void paintSky(Canvas& canvas, const ThemeLook& look, const Aabb& all) {
    constexpr int kRows = 24;
    const Real step = all.extent().y / kRows;
    const auto colorAt = [&](Real y) {
        const Real distance = std::abs(y - Real(0.58) * kFieldHeight) / Real(11);
        const Real near = std::max(1 - distance * distance, Real(0));
        return mix(look.night, look.dusk, near * near);
    };
    for (int i = 0; i < kRows; ++i) {
        const Real y = all.lower.y + step * static_cast<Real>(i);
        canvas.rectangle({{all.lower.x, y}, {all.upper.x, y + step}}, colorAt(y),
                         colorAt(y + step));
    }
}

void paintFrame(Canvas& canvas, const ThemeLook& look) {
    using namespace layout;
    const Real bottom = canvas.visible().lower.y - 1;
    const Real top = kTop + kFrame;
    const std::array<Aabb, 3> bars = {Aabb{{kLeft - kFrame, bottom}, {kLeft, top}},
                                      Aabb{{kRight, bottom}, {kRight + kFrame, top}},
                                      Aabb{{kLeft, kTop}, {kRight, top}}};
    for (const Aabb& bar : bars) {
        canvas.rectangle(bar, darker(look.frame, 0.55f), look.frame);
    }
    const Color edge = lighter(look.frame, 0.35f);
    canvas.line({kLeft, bottom}, {kLeft, kTop}, Real(0.06), edge);
    canvas.line({kRight, bottom}, {kRight, kTop}, Real(0.06), edge);
    canvas.line({kLeft, kTop}, {kRight, kTop}, Real(0.06), edge);
}

/// Red glow at the bottom, where balls are lost.
void paintAbyss(Canvas& canvas) {
    using namespace layout;
    const Aabb strip{{kLeft, canvas.visible().lower.y - 1}, {kRight, Real(0.75)}};
    canvas.rectangle(strip, faded(palette::kDanger, 0.25f), faded(palette::kDanger, 0));
}

} // namespace

void paintBackdrop(Canvas& canvas, Theme theme, double seconds) {
    using namespace layout;
    const ThemeLook& look = lookOf(theme);
    paintSky(canvas, look, canvas.visible().grown(1)); // margin for the shake
    paintDistance(canvas, theme, seconds);
    const Color dot = faded(palette::kQuiet, 0.10f); // the grid makes speed and distance visible
    for (Real y = Real(1.5); y < kTop; y += Real(1.5)) {
        for (Real x = kLeft + Real(1.5); x < kRight; x += Real(1.5)) {
            canvas.rectangle({{x, y}, {x + kDot, y + kDot}}, dot, dot);
        }
    }
    paintAbyss(canvas);
    paintFrame(canvas, look);
}

void paintPanelBack(Canvas& canvas, Theme theme) {
    const Aabb all = canvas.visible().grown(1);
    const Real left = layout::kRight + Real(0.85);
    paintSky(canvas, lookOf(theme), {{left, all.lower.y}, all.upper});
    const ThemeLook& look = lookOf(theme);
    canvas.rectangle({{left - layout::kFrame, all.lower.y}, {left, all.upper.y}},
                     darker(look.frame, 0.55f), look.frame);
}

void paintVeil(Canvas& canvas, Color color) {
    canvas.rectangle(canvas.visible().grown(1), color, color);
}

} // namespace apart
