// SPDX-License-Identifier: MIT
#include <apart/core/field.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/angle.hpp>
#include <apart/stage/level_preview.hpp>
#include <apart/stage/palette.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace apart {

namespace {

constexpr Real kShownBottom = 4; // m; the field below it is empty in most levels

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
};

Color colorOf(const BlockKind& kind) {
    return kind.power == Power::None ? palette::of(kind.stuff)
                                     : lighter(palette::of(kind.power), 0.2f);
}

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

void paintObstruction(Canvas& canvas, const Mapping& mapping, const ObstructionDef& def) {
    const Vec2 place = mapping.at({metres(def.x), metres(def.y)});
    const Real size = mapping.scale * metres(def.size);
    const Vec2 half{size / 2, 0};
    switch (def.kind) {
    case ObstructionKind::Bumper:
        canvas.disc(place, size, palette::kBumper, palette::kBumper);
        break;
    case ObstructionKind::Pin:
        canvas.disc(place, size, palette::kMachine, palette::kMachine);
        break;
    case ObstructionKind::Motor:
        canvas.line(place - half, place + half, Real(0.05), palette::kMachine);
        break;
    case ObstructionKind::Gate: {
        const bool lies = def.facing == Facing::Up || def.facing == Facing::Down;
        const Vec2 way = lies ? half : Vec2{0, size / 2};
        canvas.line(place - way, place + way, Real(0.04), palette::kPaddle);
        break;
    }
    case ObstructionKind::Ground:
        for (std::size_t i = 0; i + 1 < def.heights.size(); ++i) {
            const Real left = metres(def.x) + metres(def.spacing) * static_cast<Real>(i);
            const Vec2 from{left, metres(def.y + def.heights[i])};
            const Vec2 to{left + metres(def.spacing), metres(def.y + def.heights[i + 1])};
            if (std::min(from.y, to.y) >= kShownBottom) {
                canvas.line(mapping.at(from), mapping.at(to), Real(0.05), palette::kGround);
            }
        }
        break;
    case ObstructionKind::Ledge: {
        const kodo::BodyDef body = obstructionDef(def);
        paintShape(canvas, mapping, {body.shape, {body.position, body.rotation}},
                   lighter(palette::kGround, 0.2f));
        break;
    }
    }
}

} // namespace

void paintPreview(Canvas& canvas, const Level& level, const Aabb& box) {
    const Vec2 shown{kFieldWidth, kFieldHeight - kShownBottom};
    const Real scale = std::min(box.extent().x / shown.x, box.extent().y / shown.y);
    const Mapping mapping{{box.center().x - scale * shown.x / 2, box.upper.y}, scale};
    for (const WellDef& well : level.wells) {
        const Color color = faded(palette::of(Power::Well), 0.8f);
        canvas.ring(mapping.at({metres(well.x), metres(well.y)}), scale, Real(0.04), color);
    }
    for (const ObstructionDef& def : level.obstructions) {
        paintObstruction(canvas, mapping, def);
    }
    for (const LinkDef& link : level.links) {
        canvas.line(mapping.at({metres(link.fromX), metres(link.fromY)}),
                    mapping.at({metres(link.toX), metres(link.toY)}), Real(0.03),
                    palette::kMachine);
    }
    for (const Cell& cell : level.cells) {
        const Color color = colorOf(level.kinds[cell.kind]);
        const Vec2 half{Real(0.46) * kCellWidth, Real(0.43) * kCellHeight};
        const Vec2 middle = centerOf(cell);
        canvas.rectangle({mapping.at(middle - half), mapping.at(middle + half)},
                         darker(color, 0.2f), color);
    }
    for (const FreeBlock& block : level.freeBlocks) {
        paintShape(canvas, mapping, placedShapeOf(block), colorOf(level.kinds[block.kind]));
    }
}

} // namespace apart
