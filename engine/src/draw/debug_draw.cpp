// SPDX-License-Identifier: MIT
#include <kodo/debug_draw.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace kodo {
inline namespace KODO_PRECISION {

namespace {

constexpr Real kTurn = Real(6.283185307179586); // rad
constexpr Real kSides = 24;                     // of a whole turn around a corner
constexpr Real kPointRadius = 3;                // pixels
constexpr Real kArrowHead = 8;                  // pixels, length
constexpr Real kToothHeight = 5;                // pixels, of a spring
constexpr int kTeeth = 12;                      // of a spring

} // namespace

DebugDraw::~DebugDraw() = default;

void DebugDraw::rounded(std::span<const Vec2> corners, Real radius, const DrawStyle& style) {
    std::vector<Vec2> outline;
    Vec2 before = corners[0] - corners.back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 after = corners[(i + 1) % corners.size()] - corners[i];
        Real sweep = atan2(cross(before, after), dot(before, after));
        sweep += sweep < 0 ? kTurn : 0; // the ends of a line: half a turn, of either sign
        const int steps = static_cast<int>(kSides * sweep / kTurn) + 1;
        for (int k = 0; k <= steps; ++k) { // the arc between the normals of both edges
            const Rot turn =
                Rot::fromAngle(sweep * static_cast<Real>(k) / static_cast<Real>(steps));
            outline.push_back(corners[i] - radius * (turn * perp(normalize(before))));
        }
        before = after;
    }
    polygon(outline, style);
}

void DebugDraw::halfPlane(Vec2 surface, Vec2 normal, const DrawStyle& style) {
    const Aabb shown = view();
    const Real above = dot(normal, shown.center() - surface);
    const Vec2 middle = shown.center() - above * normal;
    const Real reach = length(shown.extent()) + std::abs(above);
    const Vec2 along = reach * perp(normal);
    const Vec2 depth = reach * normal;
    polygon(
        std::array{middle + along, middle + along - depth, middle - along - depth, middle - along},
        style);
}

void DebugDraw::point(Vec2 place, const DrawStyle& style) {
    circle(place, kPointRadius * pixel(), {style.line, style.line, style.width});
}

void DebugDraw::arrow(Vec2 from, Vec2 to, const DrawStyle& style) {
    const Real head = (std::min)(kArrowHead * pixel(), length(to - from) / 2);
    const Vec2 back = head * normalize(from - to);
    line(from, to, style);
    line(to, to + back + perp(back) / 2, style);
    line(to, to + back - perp(back) / 2, style);
}

void DebugDraw::spring(Vec2 from, Vec2 to, const DrawStyle& style) {
    const Vec2 side = kToothHeight * pixel() * perp(normalize(to - from));
    Vec2 last = from;
    for (int i = 0; i < kTeeth; ++i) {
        const Real share = (static_cast<Real>(i) + Real(0.5)) / kTeeth;
        const Vec2 next = from + share * (to - from) + (i % 2 == 0 ? side : -side);
        line(last, next, style);
        last = next;
    }
    line(last, to, style);
}

void draw(const ConvexShape& shape, const Transform& pose, DebugDraw& target,
          const DrawStyle& style) {
    std::vector<Vec2> corners;
    for (const Vec2 vertex : shape.vertices) {
        corners.push_back(pose * vertex);
    }
    if (shape.isPlane()) {
        const Vec2 normal = pose.rotation * shape.normals[0];
        target.halfPlane(corners[0] + shape.radius * normal, normal, style);
    } else if (shape.isRound() && shape.radius > 0) {
        target.circle(corners[0], shape.radius, style);
    } else if (shape.isRound()) {
        target.point(corners[0], style);
    } else if (shape.radius > 0) {
        target.rounded(corners, shape.radius, style);
    } else if (!shape.isLine()) {
        target.polygon(corners, style);
    } else {
        target.line(corners[0], corners[1], style);
        const Vec2 tick = kArrowHead * target.pixel() * normalize(perp(corners[1] - corners[0]));
        if (shape.oneSided && length(corners[1] - corners[0]) > 2 * length(tick)) {
            const Vec2 middle = (corners[0] + corners[1]) / 2;
            target.line(middle, middle + tick, style);
        }
    }
}

Aabb viewOf(const World& world) {
    std::optional<Aabb> all;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world[id];
        for (std::size_t i = 0; i < body.partCount(); ++i) {
            const ConvexShape& shape = body.part(i).convex;
            const Vec2 first = body.massFrame() * shape.vertices[0];
            const Aabb box =
                shape.isPlane() ? Aabb{first, first} : boundsOf(shape, body.massFrame());
            all = all ? unite(*all, box) : box;
        }
    }
    const Aabb box = all.value_or(Aabb{});
    const Real side = (std::max)(box.extent().x, box.extent().y);
    return box.grown(side > 0 ? side / 20 : world.tolerances().unit());
}

} // namespace KODO_PRECISION
} // namespace kodo
