// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/block_painter.hpp>
#include <apart/stage/field_painter.hpp>
#include <apart/stage/layout.hpp>
#include <apart/stage/marks.hpp>
#include <apart/stage/palette.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Real kRim = Real(0.06); // m, of outlines

/// From 0 to 1 with a little swing beyond it.
Real swung(Real t) {
    const Real s = std::clamp(t, Real(0), Real(1)) - 1;
    return 1 + s * s * (Real(2.7) * s + Real(1.7));
}

/// Blocks grow row by row when the level begins.
Real scaleOf(const Moment& moment, const kodo::BodyView& body) {
    const Real time = static_cast<Real>(moment.game.ticks()) + moment.share;
    const Real wait =
        Real(2.5) * (kFieldHeight - body.center().y) + Real(0.6) * (body.center().x + 12);
    const Real t = (time - wait) / 28;
    return t >= 1 ? 1 : swung(t);
}

void paintBlocks(Canvas& canvas, const Moment& moment) {
    for (const Block& block : moment.game.blocks()) {
        const kodo::BodyView body = moment.game.world()[block.body];
        const BlockLook look{block.kind.stuff,
                             block.kind.power,
                             scaleOf(moment, body),
                             moment.juice.heatOf(block.body),
                             block.key,
                             moment.juice.cracks().of(block.body)};
        paintBlock(canvas, body.part(0).convex, moment.poses.placement(body, moment.share), look);
    }
}

void paintShards(Canvas& canvas, const Moment& moment) {
    for (const Shard& shard : moment.game.shards()) {
        const kodo::BodyView body = moment.game.world()[shard.body];
        const kodo::Transform place = moment.poses.placement(body, moment.share);
        const std::vector<Vec2> corners = cornersOf(body.part(0).convex, place);
        // The last second of a shard: it fades as it crumbles.
        const auto age = static_cast<float>(moment.game.ticks() - shard.bornTick);
        const float left = std::clamp((static_cast<float>(kShardTicks) - age) / 120, 0.0f, 1.0f);
        const Color color = faded(darker(palette::of(shard.stuff), 0.1f), left);
        paintLit(canvas, corners, color);
        canvas.outline(corners, Real(0.045), faded(lighter(color, 0.45f), 0.6f));
    }
}

void paintPower(Canvas& canvas, std::span<const Vec2> corners, Power power,
                const kodo::Transform& place) {
    const Color color = palette::of(power);
    paintLit(canvas, corners, mix(color, palette::kInk, 0.45f));
    canvas.outline(corners, kRim, color);
    paintMark(canvas, power, place, Real(0.2), lighter(color, 0.35f));
}

/// The middle of a part's outline, in the frame of its corners.
Vec2 middleOf(std::span<const Vec2> corners) {
    return kodo::aabbOf(corners).center();
}

void paintParts(Canvas& canvas, const Moment& moment) {
    for (const Part& part : moment.game.parts()) {
        const kodo::BodyView body = moment.game.world()[part.body];
        const kodo::Transform place = moment.poses.placement(body, moment.share);
        const Color color = palette::of(part.power);
        canvas.setGlow(true);
        canvas.disc(place.position, Real(1.1), faded(color, 0.30f), faded(color, 0));
        canvas.setGlow(false);
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            paintPower(canvas, cornersOf(body.part(i).convex, place), part.power, place);
        }
        if (part.state == PartState::Stuck) { // a ring closes until it fires
            const auto since = static_cast<Real>(moment.game.ticks() - part.sinceTick);
            const Real left =
                std::clamp(1 - since / static_cast<Real>(kStickTicks), Real(0), Real(1));
            canvas.ring(place.position, Real(0.5) + Real(1.3) * left, Real(0.08), color);
        }
    }
}

void paintPaddle(Canvas& canvas, const Moment& moment) {
    const kodo::BodyView body = moment.game.world()[moment.game.paddle()];
    const kodo::Transform place = moment.poses.placement(body, moment.share);
    const float heat = moment.juice.heatOf(moment.game.paddle());
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const std::vector<Vec2> corners = cornersOf(body.part(i).convex, place);
        if (i > 0) {
            paintPower(canvas, corners, Power::Weld, {middleOf(corners), place.rotation});
            continue;
        }
        const Color color = lighter(palette::kPaddle, 0.6f * heat);
        paintLit(canvas, corners, color);
        canvas.outline(corners, kRim, lighter(color, 0.5f));
    }
}

/// Where the served ball will go.
void paintAim(Canvas& canvas, const Moment& moment) {
    if (!moment.game.serving() || moment.game.result() != Result::Playing) {
        return;
    }
    for (const Ball& ball : moment.game.balls()) {
        if (!ball.riding) {
            continue;
        }
        const Vec2 start = moment.poses.center(moment.game.world()[ball.body], moment.share);
        const Real flow = static_cast<Real>(moment.game.ticks() % 40) / 40;
        for (int i = 1; i <= 7; ++i) {
            const Real along = Real(0.55) * (static_cast<Real>(i) + flow);
            const float left = 1 - static_cast<float>(i) / 8;
            const Color color = faded(palette::kAccent, 0.75f * left);
            canvas.disc(start + along * moment.game.serveHeading(), Real(0.09), color, color);
        }
    }
}

void paintTrail(Canvas& canvas, const Moment& moment, const Ball& ball, Vec2 now) {
    const std::span<const Vec2> places = moment.juice.trailOf(ball.body);
    if (ball.riding || places.size() < 2 || moment.juice.effects().trail == 0) {
        return;
    }
    const float strength = share(moment.juice.effects().trail);
    canvas.setGlow(true);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const Vec2 to = i + 1 == places.size() ? now : places[i];
        const Real young = static_cast<Real>(i) / static_cast<Real>(places.size());
        canvas.line(places[i - 1], to, Real(1.7) * kBallRadius * young,
                    faded({255, 190, 110, 255}, 0.42f * strength * young * young));
    }
    canvas.setGlow(false);
}

void paintBalls(Canvas& canvas, const Moment& moment) {
    for (const Ball& ball : moment.game.balls()) {
        const Vec2 center = moment.poses.center(moment.game.world()[ball.body], moment.share);
        paintTrail(canvas, moment, ball, center);
    }
    for (const Ball& ball : moment.game.balls()) {
        const Vec2 center = moment.poses.center(moment.game.world()[ball.body], moment.share);
        canvas.setGlow(true);
        canvas.disc(center, Real(3.2) * kBallRadius, {255, 214, 150, 80}, {255, 214, 150, 0});
        canvas.setGlow(false);
        canvas.disc(center, kBallRadius + kRim, palette::kInk, palette::kInk);
        canvas.disc(center, kBallRadius, palette::kBall, darker(palette::kBall, 0.16f));
        canvas.disc(center + Vec2{Real(-0.09), Real(0.09)}, Real(0.1), {255, 255, 255, 255},
                    {255, 255, 255, 0});
    }
}

void paintPopups(Canvas& canvas, const Moment& moment) {
    for (const Popup& popup : moment.juice.popups()) {
        const float age = static_cast<float>(popup.age) / 90;
        const Vec2 place = popup.place + Vec2{0, Real(1.2) * age};
        const float left = std::clamp(2 - 2 * age, 0.0f, 1.0f);
        const TextStyle style{popup.height, faded(popup.color, left), Typeface::Bold,
                              Align::Middle};
        const TextStyle shadow{popup.height, faded(palette::kInk, 0.8f * left), Typeface::Bold,
                               Align::Middle};
        canvas.text(popup.text, place + Vec2{Real(0.04), Real(-0.04)}, shadow);
        canvas.text(popup.text, place, style);
    }
}

void paintFlash(Canvas& canvas, const Moment& moment) {
    if (moment.juice.flash() < 0.01f) {
        return;
    }
    using namespace layout;
    const Color color = faded(moment.juice.flashColor(), moment.juice.flash());
    canvas.rectangle({{kLeft, -1}, {kRight, kTop}}, color, color);
}

} // namespace

void paintField(Canvas& canvas, const Moment& moment) {
    paintBlocks(canvas, moment);
    paintShards(canvas, moment);
    paintFlash(canvas, moment);
    paintParts(canvas, moment);
    paintPaddle(canvas, moment);
    paintPopups(canvas, moment);
    moment.juice.sparks().draw(canvas);
    paintAim(canvas, moment);
    paintBalls(canvas, moment);
}

} // namespace apart
