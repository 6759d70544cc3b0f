// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/angle.hpp>
#include <apart/stage/canvas/dice.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/block_painter.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

constexpr int kRoundCorners = 24;
constexpr Real kGap = Real(0.05);   // m, from a block of the grid to its edge
constexpr Real kBadge = Real(0.29); // m, radius of the disc under a symbol
constexpr Real kHotRim = Real(0.1); // m, by which a hit widens the rim

/// A line in the frame of a block, in shares of its half width and half height.
struct Grain {
    const kodo::Transform& place;
    Vec2 half;

    Vec2 at(Real u, Real v) const { return place * Vec2{u * half.x, v * half.y}; }
};

void grainOfWood(Canvas& canvas, const Grain& grain, Dice& dice) {
    const Color line = faded(darker(canvas.palette().of(Stuff::Wood), 0.55f), 0.55f);
    for (const Real v : {Real(-0.5), Real(0), Real(0.5)}) {
        const Real bow = dice.between(Real(-0.2), Real(0.2));
        canvas.line(grain.at(Real(-0.94), v), grain.at(Real(-0.2), v + bow), Real(0.03), line);
        canvas.line(grain.at(Real(-0.2), v + bow), grain.at(Real(0.94), v), Real(0.03), line);
    }
}

void grainOfBrick(Canvas& canvas, const Grain& grain) {
    const Color line = faded(lighter(canvas.palette().of(Stuff::Brick), 0.45f), 0.5f);
    const Real width = Real(0.045);
    canvas.line(grain.at(Real(-0.96), 0), grain.at(Real(0.96), 0), width, line);
    // Two joints above and one below in each stretch of about the width of a brick.
    const int stretches = std::max(1, static_cast<int>(grain.half.x / Real(0.8) + Real(0.5)));
    const auto joint = [&](int stretch, Real share, Real to) {
        const Real u = 2 * (static_cast<Real>(stretch) + share) / static_cast<Real>(stretches) - 1;
        canvas.line(grain.at(u, 0), grain.at(u, to), width, line);
    };
    for (int i = 0; i < stretches; ++i) {
        joint(i, Real(0.335), Real(0.92));
        joint(i, Real(0.525), Real(-0.92));
        joint(i, Real(0.725), Real(0.92));
    }
}

void grainOfGlass(Canvas& canvas, const Grain& grain) {
    const Color gleam{255, 255, 255, 74};
    const auto stripe = [&](Real from, Real width) {
        canvas.line(grain.at(from, Real(-0.85)), grain.at(from + Real(0.35), Real(0.85)), width,
                    gleam);
    };
    stripe(Real(-0.68), Real(0.18));
    stripe(Real(-0.42), Real(0.05));
}

void grainOfStone(Canvas& canvas, const Grain& grain, Dice& dice) {
    for (int i = 0; i < 7; ++i) {
        const Vec2 spot =
            grain.at(dice.between(Real(-0.85), Real(0.85)), dice.between(Real(-0.7), Real(0.7)));
        const Color color = i % 2 == 0 ? Color{255, 255, 255, 46} : Color{0, 0, 0, 60};
        const Real size = dice.between(Real(0.05), Real(0.13));
        canvas.disc(spot, size, color, faded(color, 0)); // a soft rim without additional triangles
    }
}

void grainOfSteel(Canvas& canvas, const Grain& grain) {
    const Color edge = faded(lighter(canvas.palette().of(Stuff::Steel), 0.55f), 0.8f);
    const std::array<Vec2, 4> frame = {
        grain.at(Real(-0.9), Real(-0.8)), grain.at(Real(0.9), Real(-0.8)),
        grain.at(Real(0.9), Real(0.8)), grain.at(Real(-0.9), Real(0.8))};
    canvas.outline(frame, Real(0.035), edge);
    const Real u = 1 - Real(0.19) / grain.half.x;
    const Real rows = grain.half.y > Real(0.25) ? Real(0.5) : Real(0);
    for (const Real side : {-u, u}) {
        for (const Real v : {-rows, rows}) {
            canvas.disc(grain.at(side, v), Real(0.06), lighter(edge, 0.4f), edge);
        }
    }
    if (grain.half.x > 3 * grain.half.y) {
        return; // a rail
    }
    canvas.line(grain.at(Real(-0.55), Real(-0.5)), grain.at(Real(0.55), Real(0.5)), Real(0.05),
                faded(edge, 0.45f));
    canvas.line(grain.at(Real(-0.55), Real(0.5)), grain.at(Real(0.55), Real(-0.5)), Real(0.05),
                faded(edge, 0.45f));
}

void paintGrain(Canvas& canvas, const Grain& grain, const BlockLook& look) {
    Dice dice(look.key + 1);
    switch (look.kind.stuff) {
    case Stuff::Glass:
        return grainOfGlass(canvas, grain);
    case Stuff::Wood:
        return grainOfWood(canvas, grain, dice);
    case Stuff::Brick:
        return grainOfBrick(canvas, grain);
    case Stuff::Stone:
        return grainOfStone(canvas, grain, dice);
    case Stuff::Steel:
        return grainOfSteel(canvas, grain);
    }
}

void paintBadge(Canvas& canvas, Power power, const kodo::Transform& place) {
    const Color color = canvas.palette().of(power);
    paintMood(canvas, moodOf(power), place.position, {kBadge, {12, 14, 26, 235}, color});
    paintMark(canvas, power, place, Real(0.56) * kBadge, color);
}

/// Paints the core of a boss as an eye.
void paintCore(Canvas& canvas, const kodo::Transform& place) {
    canvas.setGlow(true);
    canvas.disc(place.position, Real(0.9), faded(palette::kDanger, 0.4f),
                faded(palette::kDanger, 0));
    canvas.setGlow(false);
    canvas.disc(place.position, Real(0.3), palette::kInk, palette::kInk);
    canvas.disc(place.position, Real(0.22), lighter(palette::kDanger, 0.6f), palette::kDanger);
    canvas.ring(place.position, Real(0.3), Real(0.05), lighter(palette::kDanger, 0.3f));
}

/// Paints the frame around the blocks of a boss.
void paintArmour(Canvas& canvas, const Grain& grain) {
    constexpr Real kU = Real(0.96); // inside the edges
    constexpr Real kV = Real(0.91);
    const std::array<Vec2, 4> corners = {grain.at(-kU, -kV), grain.at(kU, -kV), grain.at(kU, kV),
                                         grain.at(-kU, kV)};
    canvas.outline(corners, Real(0.09), faded(palette::kDanger, 0.55f));
}

/// Cracks refer to the whole convex shape. `fit` scales them to the drawn part of it.
void paintCracks(Canvas& canvas, const kodo::Transform& place, std::span<const CrackLine> cracks,
                 Vec2 fit) {
    const auto at = [&](Vec2 point) { return place * Vec2{fit.x * point.x, fit.y * point.y}; };
    const Vec2 offset{Real(0.018), Real(-0.018)};
    for (const CrackLine& crack : cracks) {
        canvas.line(at(crack.from) + offset, at(crack.to) + offset, crack.width,
                    {255, 255, 255, 70});
    }
    for (const CrackLine& crack : cracks) {
        canvas.line(at(crack.from), at(crack.to), crack.width, {6, 6, 12, 235});
    }
}

} // namespace

std::vector<Vec2> cornersOf(const kodo::ConvexShape& outline, const kodo::Transform& place) {
    std::vector<Vec2> corners;
    if (outline.isRound()) {
        const Vec2 center = place * outline.vertices[0];
        for (int i = 0; i < kRoundCorners; ++i) {
            const Real angle = kTurn * static_cast<Real>(i) / kRoundCorners;
            corners.push_back(center + outline.radius * towards(angle));
        }
        return corners;
    }
    for (const Vec2 vertex : outline.vertices) {
        corners.push_back(place * vertex);
    }
    return corners;
}

void paintLit(Canvas& canvas, std::span<const Vec2> corners, Color color, Rim rim) {
    const Aabb box = kodo::aabbOf(corners);
    const Real height = std::max(box.extent().y, Real(1e-3));
    std::vector<Color> colors;
    for (const Vec2 corner : corners) {
        const Real up = (corner.y - box.lower.y) / height;
        colors.push_back(mix(darker(color, 0.28f), lighter(color, 0.2f), up));
    }
    canvas.rimmed(corners, colors, rim.width, rim.color);
}

namespace {

/// Free blocks rest on one another: they are drawn to their edges.
bool reachesEdge(const BlockLook& look) {
    return look.key >= keyOfFree(0);
}

struct Surface {
    Color color;
    Rim rim;
};

/// A hit lights the rim, not the whole block: a long one would turn white from end to end. `thin`:
/// m, half the smaller side.
Surface surfaceOf(const Canvas& canvas, const BlockLook& look, Real thin) {
    const Color own = canvas.palette().of(look.kind.stuff);
    const Color color = faded(look.fallen ? darker(own, 0.3f) : own, look.left);
    const auto hot = static_cast<float>(look.heat);
    return {color,
            {Real(0.06) + std::min(kHotRim, Real(0.3) * thin) * look.heat,
             faded(lighter(color, 0.5f + 0.5f * hot), (0.45f + 0.55f * hot) * look.left)}};
}

void paintGlow(Canvas& canvas, std::span<const Vec2> corners, Real glow) {
    if (glow > 0) {
        canvas.setGlow(true);
        canvas.outline(corners, Real(0.3), faded(palette::kAccent, 0.6f * glow));
        canvas.setGlow(false);
    }
}

bool isRectangle(const kodo::ConvexShape& outline) {
    const Vec2 size = kodo::aabbOf(std::span<const Vec2>(outline.vertices)).extent();
    Real twiceArea = 0;
    for (std::size_t i = 1; i + 1 < outline.vertices.size(); ++i) {
        twiceArea += cross(outline.vertices[i] - outline.vertices[0],
                           outline.vertices[i + 1] - outline.vertices[0]);
    }
    return outline.vertices.size() == 4 && twiceArea > Real(1.98) * size.x * size.y;
}

void paintRectangle(Canvas& canvas, const kodo::ConvexShape& outline, const kodo::Transform& body,
                    const BlockLook& look) {
    const kodo::Transform place{body * outline.middle, body.rotation};
    const Vec2 half = Real(0.5) * kodo::aabbOf(std::span<const Vec2>(outline.vertices)).extent();
    const Real gap =
        reachesEdge(look) ? Real(0) : std::min(kGap, Real(0.2) * std::min(half.x, half.y));
    const Vec2 inner = look.scale * (half - Vec2{gap, gap});
    const std::array<Vec2, 4> corners = {place * -inner, place * Vec2{inner.x, -inner.y},
                                         place * inner, place * Vec2{-inner.x, inner.y}};
    paintGlow(canvas, corners, look.glow);
    const Surface surface = surfaceOf(canvas, look, std::min(inner.x, inner.y));
    paintLit(canvas, corners, surface.color, surface.rim);
    if (look.scale < 1 || look.left < 1) {
        return; // details appear at full size
    }
    const bool upright = half.y > half.x; // the grain follows the longer side
    const kodo::Transform along{place.position,
                                upright ? place.rotation * kodo::Rot{0, 1} : place.rotation};
    paintGrain(canvas, {along, upright ? Vec2{inner.y, inner.x} : inner}, look);
    if (look.kind.support == Support::Boss) {
        paintArmour(canvas, {place, inner});
    }
    if (look.kind.power != Power::None) {
        paintBadge(canvas, look.kind.power, place);
    } else if (look.kind.core) {
        paintCore(canvas, place);
    }
    const Real hair = Real(0.03); // half the width of a crack
    paintCracks(canvas, place, look.cracks, {(inner.x - hair) / half.x, (inner.y - hair) / half.y});
}

/// A disc with a mark that shows its rotation, or a wheel with spokes.
void paintRound(Canvas& canvas, const kodo::ConvexShape& outline, const kodo::Transform& body,
                const BlockLook& look) {
    const Vec2 middle = body * outline.middle;
    const Real radius = look.scale * (outline.radius - (reachesEdge(look) ? 0 : Real(0.02)));
    const kodo::ConvexShape& shape = outline;
    const std::vector<Vec2> corners = cornersOf(shape, body);
    paintGlow(canvas, corners, look.glow);
    const Surface surface = surfaceOf(canvas, look, radius);
    canvas.disc(middle, radius, lighter(surface.color, 0.15f), darker(surface.color, 0.22f));
    canvas.ring(middle, Real(0.93) * radius, Real(0.14) * radius,
                faded(lighter(surface.color, 0.45f + 0.55f * static_cast<float>(look.heat)),
                      (0.6f + 0.4f * static_cast<float>(look.heat)) * look.left));
    const Color spoke = faded(darker(surface.color, 0.5f), 0.7f * look.left);
    for (int i = 0; i < 3; ++i) {
        const Vec2 way = body.rotation * towards(kTurn * static_cast<Real>(i) / 6);
        canvas.line(middle - Real(0.8) * radius * way, middle + Real(0.8) * radius * way,
                    Real(0.1) * radius, spoke);
    }
    canvas.disc(middle, Real(0.2) * radius, lighter(surface.color, 0.4f), surface.color);
}

void paintConvex(Canvas& canvas, const kodo::ConvexShape& outline, const kodo::Transform& body,
                 const BlockLook& look) {
    const Vec2 middle = body * outline.middle;
    const auto shrunk = [&](Real share) {
        std::vector<Vec2> corners = cornersOf(outline, body);
        for (Vec2& corner : corners) {
            corner = middle + share * (corner - middle);
        }
        return corners;
    };
    const std::vector<Vec2> corners = shrunk((reachesEdge(look) ? 1 : Real(0.94)) * look.scale);
    paintGlow(canvas, corners, look.glow);
    const Vec2 size = kodo::aabbOf(std::span<const Vec2>(outline.vertices)).extent();
    const Surface surface = surfaceOf(canvas, look, Real(0.5) * std::min(size.x, size.y));
    paintLit(canvas, corners, surface.color, surface.rim);
    if (look.scale < 1 || look.left < 1) {
        return;
    }
    canvas.outline(shrunk(Real(0.62)), Real(0.045), faded(lighter(surface.color, 0.45f), 0.4f));
    paintCracks(canvas, {middle, body.rotation}, look.cracks, {Real(0.9), Real(0.9)});
}

} // namespace

void paintBlock(Canvas& canvas, const kodo::ConvexShape& outline, const kodo::Transform& place,
                const BlockLook& look) {
    if (outline.isRound()) {
        paintRound(canvas, outline, place, look);
    } else if (isRectangle(outline)) {
        paintRectangle(canvas, outline, place, look);
    } else {
        paintConvex(canvas, outline, place, look);
    }
}

} // namespace apart
