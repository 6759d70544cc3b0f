// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace apart {

namespace {

struct Ink {
    Real width = 0; // m
    Color color{};
};

/// Sawtooth 0..1 with a period of `ticks`.
Real cycle(Real time, Real ticks) {
    return time / ticks - std::floor(time / ticks);
}

/// Rises from 0 to 1 and back while t goes from 0 to 1.
float swell(Real t) {
    return std::sin(kTurn / 2 * t);
}

/// Paints streaks that move at the wind speed.
void paintWind(Canvas& canvas, const Moment& moment) {
    const Real speed = moment.game.state().windSpeed();
    if (speed == 0) {
        return;
    }
    const Color color = faded(canvas.palette().of(Power::Wind), 0.22f);
    Dice dice(3);
    for (int i = 0; i < 40; ++i) {
        const Real y = dice.between(1, kFieldHeight - Real(0.5));
        const Real own = dice.between(Real(0.7), Real(1.3));
        const Real way = moment.time() * kTickSeconds * speed * own + dice.between(0, kFieldWidth);
        const Real x = way - kFieldWidth * std::floor(way / kFieldWidth) + layout::kLeft;
        const Real size = std::min(Real(0.25) * std::abs(speed) * own, Real(2));
        const Vec2 tip{x, y};
        const Vec2 tail{std::clamp(x - (speed > 0 ? size : -size), layout::kLeft, layout::kRight),
                        y};
        canvas.line(tail, tip, Real(0.05), color);
    }
}

/// Arc of a circle, from an angle through a turn (rad).
struct Arc {
    Vec2 middle;
    Real radius = 0;
    Real from = 0;
    Real turn = kTurn;
};

/// Paints the parts of an arc inside the field.
void paintArc(Canvas& canvas, const Arc& arc, const Ink& ink) {
    constexpr int kPieces = 32; // per full circle
    const Real pieces = std::ceil(kPieces * arc.turn / kTurn);
    std::vector<Vec2> run;
    const auto finish = [&] {
        if (run.size() > 1) {
            canvas.ribbon(run, ink.width, ink.color);
        }
        run.clear();
    };
    for (Real i = 0; i <= pieces; ++i) {
        const Real angle = arc.from + arc.turn * i / pieces;
        const Vec2 here = arc.middle + arc.radius * towards(angle);
        if (std::abs(here.x) < layout::kRight && here.y < layout::kTop) {
            run.push_back(here);
        } else {
            finish();
        }
    }
    finish();
}

/// Paints rings that contract into a well, or expand if it repels.
void paintWell(Canvas& canvas, const Moment& moment, Vec2 middle, bool draws) {
    const Color color = canvas.palette().of(Power::Well);
    canvas.setGlow(true);
    const Real room = std::min(layout::kRight - std::abs(middle.x), layout::kTop - middle.y);
    canvas.disc(middle, std::min(Real(2.6), room), faded(color, 0.35f), faded(color, 0));
    for (int i = 0; i < 3; ++i) {
        const Real t = cycle(moment.time() + Real(30) * static_cast<Real>(i), 90);
        const Real share = draws ? 1 - t : t;
        paintArc(canvas, {middle, Real(0.3) + Real(2.2) * share},
                 {Real(0.06), faded(color, 0.7f * swell(t))});
    }
    canvas.setGlow(false);
    canvas.disc(middle, Real(0.3), palette::kInk, palette::kInk);
    canvas.ring(middle, Real(0.3), Real(0.07), color);
}

/// Paints arcs above the paddle that contract (pull) or expand (push).
void paintPaddleField(Canvas& canvas, const Moment& moment) {
    const Force force = moment.game.force();
    if (force == Force::None) {
        return;
    }
    const Vec2 middle = moment.placeOf(moment.game.paddle()).position;
    const Color color = force == Force::Pull ? palette::kPaddle : palette::kAccent;
    constexpr int kArcs = 5;
    constexpr Real kSpan = Real(1.74); // rad, centred on straight up
    canvas.setGlow(true);
    for (int arc = 0; arc < kArcs; ++arc) {
        const Real t = cycle(moment.time() + Real(12) * static_cast<Real>(arc), 60);
        const Real radius = Real(1.6) + 6 * (force == Force::Pull ? 1 - t : t);
        paintArc(canvas, {middle, radius, (kTurn / 2 - kSpan) / 2, kSpan},
                 {Real(0.1), faded(color, 0.55f * swell(t))});
    }
    canvas.setGlow(false);
}

/// Paints beads from the block whose mount is being torn to the paddle. They brighten with the
/// progress of tearing.
void paintTear(Canvas& canvas, const Moment& moment) {
    if (!moment.game.state().tears()) {
        return;
    }
    const Block* next = moment.game.state().nextToFall();
    const kodo::BodyView body = moment.game.world()[next->body];
    const Vec2 from = moment.placeOf(next->body) * body.part(next->part).convex.middle;
    const Vec2 to = moment.placeOf(moment.game.paddle()).position;
    const auto torn = static_cast<float>(moment.game.state().tornShare());
    constexpr int kBeads = 14;
    canvas.setGlow(true);
    for (int i = 0; i < kBeads; ++i) {
        const Real t = cycle(moment.time() + Real(40) * static_cast<Real>(i) / kBeads, 40);
        const Real share = (static_cast<Real>(i) + t) / kBeads;
        const Color color = faded(palette::kPaddle, 0.4f + 0.6f * torn);
        canvas.disc(from + share * (to - from), Real(0.16), color, faded(color, 0));
    }
    canvas.setGlow(false);
}

} // namespace

void paintForces(Canvas& canvas, const Moment& moment) {
    paintWind(canvas, moment);
    for (const WellDef& well : moment.game.level().wells) {
        const Vec2 place{static_cast<Real>(well.x) / 1000, static_cast<Real>(well.y) / 1000};
        paintWell(canvas, moment, place, well.strength > 0);
    }
    for (const Effect& effect : moment.game.effects()) {
        if (effect.power == Power::Well) {
            paintWell(canvas, moment, effect.place, true);
        }
    }
    paintPaddleField(canvas, moment);
    paintTear(canvas, moment);
}

} // namespace apart
