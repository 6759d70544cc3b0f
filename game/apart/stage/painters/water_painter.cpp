// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/field_painter.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace apart {

namespace {

constexpr Real kStride = Real(0.4);  // m, between points of the surface
constexpr Real kSwell = Real(0.035); // m, amplitude of the swell of still water

/// Height (m) of the surface above its rest: waves of splashes, and a slow swell.
Real waveAt(const Moment& moment, std::size_t water, Real x) {
    const Real time = moment.time();
    const Real swell = std::sin(Real(1.1) * x + Real(0.021) * time) +
                       Real(0.6) * std::sin(Real(2.3) * x - Real(0.034) * time);
    return kSwell * swell + moment.juice.ripples().heightAt(water, x);
}

std::vector<Vec2> surfaceOf(const Moment& moment, std::size_t index) {
    const Aabb& region = moment.game.waters()[index].region;
    const int count = std::max(2, static_cast<int>(region.extent().x / kStride) + 1);
    std::vector<Vec2> points;
    for (int i = 0; i <= count; ++i) {
        const Real share = static_cast<Real>(i) / static_cast<Real>(count);
        const Real x = region.lower.x + share * region.extent().x;
        points.push_back({x, std::max(region.upper.y + waveAt(moment, index, x), region.lower.y)});
    }
    return points;
}

/// Fills the water below its surface. Colours of the surface and of the bottom.
void fill(Canvas& canvas, const std::vector<Vec2>& surface, Real bottom, Color top, Color deep) {
    const std::array<Color, 4> colors = {deep, deep, top, top};
    for (std::size_t i = 0; i + 1 < surface.size(); ++i) {
        const std::array<Vec2, 4> corners = {
            Vec2{surface[i].x, bottom}, Vec2{surface[i + 1].x, bottom}, surface[i + 1], surface[i]};
        canvas.facet(corners, colors);
    }
}

/// Light that falls through the surface: slanted streaks, which move with the swell.
void paintRays(Canvas& canvas, const Moment& moment, const Aabb& region) {
    constexpr Real kApart = Real(2.2); // m
    canvas.setGlow(true);
    for (Real x = region.lower.x + kApart / 2; x < region.upper.x - 1; x += kApart) {
        const Real sway = Real(0.25) * std::sin(Real(0.013) * moment.time() + 3 * x);
        const Real reach = std::min(region.extent().y, Real(2.2));
        const Real slant = Real(0.45) * reach;
        const Real top = region.upper.y;
        const Real left = std::max(x + sway - slant, region.lower.x);
        const std::array<Vec2, 4> corners = {
            Vec2{left, top - reach}, Vec2{std::min(left + Real(0.9), region.upper.x), top - reach},
            Vec2{x + sway + Real(0.5), top}, Vec2{x + sway, top}};
        const Color bright = faded(palette::kFoam, 0.10f);
        const Color dark = faded(palette::kFoam, 0);
        canvas.facet(corners, std::array<Color, 4>{dark, dark, bright, bright});
    }
    canvas.setGlow(false);
}

/// What runs out, from the breach to the bottom of the field.
void paintOutflow(Canvas& canvas, const Moment& moment, const Water& water) {
    if (!water.open || water.region.upper.y <= water.floor() + Real(0.01)) {
        return;
    }
    constexpr int kSteps = 12;
    const Real wide = std::min(Real(0.8), Real(0.35) + (water.region.upper.y - water.floor()) / 3);
    const auto pointsAt = [&](Real side) {
        std::array<Vec2, kSteps + 1> points;
        for (int i = 0; i <= kSteps; ++i) {
            const Real share = static_cast<Real>(i) / kSteps;
            const Real sway = Real(0.12) * share *
                              std::sin(Real(9) * share - Real(0.19) * moment.time() + 2 * side);
            points[static_cast<std::size_t>(i)] = {water.breach.x + side * wide + sway,
                                                   (1 - share) * water.breach.y};
        }
        return points;
    };
    const auto left = pointsAt(Real(-0.5));
    const auto right = pointsAt(Real(0.5));
    for (std::size_t i = 0; i < kSteps; ++i) {
        const float above = 0.55f * (1 - static_cast<float>(i) / kSteps) + 0.12f;
        const float below = 0.55f * (1 - static_cast<float>(i + 1) / kSteps) + 0.12f;
        const std::array<Vec2, 4> corners = {left[i + 1], right[i + 1], right[i], left[i]};
        const Color high = faded(palette::kWater, above);
        const Color low = faded(palette::kWater, below);
        canvas.facet(corners, std::array<Color, 4>{low, low, high, high});
    }
    canvas.ribbon(left, Real(0.06), faded(palette::kFoam, 0.35f));
    canvas.ribbon(right, Real(0.06), faded(palette::kFoam, 0.35f));
}

} // namespace

void paintWaterBehind(Canvas& canvas, const Moment& moment) {
    for (std::size_t i = 0; i < moment.game.waters().size(); ++i) {
        const Water& water = moment.game.waters()[i];
        if (water.isEmpty()) {
            continue;
        }
        const Color top = faded(palette::kWater, 0.62f);
        const Color deep = faded(darker(palette::kWater, 0.6f), 0.85f);
        fill(canvas, surfaceOf(moment, i), water.region.lower.y, top, deep);
        paintRays(canvas, moment, water.region);
    }
}

void paintWaterBefore(Canvas& canvas, const Moment& moment) {
    for (std::size_t i = 0; i < moment.game.waters().size(); ++i) {
        const Water& water = moment.game.waters()[i];
        paintOutflow(canvas, moment, water);
        if (water.isEmpty()) {
            continue;
        }
        const std::vector<Vec2> surface = surfaceOf(moment, i);
        const Color top = faded(palette::kWater, 0.22f);
        const Color deep = faded(darker(palette::kWater, 0.45f), 0.42f);
        fill(canvas, surface, water.region.lower.y, top, deep);
        std::vector<Vec2> below = surface;
        for (Vec2& point : below) {
            point.y = std::max(point.y - Real(0.09), water.region.lower.y);
        }
        canvas.ribbon(below, Real(0.09), faded(palette::kWater, 0.5f));
        canvas.ribbon(surface, Real(0.07), faded(palette::kFoam, 0.85f));
    }
}

} // namespace apart
