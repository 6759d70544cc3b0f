// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/ghost.hpp>

#include <utility>

namespace apart {

Ghost::Ghost(Replay replay, std::shared_ptr<const Level> level)
    : playback_(std::move(replay), std::move(level)) {}

void Ghost::tick() {
    if (!done()) {
        poses_.remember(game().world());
        playback_.tick();
    }
}

void Ghost::draw(Canvas& canvas, Real share, float opacity) const {
    if (done() || game().result() != Result::Playing) {
        return;
    }
    const kodo::BodyView paddle = game().world()[game().paddle()];
    const kodo::Transform place = poses_.massFrame(paddle, share);
    for (std::size_t part = 0; part < paddle.partCount(); ++part) {
        const std::vector<Vec2> corners = cornersOf(paddle.part(part).convex, place);
        canvas.polygon(corners, faded(palette::kPaddle, 0.5f * opacity));
        canvas.outline(corners, Real(0.06), faded(palette::kText, opacity));
    }
    for (const Ball& ball : game().balls()) {
        const Vec2 center = poses_.massFrame(game().world()[ball.body], share).position;
        canvas.disc(center, kBallRadius, faded(palette::kBall, 0.6f * opacity),
                    faded(palette::kBall, 0.3f * opacity));
        canvas.ring(center, kBallRadius, Real(0.06), faded(palette::kText, opacity));
    }
}

} // namespace apart
