// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <array>
#include <cmath>

namespace apart {

namespace {

/// Level files use integers in 1/1000 m.
constexpr Real metres(std::int32_t milli) {
    return static_cast<Real>(milli) / 1000;
}

void paintBumper(Canvas& canvas, Vec2 middle, Real radius, ImpactResponse response) {
    const Color color = lighter(palette::kBumper, 0.7f * response.heat);
    const Real size = radius * (1 + Real(0.15) * length(response.push));
    canvas.setGlow(true);
    canvas.disc(middle, Real(1.8) * size, faded(color, 0.25f + 0.5f * response.heat),
                faded(color, 0));
    canvas.setGlow(false);
    canvas.disc(middle, size, mix(color, palette::kInk, 0.35f), mix(color, palette::kInk, 0.65f));
    canvas.ring(middle, Real(0.9) * size, Real(0.16) * size, color);
    canvas.disc(middle, Real(0.45) * size, lighter(color, 0.5f), color);
}

void paintPeg(Canvas& canvas, Vec2 middle, Real radius, ImpactResponse response) {
    const Color color = lighter(palette::kMachine, 0.6f * response.heat);
    canvas.disc(middle, radius, lighter(color, 0.45f), darker(color, 0.25f));
    canvas.ring(middle, radius, Real(0.05), palette::kInk);
}

void paintMotor(Canvas& canvas, const Moment& moment, const Obstruction& motor) {
    const kodo::BodyView body = moment.game.world()[motor.body];
    const kodo::Transform place = moment.placeOf(motor.body);
    for (std::size_t i = 0; i < body.partCount(); ++i) {
        const std::vector<Vec2> corners = cornersOf(body.part(i).convex, place);
        paintLit(canvas, corners, palette::kMachine,
                 {Real(0.06), lighter(palette::kMachine, 0.4f)});
    }
    const Vec2 hub = place.position;
    canvas.disc(hub, Real(0.3), lighter(palette::kAccent, 0.35f), darker(palette::kAccent, 0.25f));
    const Vec2 along = place.rotation * Vec2{Real(0.21), 0}; // the slot shows the rotation
    canvas.line(hub - along, hub + along, Real(0.1), palette::kInk);
}

/// Chevrons point in the open direction.
void paintGate(Canvas& canvas, const Moment& moment, const Obstruction& gate) {
    const kodo::ConvexShape& line = moment.game.world()[gate.body].part(0).convex;
    const kodo::Transform place = moment.placeOf(gate.body);
    const Vec2 from = place * line.vertices[0];
    const Vec2 to = place * line.vertices[line.vertices.size() - 1];
    const Vec2 along = normalize(to - from);
    const Vec2 open = place.rotation * line.normals[1]; // from back to front
    const float heat = moment.juice.responseOf(gate.body).heat;
    const Color color = lighter(palette::kPaddle, 0.6f * heat);
    canvas.line(from, to, Real(0.16), palette::kInk);
    canvas.line(from, to, Real(0.09), color);
    const Real size = length(to - from);
    const Real flow = moment.time() / 60 - std::floor(moment.time() / 60);
    for (Real way = Real(0.5); way < size; way += Real(0.9)) {
        const Vec2 middle = from + way * along + (Real(0.5) * flow - Real(0.45)) * open;
        const Color faint = faded(color, 0.75f * (1 - flow));
        canvas.line(middle - Real(0.16) * along - Real(0.14) * open, middle, Real(0.07), faint);
        canvas.line(middle + Real(0.16) * along - Real(0.14) * open, middle, Real(0.07), faint);
    }
}

void paintHeights(Canvas& canvas, const ObstructionDef& ground) {
    const Color top = lighter(palette::kGround, 0.35f);
    for (std::size_t i = 0; i + 1 < ground.heights.size(); ++i) {
        const Real left = metres(ground.x) + metres(ground.spacing) * static_cast<Real>(i);
        const Vec2 a{left, metres(ground.y + ground.heights[i])};
        const Vec2 b{left + metres(ground.spacing), metres(ground.y + ground.heights[i + 1])};
        const std::array<Vec2, 4> corners = {Vec2{a.x, metres(ground.y)},
                                             Vec2{b.x, metres(ground.y)}, b, a};
        const Color deep = faded(darker(palette::kGround, 0.5f), 0.55f);
        const std::array<Color, 4> colors = {deep, deep, palette::kGround, palette::kGround};
        canvas.polygon(corners, colors);
        canvas.line(a, b, Real(0.1), top);
    }
}

void paintLedge(Canvas& canvas, const kodo::ConvexShape& outline, const kodo::Transform& place) {
    const std::vector<Vec2> corners = cornersOf(outline, place);
    paintLit(canvas, corners, darker(palette::kGround, 0.1f),
             {Real(0.08), lighter(palette::kGround, 0.35f)});
}

} // namespace

void paintObstructions(Canvas& canvas, const Moment& moment) {
    for (const ObstructionDef& def : moment.game.level().obstructions) {
        if (def.kind == ObstructionKind::Ground) {
            def.points.empty() ? paintHeights(canvas, def) : paintGround(canvas, def);
        }
    }
    for (const Obstruction& thing : moment.game.obstructions()) {
        const kodo::BodyView body = moment.game.world()[thing.body];
        const Vec2 middle = moment.placeOf(thing.body).position;
        const ImpactResponse response = moment.juice.responseOf(thing.body);
        switch (thing.kind) {
        case ObstructionKind::Bumper:
            paintBumper(canvas, middle, body.part(0).convex.radius, response);
            break;
        case ObstructionKind::Pin:
            paintPeg(canvas, middle, body.part(0).convex.radius, response);
            break;
        case ObstructionKind::Motor:
            paintMotor(canvas, moment, thing);
            break;
        case ObstructionKind::Gate:
            paintGate(canvas, moment, thing);
            break;
        case ObstructionKind::Ledge:
            paintLedge(canvas, body.part(0).convex, moment.placeOf(thing.body));
            break;
        case ObstructionKind::Ground:
            break; // drawn from the level
        }
    }
}

} // namespace apart
