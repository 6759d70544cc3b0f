// SPDX-License-Identifier: MIT
#include <apart/core/field.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/level_preview.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace apart {

namespace {

constexpr Real kScaleOfMarks = Real(0.2); // below this scale a power is a dot in its colour
constexpr Color kRope{222, 196, 150};

constexpr Real metres(std::int32_t thousandths) {
    return static_cast<Real>(thousandths) / 1000;
}

/// Maps the field to the rectangle of the preview.
struct Mapping {
    Vec2 corner; // of the upper left corner of the field
    Real scale = 1;

    Vec2 at(Vec2 place) const {
        return corner + scale * (place - Vec2{-kFieldWidth / 2, kFieldHeight});
    }
    /// The nearest point of the field.
    Vec2 held(Vec2 place) const {
        return {std::clamp(place.x, -kFieldWidth / 2, kFieldWidth / 2),
                std::clamp(place.y, Real(0), kFieldHeight)};
    }
};

void paintShape(Canvas& canvas, const Mapping& mapping, const PlacedShape& placed, Color color) {
    constexpr Real kShare = Real(0.93); // leaves a gap between blocks
    for (const kodo::Polygon& polygon : polygonsOf(placed.shape)) {
        const Vec2 middle = massOf(polygon, Real(1)).center;
        std::vector<Vec2> corners;
        for (const Vec2 corner : polygon.corners) {
            corners.push_back(mapping.at(placed.frame * (middle + kShare * (corner - middle))));
        }
        canvas.polygon(corners, color);
    }
}

void paintBumper(Canvas& canvas, Vec2 place, Real size) {
    canvas.disc(place, size, palette::kBumper, palette::kBumper);
    canvas.disc(place, Real(0.5) * size, lighter(palette::kBumper, 0.7f),
                lighter(palette::kBumper, 0.7f));
}

void paintGround(Canvas& canvas, const Mapping& mapping, const ObstructionDef& def) {
    if (!def.points.empty()) {
        for (const kodo::Polygon& piece : polygonsOf(solidOf(def))) {
            std::vector<Vec2> corners;
            std::transform(piece.corners.begin(), piece.corners.end(), std::back_inserter(corners),
                           [&](Vec2 corner) { return mapping.at(mapping.held(corner)); });
            canvas.polygon(corners, palette::kTurf[static_cast<std::size_t>(def.turf)]);
        }
        return;
    }
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < def.heights.size(); ++i) {
        const Real x = metres(def.x) + metres(def.spacing) * static_cast<Real>(i);
        const Real y = std::max(metres(def.y + def.heights[i]), Real(0));
        points.push_back(mapping.at({std::clamp(x, -kFieldWidth / 2, kFieldWidth / 2), y}));
    }
    canvas.ribbon(points, Real(0.05), palette::kGround);
}

void paintObstruction(Canvas& canvas, const Mapping& mapping, const ObstructionDef& def) {
    const Vec2 place = mapping.at({metres(def.x), metres(def.y)});
    const Real size = mapping.scale * metres(def.size);
    const Vec2 half{size / 2, 0};
    switch (def.kind) {
    case ObstructionKind::Bumper:
        return paintBumper(canvas, place, size);
    case ObstructionKind::Pin:
        return canvas.disc(place, size, palette::kMachine, palette::kMachine);
    case ObstructionKind::Motor:
        canvas.line(place - half, place + half, Real(0.05), palette::kMachine);
        return canvas.disc(place, Real(0.06), palette::kAccent, palette::kAccent);
    case ObstructionKind::Gate: {
        const bool lies = def.facing == Facing::Up || def.facing == Facing::Down;
        const Vec2 way = lies ? half : Vec2{0, size / 2};
        const bool back = def.facing == Facing::Down || def.facing == Facing::Left;
        const Vec2 tick = (back ? Real(-0.12) : Real(0.12)) * (lies ? Vec2{0, 1} : Vec2{1, 0});
        canvas.line(place - way, place + way, Real(0.04), palette::kPaddle);
        return canvas.line(place, place + tick, Real(0.04), palette::kPaddle);
    }
    case ObstructionKind::Ground:
        return paintGround(canvas, mapping, def);
    case ObstructionKind::Ledge: {
        const kodo::BodyDef body = obstructionDef(def);
        return paintShape(canvas, mapping, {body.shape, {body.position, body.rotation}},
                          lighter(palette::kGround, 0.2f));
    }
    }
}

/// What a block holds or hangs from, above its shape.
void paintDetails(Canvas& canvas, const Mapping& mapping, const BlockKind& kind, Vec2 middle) {
    const Vec2 place = mapping.at(middle);
    if (kind.support == Support::Hanging) {
        const Vec2 pin = mapping.at(middle + Vec2{0, metres(kind.arm)});
        canvas.line(place, pin, Real(0.03), palette::kMachine);
        canvas.disc(pin, Real(0.04), palette::kMachine, palette::kMachine);
    }
    if (kind.core) {
        canvas.disc(place, mapping.scale * Real(0.4), palette::kDanger, palette::kDanger);
    }
    if (kind.power != Power::None) {
        const Color color = canvas.palette().of(kind.power);
        canvas.disc(place, std::max(mapping.scale * Real(0.34), Real(0.05)), palette::kInk,
                    palette::kInk);
        if (mapping.scale > kScaleOfMarks) {
            paintMark(canvas, kind.power, {place, {}}, mapping.scale * Real(0.26), color);
        } else {
            canvas.disc(place, std::max(mapping.scale * Real(0.26), Real(0.035)), color, color);
        }
    }
}

void paintSpring(Canvas& canvas, Vec2 from, Vec2 to) {
    constexpr std::size_t kCoils = 10;
    const Vec2 side = Real(0.06) * normalize(perp(to - from));
    std::array<Vec2, kCoils + 1> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool end = i == 0 || i == kCoils;
        const Real wave = end ? Real(0) : i % 2 == 0 ? Real(1) : Real(-1);
        points[i] = from + static_cast<Real>(i) / kCoils * (to - from) + wave * side;
    }
    canvas.ribbon(points, Real(0.03), lighter(palette::kMachine, 0.2f));
}

void paintLink(Canvas& canvas, const Mapping& mapping, const LinkDef& link) {
    const Vec2 from{metres(link.fromX), metres(link.fromY)};
    const Vec2 to{metres(link.toX), metres(link.toY)};
    switch (link.kind) {
    case LinkKind::Rope:
        return canvas.line(mapping.at(from), mapping.at(to), Real(0.03), kRope);
    case LinkKind::Spring:
        return paintSpring(canvas, mapping.at(from), mapping.at(to));
    case LinkKind::Slider: {
        const Vec2 axis = towards(kTurn * metres(link.axis) / 360);
        const Real low = link.limited ? metres(link.low) : Real(-2);
        const Real high = link.limited ? metres(link.high) : Real(2);
        return canvas.line(mapping.at(mapping.held(from + low * axis)),
                           mapping.at(mapping.held(from + high * axis)), Real(0.03),
                           palette::kMachine);
    }
    case LinkKind::Motor:
        return canvas.disc(mapping.at(from), Real(0.07), palette::kAccent, palette::kAccent);
    case LinkKind::Pin:
        return canvas.disc(mapping.at(from), Real(0.045), lighter(palette::kMachine, 0.3f),
                           palette::kMachine);
    }
}

void paintWell(Canvas& canvas, const Mapping& mapping, const WellDef& well) {
    const Color color = faded(canvas.palette().of(Power::Well), 0.8f);
    const Vec2 middle = mapping.at({metres(well.x), metres(well.y)});
    canvas.ring(middle, mapping.scale, Real(0.04), color);
    if (well.strength > 0) {
        canvas.disc(middle, Real(0.35) * mapping.scale, color, color);
    } else { // it repels
        canvas.ring(middle, Real(0.6) * mapping.scale, Real(0.03), color);
    }
}

void paintWater(Canvas& canvas, const Mapping& mapping, const WaterDef& water) {
    const Vec2 half{metres(water.width) / 2, 0};
    const Vec2 top{metres(water.x), metres(water.y)};
    const Vec2 left = mapping.held(top - half);
    const Vec2 right = mapping.held(top + half);
    const Vec2 low = mapping.held(top - Vec2{0, metres(water.depth)});
    const std::array<Vec2, 4> corners = {mapping.at({left.x, low.y}), mapping.at({right.x, low.y}),
                                         mapping.at(right), mapping.at(left)};
    const Color deep = faded(darker(palette::kWater, 0.4f), 0.9f);
    const Color bright = faded(palette::kWater, 0.8f);
    canvas.polygon(corners, std::array<Color, 4>{deep, deep, bright, bright});
    canvas.line(corners[3], corners[2], Real(0.035), palette::kFoam);
}

/// Streaks that fade against the direction of the wind.
void paintWind(Canvas& canvas, const Mapping& mapping, std::int32_t wind) {
    const Color color = canvas.palette().of(Power::Wind);
    const Real size = wind > 0 ? Real(2.6) : Real(-2.6);
    for (const Vec2 tip : {Vec2{-7, 3}, Vec2{1, Real(3.8)}, Vec2{8, Real(3.2)}}) {
        const std::array<Vec2, 2> points = {mapping.at(tip - Vec2{size, 0}), mapping.at(tip)};
        const std::array<Color, 2> colors = {faded(color, 0), faded(color, 0.8f)};
        canvas.ribbon(points, std::array{Real(0.04), Real(0.04)}, colors);
    }
}

/// A paddle or ball that differs from the usual one.
void paintUnusual(Canvas& canvas, const Mapping& mapping, const Level& level) {
    const Vec2 middle = mapping.at({0, kPaddleY});
    const Vec2 half{mapping.scale * Real(1.9), 0};
    const bool tilts = level.paddle == PaddleKind::Tilting || level.paddle == PaddleKind::Loose;
    const bool recoils = level.paddle == PaddleKind::Recoiling || level.paddle == PaddleKind::Loose;
    const Vec2 tilt = tilts ? mapping.scale * Vec2{0, Real(0.5)} : Vec2{};
    if (level.paddle != PaddleKind::Steady) {
        canvas.line(middle - half - tilt, middle + half + tilt, Real(0.06), palette::kPaddle);
    }
    if (recoils) {
        paintSpring(canvas, middle, mapping.at({0, 0}));
    }
    if (level.ball != BallKind::Round) {
        const Vec2 place = mapping.at({Real(2.6), kPaddleY + 1});
        canvas.disc(place, Real(0.07), palette::kBall, palette::kBall);
        const auto kind = static_cast<Real>(level.ball);
        canvas.disc(place + Real(0.03) * towards(kind), Real(0.03), palette::kInk, palette::kInk);
    }
}

} // namespace

void paintPreview(Canvas& canvas, const Level& level, const Aabb& box) {
    const Vec2 shown{kFieldWidth, kFieldHeight};
    const Real scale = std::min(box.extent().x / shown.x, box.extent().y / shown.y);
    const Mapping mapping{{box.center().x - scale * shown.x / 2, box.upper.y}, scale};
    if (level.wind != 0) {
        paintWind(canvas, mapping, level.wind);
    }
    for (const WellDef& well : level.wells) {
        paintWell(canvas, mapping, well);
    }
    for (const WaterDef& water : level.waters) {
        paintWater(canvas, mapping, water);
    }
    for (const ObstructionDef& def : level.obstructions) {
        paintObstruction(canvas, mapping, def);
    }
    for (const Cell& cell : level.cells) {
        const BlockKind& kind = level.kinds[cell.kind];
        const Color color = canvas.palette().of(kind.stuff);
        const Vec2 half{Real(0.46) * kCellWidth, Real(0.43) * kCellHeight};
        const Vec2 middle = centerOf(cell);
        const Vec2 low = mapping.at(middle - half);
        const Vec2 high = mapping.at(middle + half);
        canvas.polygon(std::array{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}},
                       std::array{darker(color, 0.2f), darker(color, 0.2f), color, color});
        paintDetails(canvas, mapping, kind, middle);
    }
    for (const FreeBlock& block : level.freeBlocks) {
        const BlockKind& kind = level.kinds[block.kind];
        const PlacedShape placed = placedShapeOf(block);
        paintShape(canvas, mapping, placed, canvas.palette().of(kind.stuff));
        paintDetails(canvas, mapping, kind, placed.frame * extentOf(placed.shape).center());
    }
    if (level.keep >= 0) {
        const PlacedShape kept =
            placedShapeOf(level.freeBlocks[static_cast<std::size_t>(level.keep)]);
        const Vec2 middle = kept.frame * extentOf(kept.shape).center();
        canvas.ring(mapping.at(middle), Real(0.6) * scale, Real(0.04), palette::kAccent);
    }
    for (const LinkDef& link : level.links) {
        paintLink(canvas, mapping, link);
    }
    paintUnusual(canvas, mapping, level);
}

} // namespace apart
