// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/backdrop.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace apart {

namespace {

using layout::kLeft;
using layout::kRight;
using layout::kTop;

constexpr Real kSoft = Real(0.035); // m, about one and a half pixels

/// Common arguments of the scenery painters.
struct Far {
    Canvas& canvas;
    Color color; // of the scenery
    Real time;   // s

    Color faint(float share) const { return faded(color, share); }
};

/// Paints a skyline from wall to wall, `height(x)` m above the ground.
template <typename Height>
void paintSkyline(const Far& far, Color color, Real step, Height height) {
    for (Real x = kLeft; x < kRight - Real(0.01); x += step) {
        const Real next = std::min(x + step, kRight);
        const Vec2 left{x, height(x)};
        const Vec2 right{next, height(next)};
        const Color none = faded(color, 0);
        far.canvas.facet(std::array{Vec2{x, 0}, Vec2{next, 0}, right, left},
                         std::array{none, none, color, color});
        const Vec2 soft{0, kSoft}; // antialiasing of the edge against the sky
        far.canvas.facet(std::array{left, right, right + soft, left + soft},
                         std::array{color, color, none, none});
    }
}

void paintRays(const Far& far) {
    const Vec2 sun{0, Real(0.8)};
    const auto reach = [&](Real angle) { // up to the wall
        const Real way =
            std::min(Real(16), kRight / std::max(std::abs(std::cos(angle)), Real(0.1)));
        return sun + way * towards(angle);
    };
    far.canvas.setGlow(true);
    for (int i = 0; i < 18; ++i) {
        const Real angle = kTurn * (static_cast<Real>(i) + Real(0.04) * far.time) / 18;
        const Real half = Real(0.07);
        if (std::sin(angle) <= Real(0.12)) {
            continue;
        }
        // Brightest along its middle, so that its sides are soft.
        const Vec2 end = reach(angle);
        const Color none = far.faint(0);
        const std::array<Color, 3> colors = {far.faint(0.4f), none, none};
        far.canvas.facet(std::array{sun, reach(angle - half), sun + Real(0.3) * (end - sun)},
                         std::array{colors[0], none, far.faint(0.32f)});
        far.canvas.facet(std::array{sun, sun + Real(0.3) * (end - sun), reach(angle + half)},
                         std::array{colors[0], far.faint(0.32f), none});
        far.canvas.facet(
            std::array{sun + Real(0.3) * (end - sun), reach(angle - half), reach(angle + half)},
            std::array{far.faint(0.32f), none, none});
    }
    far.canvas.disc(sun, Real(4.5), far.faint(0.45f), far.faint(0));
    far.canvas.setGlow(false);
}

void paintStrata(const Far& far) {
    for (int layer = 3; layer >= 1; --layer) {
        const auto depth = static_cast<Real>(layer);
        paintSkyline(far, far.faint(0.16f), Real(1.5), [&](Real x) {
            const Real step = std::floor((x + 2 * depth * depth) / 3);
            return Real(2.2) * depth + Real(1.1) * std::abs(std::sin(step * depth * Real(1.7)));
        });
    }
}

void paintWheel(const Far& far) {
    const Vec2 hub{Real(5.5), Real(8.5)};
    const Real radius = 6;
    far.canvas.ring(hub, radius, Real(0.12), far.faint(0.5f));
    far.canvas.ring(hub, Real(0.8) * radius, Real(0.06), far.faint(0.4f));
    for (int i = 0; i < 12; ++i) {
        const Real angle = kTurn * static_cast<Real>(i) / 12 + Real(0.06) * far.time;
        const Vec2 rim = hub + radius * towards(angle);
        far.canvas.line(hub, rim, Real(0.05), far.faint(0.4f));
        far.canvas.disc(rim - Vec2{0, Real(0.3)}, Real(0.42), far.faint(0.8f), far.faint(0.5f));
    }
    far.canvas.line(hub, {hub.x - 3, 0}, Real(0.14), far.faint(0.3f));
    far.canvas.line(hub, {hub.x + 3, 0}, Real(0.14), far.faint(0.3f));
}

void paintWaves(const Far& far) {
    for (int layer = 4; layer >= 1; --layer) {
        const auto depth = static_cast<Real>(layer);
        paintSkyline(far, far.faint(0.15f), Real(0.75), [&](Real x) {
            const Real phase = far.time * (Real(0.5) - Real(0.08) * depth) + Real(2.1) * depth;
            return Real(1.5) * depth + Real(0.35) * std::sin(Real(0.7) * x + phase);
        });
    }
}

void paintGear(const Far& far, Vec2 hub, Real radius, Real angle) {
    const int teeth = std::max(static_cast<int>(radius * 4), 8);
    far.canvas.ring(hub, Real(0.82) * radius, Real(0.28) * radius, far.faint(0.35f));
    far.canvas.ring(hub, Real(0.2) * radius, Real(0.12) * radius, far.faint(0.35f));
    for (int i = 0; i < teeth; ++i) {
        const Real turn = angle + kTurn * static_cast<Real>(i) / static_cast<Real>(teeth);
        const Vec2 out = towards(turn);
        far.canvas.line(hub + Real(0.94) * radius * out, hub + Real(1.1) * radius * out,
                        Real(0.42) * kTurn * radius / static_cast<Real>(teeth), far.faint(0.35f));
    }
    for (int i = 0; i < 5; ++i) {
        const Real turn = angle + kTurn * static_cast<Real>(i) / 5;
        const Vec2 out = towards(turn);
        far.canvas.line(hub + Real(0.25) * radius * out, hub + Real(0.7) * radius * out,
                        Real(0.1) * radius, far.faint(0.3f));
    }
}

void paintGears(const Far& far) {
    const Real turn = Real(0.05) * far.time;
    paintGear(far, {-6, Real(6.5)}, Real(4.4), turn);
    paintGear(far, {Real(1.4), Real(9.9)}, Real(3.2), Real(-1.375) * turn + Real(0.12));
    paintGear(far, {Real(7.6), Real(6.2)}, Real(3.4), Real(1.294) * turn);
}

void paintStars(const Far& far) {
    Dice dice(11);
    for (int i = 0; i < 90; ++i) {
        const Vec2 place{dice.between(kLeft, kRight), dice.between(Real(0.5), kTop)};
        const float twinkle =
            0.55f + 0.45f * std::sin(far.time * dice.between(0.4f, 1.2f) + dice.between(0, kTurn));
        const Color color = faded(lighter(far.color, 0.5f), 0.7f * twinkle);
        const Real size = dice.between(Real(0.025), Real(0.06));
        far.canvas.rectangle({place, place + Vec2{size, size}}, color, color);
    }
    const Vec2 middle{0, Real(9.5)};
    for (int i = 1; i <= 3; ++i) {
        const Real radius = Real(2.7) * static_cast<Real>(i);
        const Real angle = far.time * Real(0.14) / static_cast<Real>(i) + static_cast<Real>(2 * i);
        far.canvas.ring(middle, radius, Real(0.05), far.faint(0.4f));
        far.canvas.disc(middle + radius * towards(angle), Real(0.3), far.faint(1), far.faint(0.5f));
    }
}

void paintBattlements(const Far& far) {
    constexpr Real kMerlon = Real(0.5);
    for (int layer = 2; layer >= 1; --layer) {
        const auto depth = static_cast<Real>(layer);
        const Color color = far.faint(0.28f);
        for (Real x = kLeft; x < kRight; x += kMerlon) {
            const Real along = std::abs(std::fmod(x + 40 + 3 * depth, Real(8)) - 4);
            const Real tower = along < Real(1.25) ? Real(2.3) : 0;
            const Real merlon = std::fmod(x + 40, 2 * kMerlon) < kMerlon ? Real(0.4) : 0;
            far.canvas.rectangle({{x, 0}, {x + kMerlon, Real(2.4) * depth + tower + merlon}},
                                 faded(color, 0), color);
        }
    }
}

} // namespace

void paintDistance(Canvas& canvas, Theme theme, double seconds) {
    const Far far{canvas, lookOf(theme).distant, static_cast<Real>(std::fmod(seconds, 36000))};
    switch (theme) {
    case Theme::Daybreak:
        return paintRays(far);
    case Theme::Quarry:
        return paintStrata(far);
    case Theme::Fairground:
        return paintWheel(far);
    case Theme::Harbour:
        return paintWaves(far);
    case Theme::Clockwork:
        return paintGears(far);
    case Theme::Observatory:
        return paintStars(far);
    case Theme::Fortress:
        return paintBattlements(far);
    }
}

} // namespace apart
