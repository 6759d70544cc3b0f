// SPDX-License-Identifier: MIT
// Straps by which mounted blocks and ledges are bolted to the wall behind the field.
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/field_painter.hpp>

namespace apart {

namespace {

constexpr Real kStrap = Real(0.28); // m, width
constexpr Real kTab = Real(0.3);    // m, from the edge of what it holds to its end
constexpr Real kInset = Real(0.35); // m, from the sides of something wide

/// The bounds of a shape in its own frame (m).
Aabb boundsOf(const kodo::ConvexShape& outline) {
    return kodo::aabbOf(std::span<const Vec2>(outline.vertices)).grown(outline.radius);
}

void paintStrap(Canvas& canvas, Vec2 low, Vec2 high) {
    const Color steel = darker(palette::kMachine, 0.6f);
    canvas.line(low, high, kStrap, palette::kInk);
    canvas.line(low, high, kStrap - Real(0.08), steel);
    const Vec2 bolt = Real(0.14) * normalize(high - low);
    for (const Vec2 middle : {low + bolt, high - bolt}) {
        canvas.disc(middle, Real(0.07), lighter(steel, 0.5f), lighter(steel, 0.2f));
    }
}

/// One strap behind something narrow, else one near each side.
void paintStraps(Canvas& canvas, const kodo::ConvexShape& outline, const kodo::Transform& place) {
    const Aabb bounds = boundsOf(outline);
    const Vec2 middle = bounds.center();
    const Vec2 half = Real(0.5) * bounds.extent();
    const Vec2 up{0, half.y + kTab};
    const Real side = half.x > 2 * kInset ? half.x - kInset : Real(0);
    paintStrap(canvas, place * (middle + Vec2{side, 0} - up),
               place * (middle + Vec2{side, 0} + up));
    if (side > 0) {
        paintStrap(canvas, place * (middle - Vec2{side, 0} - up),
                   place * (middle - Vec2{side, 0} + up));
    }
}

} // namespace

void paintMounts(Canvas& canvas, const Moment& moment) {
    for (const Block& block : moment.game.blocks()) {
        const kodo::Transform place = moment.placeOf(block.body);
        const bool free = block.key >= keyOfFree(0);
        if (!free || block.support != Support::Mounted) {
            continue;
        }
        const kodo::ConvexShape& outline = moment.game.world()[block.body].part(block.part).convex;
        if (isBuilt(moment, place * outline.middle)) {
            paintStraps(canvas, outline, place);
        }
    }
    for (const Obstruction& thing : moment.game.obstructions()) {
        if (thing.kind == ObstructionKind::Ledge) {
            paintStraps(canvas, moment.game.world()[thing.body].part(0).convex,
                        moment.placeOf(thing.body));
        }
    }
}

} // namespace apart
