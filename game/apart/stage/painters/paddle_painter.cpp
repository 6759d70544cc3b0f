// SPDX-License-Identifier: MIT
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Real kRim = Real(0.06); // m, of outlines
constexpr Real kDip = Real(0.14); // m, displacement of the paddle at the strongest impact

void paintPower(Canvas& canvas, std::span<const Vec2> corners, Power power,
                const kodo::Transform& place) {
    const Color color = canvas.palette().of(power);
    paintLit(canvas, corners, mix(color, palette::kInk, 0.45f), {kRim, color});
    paintMark(canvas, power, place, Real(0.2), lighter(color, 0.35f));
}

/// Paints a ring that closes until a stuck part fires.
void paintCountdown(Canvas& canvas, const Moment& moment, const Part& part, Vec2 middle) {
    const auto since = static_cast<Real>(moment.game.ticks() - part.sinceTick);
    const Real left = std::clamp(1 - since / static_cast<Real>(kStickTicks), Real(0), Real(1));
    canvas.ring(middle, Real(0.5) + Real(1.3) * left, Real(0.08), canvas.palette().of(part.power));
}

/// Position of the lowest ball, which the paddle's eyes follow.
Vec2 watched(const Moment& moment, Vec2 otherwise) {
    Vec2 lowest = otherwise;
    for (const Ball& ball : moment.game.balls()) {
        const Vec2 place = moment.placeOf(ball.body).position;
        lowest = place.y < lowest.y ? place : lowest;
    }
    return lowest;
}

void paintEyes(Canvas& canvas, const Moment& moment, const kodo::Transform& place) {
    const Vec2 goal = watched(moment, place * Vec2{0, 20});
    const bool blink = moment.game.ticks() % 500 < 10;
    for (const Real side : {Real(-0.42), Real(0.42)}) {
        const Vec2 eye = place * Vec2{side, Real(0.12)};
        if (blink) {
            canvas.line(eye - Vec2{Real(0.15), 0}, eye + Vec2{Real(0.15), 0}, Real(0.06),
                        palette::kInk);
            continue;
        }
        const Vec2 way = goal - eye;
        const Vec2 look = way / std::max(length(way), Real(0.1));
        canvas.disc(eye, Real(0.17), palette::kText, palette::kText);
        canvas.disc(eye + Real(0.07) * look, Real(0.09), palette::kInk, palette::kInk);
    }
}

/// Paints the powers that act on the paddle.
void paintWorking(Canvas& canvas, const Moment& moment, const kodo::Transform& place) {
    if (moment.game.state().secondsLeft(Power::Magnet) > 0) {
        const Real beat = Real(0.5) + Real(0.5) * std::sin(Real(0.1) * moment.time());
        canvas.setGlow(true);
        canvas.disc(place.position, Real(3.2),
                    faded(canvas.palette().of(Power::Magnet), 0.2f + 0.2f * beat),
                    faded(canvas.palette().of(Power::Magnet), 0));
        canvas.setGlow(false);
    }
    if (moment.game.state().secondsLeft(Power::Spring) > 0) {
        for (const Real side : {Real(-1), Real(1)}) {
            const kodo::Transform foot{place * Vec2{side, Real(-0.6)}, place.rotation};
            paintMark(canvas, Power::Spring, foot, Real(0.25), canvas.palette().of(Power::Spring));
        }
    }
}

} // namespace

void paintParts(Canvas& canvas, const Moment& moment) {
    for (const Part& part : moment.game.parts()) {
        const kodo::BodyView body = moment.game.world()[part.body];
        const kodo::Transform place = moment.placeOf(part.body);
        const Color color = canvas.palette().of(part.power);
        canvas.setGlow(true);
        canvas.disc(place.position, Real(1.1), faded(color, 0.30f), faded(color, 0));
        canvas.setGlow(false);
        if (part.state == PartState::Loose) {
            paintMood(canvas, moodOf(part.power), place.position,
                      {Real(0.62), faded(palette::kInk, 0.35f), faded(color, 0.7f), Real(0.05)});
        }
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            paintPower(canvas, cornersOf(body.part(i).convex, place), part.power, place);
        }
        if (part.state == PartState::Stuck) {
            paintCountdown(canvas, moment, part, place.position);
        }
    }
}

void paintPaddle(Canvas& canvas, const Moment& moment) {
    const kodo::BodyView body = moment.game.world()[moment.game.paddle()];
    kodo::Transform place = moment.placeOf(moment.game.paddle());
    const ImpactResponse response = moment.juice.responseOf(moment.game.paddle());
    place.position += Vec2{0, kDip * response.push.y};
    paintWorking(canvas, moment, place);
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const kodo::ConvexShape& outline = body.part(i).convex;
        const std::vector<Vec2> corners = cornersOf(outline, place);
        if (i > 0) {
            const bool wing = moment.game.welds()[i - 1].wing;
            paintPower(canvas, corners, wing ? Power::Wings : Power::Weld,
                       {place * outline.middle, place.rotation});
            continue;
        }
        const Color color = lighter(palette::kPaddle, 0.6f * response.heat);
        paintLit(canvas, corners, color, {kRim, lighter(color, 0.5f)});
        paintEyes(canvas, moment, {place * outline.middle, place.rotation});
    }
}

} // namespace apart
