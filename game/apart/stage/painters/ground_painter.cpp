// SPDX-License-Identifier: MIT
// Ground that has an outline: soil, stones in it, and turf on what faces up.
#include <apart/core/field.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace apart {

namespace {

constexpr Real kTurfDepth = Real(0.26); // m
constexpr Real kUpwards = Real(0.4);    // of the normal of an edge with turf

struct Soil {
    Color deep;
    Color soil;
    Color turf;
};

Soil soilOf(Turf turf) {
    const auto index = static_cast<std::size_t>(turf);
    const Color soil = palette::kSoil[index];
    return {darker(soil, 0.45f), soil, palette::kTurf[index]};
}

/// 0..1, the same for the same number.
Real speckle(int number) {
    const auto mixed = static_cast<std::uint32_t>(number) * 2654435761u;
    return static_cast<Real>((mixed >> 12u) % 1024) / 1024;
}

bool contains(const kodo::Polygon& polygon, Vec2 place) {
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const Vec2 from = polygon.corners[i];
        const Vec2 to = polygon.corners[(i + 1) % polygon.corners.size()];
        if (cross(to - from, place - from) < 0) {
            return false;
        }
    }
    return true;
}

void paintStones(Canvas& canvas, const kodo::Polygon& piece, const Soil& look) {
    constexpr Real kApart = Real(0.75); // m
    const Aabb box = kodo::aabbOf(std::span<const Vec2>(piece.corners));
    const auto first = [](Real from) { return static_cast<int>(std::floor(from / kApart)); };
    for (int row = first(box.lower.y); row <= first(box.upper.y); ++row) {
        for (int column = first(box.lower.x); column <= first(box.upper.x); ++column) {
            const int number = 97 * row + column + 5000;
            const Real size = Real(0.06) + Real(0.12) * speckle(number + 1);
            const Vec2 place{kApart * (static_cast<Real>(column) + speckle(number)),
                             kApart * (static_cast<Real>(row) + speckle(number + 2))};
            if (contains(piece, place)) {
                const Color stone = mix(look.deep, look.turf, 0.35f);
                canvas.disc(place, size, faded(stone, 0.7f), faded(look.deep, 0.5f));
            }
        }
    }
}

/// Blades of grass along an edge.
void paintBlades(Canvas& canvas, Vec2 from, Vec2 to, Color color) {
    constexpr Real kApart = Real(0.24); // m
    const Real way = length(to - from);
    for (int i = 0; static_cast<Real>(i) * kApart < way; ++i) {
        const int number = i + static_cast<int>(7 * std::abs(from.x));
        const Vec2 foot = from + (static_cast<Real>(i) * kApart / way) * (to - from);
        const Vec2 tip{Real(0.24) * (speckle(number) - Real(0.5)),
                       Real(0.1) + Real(0.14) * speckle(number + 3)};
        canvas.line(foot, foot + tip, Real(0.06), color);
    }
}

/// The edges that face up, as strokes through their corners.
void paintTurf(Canvas& canvas, std::span<const Vec2> outline, const Soil& look, bool blades) {
    const std::size_t count = outline.size();
    const auto faces = [&](std::size_t i) {
        const Vec2 way = normalize(outline[(i + 1) % count] - outline[i % count]);
        return -way.x > kUpwards; // of a counter-clockwise outline
    };
    std::size_t start = 0; // an edge without turf
    while (start < count && faces(start)) {
        ++start;
    }
    std::vector<Vec2> stroke;
    for (std::size_t i = start; i <= start + count; ++i) {
        if (i < start + count && faces(i)) {
            const Vec2 from = outline[i % count];
            const Vec2 to = outline[(i + 1) % count];
            const Vec2 in{0, -kTurfDepth / 2};
            stroke.insert(stroke.end(), stroke.empty() ? 1 : 0, from + in);
            stroke.push_back(to + in);
            if (blades) {
                paintBlades(canvas, from, to, lighter(look.turf, 0.12f));
            }
        } else if (!stroke.empty()) {
            canvas.ribbon(stroke, kTurfDepth, look.turf);
            for (Vec2& point : stroke) {
                point.y += Real(0.4) * kTurfDepth;
            }
            canvas.ribbon(stroke, Real(0.07), lighter(look.turf, 0.3f));
            stroke.clear();
        }
    }
}

} // namespace

void paintGround(Canvas& canvas, const ObstructionDef& ground) {
    const Soil look = soilOf(ground.turf);
    std::vector<Vec2> outline = outlineOf(ground);
    Real area = 0; // twice; > 0 for a counter-clockwise outline
    for (std::size_t i = 0; i < outline.size(); ++i) {
        area += cross(outline[i], outline[(i + 1) % outline.size()]);
    }
    if (area < 0) {
        std::reverse(outline.begin(), outline.end());
    }
    const Aabb box = kodo::aabbOf(std::span<const Vec2>(outline));
    const std::vector<kodo::Polygon> pieces = polygonsOf(solidOf(ground));
    for (const kodo::Polygon& piece : pieces) {
        std::vector<Color> colors;
        for (const Vec2 corner : piece.corners) {
            const Real up = (corner.y - box.lower.y) / box.extent().y;
            colors.push_back(mix(look.deep, look.soil, static_cast<float>(up)));
        }
        canvas.facet(piece.corners, colors);
        paintStones(canvas, piece, look);
    }
    canvas.outline(outline, Real(0.1), darker(look.soil, 0.6f));
    paintTurf(canvas, outline, look, ground.turf == Turf::Grass);
}

} // namespace apart
