// SPDX-License-Identifier: MIT
#include <apart/core/flight.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace apart {

namespace {

constexpr Real kShardShare = Real(0.88); // of its size, at which a shard is drawn
constexpr Real kNudge = Real(0.09);      // m, displacement of a block at the strongest impact

/// Eases from 0 to 1 with a slight overshoot.
Real swung(Real t) {
    const Real s = std::clamp(t, Real(0), Real(1)) - 1;
    return 1 + s * s * (Real(2.7) * s + Real(1.7));
}

/// Blocks grow row by row at the start of the level.
Real scaleOf(const Moment& moment, Vec2 middle) {
    const Real wait = Real(2.5) * (kFieldHeight - middle.y) + Real(0.6) * (middle.x + 12);
    const Real t = (moment.time() - wait) / 28;
    return t >= 1 || moment.game.ticks() > 240 ? 1 : swung(t);
}

/// The stage of a long time without damage. With a hollow ball nothing falls by it.
Patience patienceOf(const Moment& moment) {
    const GameState& state = moment.game.state();
    return state.armed() ? state.patience() : Patience::Calm;
}

/// Brightness of a breakable block after a long time without damage.
Real glowOf(const Moment& moment, const Block& block) {
    if (patienceOf(moment) == Patience::Calm || !block.kind.breakable()) {
        return 0;
    }
    return Real(0.5) + Real(0.5) * std::sin(Real(0.06) * moment.time());
}

/// Shakes the mount that gives way next. The amplitude grows from "can be pulled off" to "about to
/// fall", and with the progress of tearing.
Vec2 shakeOf(const Moment& moment, const Block& block) {
    const Block* next = moment.game.state().nextToFall();
    const Patience patience = patienceOf(moment);
    if (patience == Patience::Calm || next == nullptr || next->key != block.key) {
        return {};
    }
    const Real size = patience == Patience::Glowing ? Real(0.025) : Real(0.05);
    return (size + Real(0.05) * moment.game.state().tornShare()) *
           Vec2{std::sin(Real(1.1) * moment.time()), std::sin(Real(1.7) * moment.time())};
}

void paintRope(Canvas& canvas, const Moment& moment, const Block& block, Vec2 middle) {
    if (block.support != Support::Hanging || !moment.game.world().contains(block.pin) ||
        !isBuilt(moment, middle)) {
        return;
    }
    const Vec2 pin = moment.placeOf(block.pin).position;
    canvas.line(pin, middle, Real(0.06), faded(palette::kMachine, 0.8f));
    canvas.disc(pin, Real(0.14), lighter(palette::kMachine, 0.4f),
                darker(palette::kMachine, 0.35f));
}

/// Falling ones, or those in their place.
void paintBlocks(Canvas& canvas, const Moment& moment, bool falling) {
    for (const Block& block : moment.game.blocks()) {
        const bool falls = block.support == Support::Fallen || block.support == Support::Loose;
        if (falls != falling) {
            continue;
        }
        const kodo::BodyView body = moment.game.world()[block.body];
        kodo::Transform place = moment.placeOf(block.body);
        const ImpactResponse response = moment.juice.responseOf(block.body);
        const ImpactResponse own = moment.juice.responseOfBlock(block.key);
        place.position += kNudge * response.push + shakeOf(moment, block);
        const Vec2 middle = place * body.part(block.part).convex.middle;
        paintRope(canvas, moment, block, middle);
        const bool fallen = block.support == Support::Fallen;
        const auto age = static_cast<float>(moment.game.ticks() - block.looseTick);
        const BlockLook look{block.kind,
                             scaleOf(moment, middle),
                             std::max(block.support == Support::Boss ? 0 : response.heat, own.heat),
                             glowOf(moment, block),
                             block.key,
                             moment.juice.cracks().of(block.key),
                             fallen,
                             fallen ? std::clamp((kFallenTicks - age) / 60, 0.3f, 1.0f) : 1.0f};
        const std::size_t first = block.ownsBody() ? 0 : block.part;
        const std::size_t last = block.ownsBody() ? body.partCount() : block.part + 1;
        for (std::size_t part = first; part < last; ++part) {
            paintBlock(canvas, body.part(part).convex, place, look);
        }
    }
}

/// Marks the places at the bottom above which a heavy block comes down.
void paintWarnings(Canvas& canvas, const Moment& moment) {
    constexpr Real kHeavy = Real(0.7); // kg
    constexpr Real kFast = 2;          // m/s
    constexpr Real kSeen = 12;         // m; height from which on the mark shows
    for (const Block& block : moment.game.blocks()) {
        const kodo::BodyView body = moment.game.world()[block.body];
        const bool loose = block.support == Support::Fallen || block.support == Support::Moving;
        const Real height = body.center().y - kPaddleY;
        if (!loose || body.mass() < kHeavy || body.velocity().y > -kFast || height < 0) {
            continue;
        }
        const float near = std::clamp(1 - height / kSeen, Real(0), Real(1));
        const Aabb bounds = body.bounds();
        const Color color = faded(palette::kAccent, 0.8f * near);
        canvas.rectangle({{bounds.lower.x, Real(0.05)}, {bounds.upper.x, Real(0.2)}}, color, color);
    }
}

void paintShards(Canvas& canvas, const Moment& moment) {
    for (const Shard& shard : moment.game.shards()) {
        const kodo::BodyView body = moment.game.world()[shard.body];
        std::vector<Vec2> corners = cornersOf(body.part(0).convex, moment.placeOf(shard.body));
        const Vec2 middle = moment.placeOf(shard.body) * body.part(0).convex.middle;
        for (Vec2& corner : corners) { // so that cracks gape from the first picture on
            corner = middle + kShardShare * (corner - middle);
        }
        // Shards fade during their last second.
        const auto age = static_cast<float>(moment.game.ticks() - shard.bornTick);
        const float left = std::clamp((static_cast<float>(kShardTicks) - age) / 120, 0.0f, 1.0f);
        const Color own = darker(canvas.palette().of(shard.stuff), 0.1f);
        // New ones are white hot.
        const float hot = std::max(1 - age / Glint::kTicks, 0.0f) * moment.juice.flashes().punch();
        const Color color = faded(lighter(own, hot), left);
        paintLit(canvas, corners, color, {Real(0.032), faded(lighter(color, 0.45f), 0.75f)});
    }
}

/// Paints the path of the serve, with the ball at its end.
void paintAim(Canvas& canvas, const Moment& moment) {
    if (!moment.game.serving() || moment.game.result() != Result::Playing) {
        return;
    }
    constexpr Real kGap = Real(0.55); // m, between two dots
    const std::vector<Vec2> leg = servePath(moment.game);
    Real next = kGap * (1 + static_cast<Real>(moment.game.ticks() % 40) / 40); // m, along the leg
    Real walked = 0;
    for (std::size_t i = 1; i < leg.size(); ++i) {
        const Real length = kodo::length(leg[i] - leg[i - 1]);
        for (; next < walked + length; next += kGap) {
            const Vec2 dot = leg[i - 1] + (next - walked) / length * (leg[i] - leg[i - 1]);
            const Color color = faded(palette::kAccent, 0.75f);
            canvas.disc(dot, Real(0.08), color, color);
        }
        walked += length;
    }
    if (!leg.empty()) {
        canvas.ring(leg.back(), Real(0.9) * kBallRadius, Real(0.06), faded(palette::kAccent, 0.9f));
    }
}

void paintPopups(Canvas& canvas, const Moment& moment) {
    if (!moment.words) {
        return;
    }
    for (const Popup& popup : moment.juice.popups()) {
        const Vec2 place = popup.placeIn(moment.shown);
        const float left = popup.left();
        const Typeface face = popup.height >= kTitlePopup ? Typeface::Display : Typeface::Bold;
        const TextStyle style{popup.height, faded(popup.color, left), face, Align::Middle};
        const TextStyle shadow{popup.height, faded(palette::kInk, 0.8f * left), face,
                               Align::Middle};
        canvas.text(popup.text, place + Vec2{Real(0.04), Real(-0.04)}, shadow);
        canvas.text(popup.text, place, style);
    }
}

/// Flashes at the points of fractures.
void paintGlints(Canvas& canvas, const Moment& moment) {
    canvas.setGlow(true);
    for (const Glint& glint : moment.juice.flashes().glints()) {
        const float light =
            glint.left() * moment.juice.flashes().punch() * (0.35f + 0.65f * glint.weight);
        const Real radius = Real(0.7) + Real(1.3) * glint.weight;
        const Color color{255, 244, 224, 255};
        canvas.disc(glint.point, radius, faded(color, 0.8f * light), faded(color, 0));
        const Real reach = radius * (Real(1.7) - Real(0.6) * glint.left());
        canvas.ring(glint.point, reach, Real(0.1), faded(color, 0.5f * light));
    }
    canvas.setGlow(false);
}

void paintFlash(Canvas& canvas, const Moment& moment) {
    if (moment.juice.flashes().field() < 0.01f) {
        return;
    }
    using namespace layout;
    // A rim: a sheet over the field would change the colours of all in it.
    constexpr Real kDepth = Real(2.2); // m
    const Color color = faded(moment.juice.flashes().color(), moment.juice.flashes().field());
    const Color none = faded(color, 0);
    const std::array<Vec2, 4> outer = {
        Vec2{kLeft, -1}, {kRight, -1}, {kRight, kTop}, {kLeft, kTop}};
    const Vec2 middle{(kLeft + kRight) / 2, (kTop - 1) / 2};
    const Vec2 share{1 - 2 * kDepth / (kRight - kLeft), 1 - 2 * kDepth / (kTop + 1)};
    const auto inner = [&](std::size_t i) {
        const Vec2 way = outer[i] - middle;
        return middle + Vec2{share.x * way.x, share.y * way.y};
    };
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const std::size_t next = (i + 1) % outer.size();
        canvas.facet(std::array{outer[i], outer[next], inner(next), inner(i)},
                     std::array{color, color, none, none});
    }
}

} // namespace

bool isBuilt(const Moment& moment, Vec2 place) {
    return scaleOf(moment, place) >= Real(0.8);
}

void paintField(Canvas& canvas, const Moment& moment) {
    paintForces(canvas, moment);
    paintWaterBehind(canvas, moment);
    paintMounts(canvas, moment);
    canvas.setDisjoint(true);
    paintBlocks(canvas, moment, false);
    paintLinks(canvas, moment);
    paintObstructions(canvas, moment);
    canvas.setDisjoint(false);
    paintPopups(canvas, moment); // below all that breaks or falls
    moment.juice.debris().drawDust(canvas);
    canvas.setDisjoint(true);
    paintBlocks(canvas, moment, true);
    paintShards(canvas, moment);
    canvas.setDisjoint(false);
    paintWaterBefore(canvas, moment);
    moment.juice.debris().drawChips(canvas);
    paintGlints(canvas, moment);
    paintWarnings(canvas, moment);
    paintFlash(canvas, moment);
    paintParts(canvas, moment);
    paintPaddle(canvas, moment);
    moment.juice.sparks().draw(canvas);
    paintAim(canvas, moment);
    paintBalls(canvas, moment);
}

} // namespace apart
