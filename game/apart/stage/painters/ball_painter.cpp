// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

constexpr Real kRim = Real(0.06);         // m, of the outline
constexpr Real kMostSquash = Real(0.32);  // relative, at the strongest impact
constexpr Real kMostStretch = Real(0.14); // relative, at full speed

/// Compression along one axis, with expansion across it.
struct Squash {
    Vec2 middle;
    Vec2 axis{0, 1}; // unit
    Real amount = 0; // negative: stretch along the axis

    Vec2 operator()(Vec2 point) const {
        const Vec2 arm = point - middle;
        const Real along = dot(arm, axis);
        return middle + (1 + Real(0.6) * amount) * arm - Real(1.6) * amount * along * axis;
    }
};

Squash squashOf(const Moment& moment, const Ball& ball, Vec2 middle) {
    const ImpactResponse response = moment.juice.responseOf(ball.body);
    const Real push = length(response.push);
    if (push > Real(0.05)) {
        return {middle, response.push / push, kMostSquash * push};
    }
    const Vec2 velocity = moment.game.world()[ball.body].velocity();
    const Real speed = length(velocity);
    if (ball.riding || speed < 1) {
        return {middle, {0, 1}, 0};
    }
    const Real share_ = std::min(speed / 20, Real(1)) * share(moment.juice.settings().squash);
    return {middle, velocity / speed, -kMostStretch * share_};
}

Color colorOf(BallKind kind) {
    constexpr std::array<Color, kBallKindNames.size()> kColors = {
        palette::kBall, Color{196, 208, 226}, Color{255, 226, 208}, Color{255, 240, 206},
        Color{232, 206, 164}};
    return kColors[static_cast<std::size_t>(kind)];
}

/// Paints the marking of a kind of ball, which also shows its rotation.
void paintKind(Canvas& canvas, BallKind kind, const kodo::Transform& place, const Squash& squash) {
    const Color ink = faded(palette::kInk, 0.8f);
    switch (kind) {
    case BallKind::Round:
    case BallKind::Egg:
        return;
    case BallKind::Heavy:
        canvas.ring(place.position, Real(0.6) * kBallRadius, Real(0.07), ink);
        return canvas.disc(place.position, Real(0.25) * kBallRadius, ink, ink);
    case BallKind::Lopsided:
        return canvas.disc(squash(place * Vec2{Real(0.45) * kBallRadius, 0}),
                           Real(0.45) * kBallRadius, ink, ink);
    case BallKind::Rough:
        for (int i = 0; i < 6; ++i) {
            const Real angle = kTurn * static_cast<Real>(i) / 6;
            const Vec2 spot = Real(0.62) * kBallRadius * towards(angle);
            canvas.disc(squash(place * spot), Real(0.055), ink, ink);
        }
        return;
    }
}

void paintTrail(Canvas& canvas, const Moment& moment, const Ball& ball, Vec2 now) {
    const std::span<const Vec2> places = moment.juice.trailOf(ball.body);
    const float strength = share(moment.juice.settings().trail);
    if (ball.riding || places.size() < 2 || strength == 0) {
        return;
    }
    std::vector<Vec2> points(places.begin(), places.end());
    points.back() = now;
    std::vector<Real> widths;
    std::vector<Color> colors;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Real young = static_cast<Real>(i) / static_cast<Real>(points.size());
        widths.push_back(Real(1.7) * kBallRadius * young);
        colors.push_back(faded({255, 190, 110, 255}, 0.42f * strength * young * young));
    }
    canvas.setGlow(true);
    canvas.ribbon(points, widths, colors);
    canvas.setGlow(false);
}

void paintBall(Canvas& canvas, const Moment& moment, const Ball& ball) {
    const kodo::Transform place = moment.placeOf(ball.body);
    const Vec2 center = place.position;
    const BallKind kind = moment.game.state().ballKind();
    const Squash squash = squashOf(moment, ball, center);
    canvas.setGlow(true);
    canvas.disc(center, Real(3.2) * kBallRadius, {255, 214, 150, 80}, {255, 214, 150, 0});
    canvas.setGlow(false);
    std::vector<Vec2> body = cornersOf(moment.game.world()[ball.body].part(0).convex, place);
    for (Vec2& corner : body) {
        corner = squash(corner);
    }
    canvas.outline(body, 2 * kRim, palette::kInk); // half of the width lies under the body
    const Color color = colorOf(kind);
    const Aabb box = kodo::aabbOf(std::span<const Vec2>(body));
    std::vector<Color> colors;
    for (const Vec2 corner : body) {
        const Real up = (corner.y - box.lower.y) / box.extent().y;
        colors.push_back(mix(darker(color, 0.2f), color, up));
    }
    canvas.polygon(body, colors);
    if (ball.hollow) {
        canvas.disc(squash(center), Real(0.62) * kBallRadius, palette::kInk, palette::kInk);
    }
    paintKind(canvas, kind, place, squash);
    canvas.disc(center + Vec2{Real(-0.09), Real(0.09)}, Real(0.1), {255, 255, 255, 255},
                {255, 255, 255, 0});
}

} // namespace

void paintBalls(Canvas& canvas, const Moment& moment) {
    for (const Ball& ball : moment.game.balls()) {
        paintTrail(canvas, moment, ball, moment.placeOf(ball.body).position);
    }
    for (const Ball& ball : moment.game.balls()) {
        paintBall(canvas, moment, ball);
    }
}

} // namespace apart
