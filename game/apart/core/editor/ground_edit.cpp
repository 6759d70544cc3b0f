// SPDX-License-Identifier: MIT
#include <apart/core/editor/ground_edit.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

Vec2 metresOf(GroundPoint point) {
    return {static_cast<Real>(point.x) / 1000, static_cast<Real>(point.y) / 1000};
}

/// Turns a clockwise outline around, so that turf grows on what faces up.
void turnAround(std::vector<GroundPoint>& corners) {
    std::int64_t area = 0; // twice, (1/1000 m)^2
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const GroundPoint a = corners[i];
        const GroundPoint b = corners[(i + 1) % corners.size()];
        area += std::int64_t(a.x) * b.y - std::int64_t(b.x) * a.y;
    }
    if (area < 0) {
        std::reverse(corners.begin(), corners.end());
    }
}

} // namespace

bool hasOutline(const Level& level, LevelPart part) {
    return part.of == LevelPart::Of::Obstruction && !level.obstructions[part.index].points.empty();
}

Vec2 gripPlace(const ObstructionDef& ground, GroundGrip grip) {
    const Vec2 from = metresOf(ground.points[grip.corner]);
    const Vec2 to = metresOf(ground.points[(grip.corner + 1) % ground.points.size()]);
    return grip.edge ? (from + to) / 2 : from;
}

std::optional<GroundGrip> gripAt(const ObstructionDef& ground, Vec2 place) {
    constexpr Real kNear = Real(0.25); // m
    for (const bool edge : {false, true}) {
        std::optional<GroundGrip> found;
        Real least = kNear;
        for (std::size_t i = 0; i < ground.points.size(); ++i) {
            const Real way = length(gripPlace(ground, {i, edge}) - place);
            if (way < least) {
                least = way;
                found = GroundGrip{i, edge};
            }
        }
        if (found) {
            return found;
        }
    }
    return std::nullopt;
}

GroundPoint cornerAt(const Level& level, Vec2 place, bool free, std::span<const LevelPart> own) {
    constexpr auto kOuter = static_cast<std::int32_t>(kFieldWidth * 500) + 1000; // within a wall
    constexpr auto kHighest = static_cast<std::int32_t>(kFieldHeight * 1000);
    EditStep at{static_cast<std::int32_t>(std::lround(place.x * 1000)),
                static_cast<std::int32_t>(std::lround(place.y * 1000))};
    at = free ? at : snapped(level, {{}, {}}, own, at);
    return {std::clamp(at.x, -kOuter, kOuter), std::clamp(at.y, kLowestCorner, kHighest)};
}

Level withGround(Level level, std::vector<GroundPoint> corners, Turf turf) {
    ObstructionDef ground;
    ground.kind = ObstructionKind::Ground;
    ground.points = std::move(corners);
    ground.turf = turf;
    turnAround(ground.points);
    level.obstructions.push_back(std::move(ground));
    return level;
}

Level withCorner(Level level, std::size_t ground, GroundGrip grip, GroundPoint to) {
    std::vector<GroundPoint>& points = level.obstructions[ground].points;
    const auto place = points.begin() + static_cast<std::ptrdiff_t>(grip.corner);
    if (grip.edge) {
        points.insert(place + 1, to);
    } else {
        *place = to;
    }
    turnAround(points);
    return level;
}

Level withoutCorner(Level level, std::size_t ground, std::size_t corner) {
    std::vector<GroundPoint>& points = level.obstructions[ground].points;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(corner));
    turnAround(points);
    return level;
}

Level withTurf(Level level, std::span<const LevelPart> parts, Turf turf) {
    for (const LevelPart part : parts) {
        if (hasOutline(level, part)) {
            level.obstructions[part.index].turf = turf;
        }
    }
    return level;
}

ObstructionDef mirrorImage(ObstructionDef def) {
    const auto last = static_cast<std::int32_t>(def.heights.size()) - 1;
    def.x = def.heights.empty() ? -def.x : -def.x - last * def.spacing;
    def.turn = -def.turn;
    std::reverse(def.heights.begin(), def.heights.end());
    std::reverse(def.points.begin(), def.points.end());
    for (GroundPoint& point : def.points) {
        point.x = -point.x;
    }
    return def;
}

ObstructionDef flippedGround(const ObstructionDef& ground) {
    const auto [low, high] =
        std::minmax_element(ground.points.begin(), ground.points.end(),
                            [](const GroundPoint& a, const GroundPoint& b) { return a.x < b.x; });
    const std::int32_t way = low->x + high->x;
    ObstructionDef image = mirrorImage(ground);
    for (GroundPoint& point : image.points) {
        point.x += way;
    }
    return image;
}

} // namespace apart
