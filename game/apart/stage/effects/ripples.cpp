// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/effects/ripples.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr Real kSpacing = Real(0.25); // m, between columns
constexpr Real kTension = 400;        // 1/s^2, between neighbours: waves travel at 5 m/s
constexpr Real kStiffness = 12;       // 1/s^2, back to the still surface
constexpr Real kDamping = Real(1.6);  // 1/s
constexpr Real kHighest = Real(0.4);  // m
constexpr Real kThrown = Real(0.8);   // share of the speed of a body of 1 kg
constexpr Real kReach = Real(0.6);    // m, beside its middle

} // namespace

/// Makes the columns at the start of a level.
void Ripples::fit(const Game& game) {
    surfaces_.resize(game.waters().size());
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const kodo::Aabb& region = game.waters()[i].region;
        const auto count = static_cast<std::size_t>(region.extent().x / kSpacing) + 2;
        if (surfaces_[i].columns.size() != count || surfaces_[i].left != region.lower.x) {
            surfaces_[i] = {region.lower.x, std::vector<Column>(count)};
        }
    }
}

void Ripples::tick(const Game& game) {
    fit(game);
    for (Surface& surface : surfaces_) {
        std::vector<Column>& columns = surface.columns;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const Real here = columns[i].height;
            const Real left = i > 0 ? columns[i - 1].height : here;
            const Real right = i + 1 < columns.size() ? columns[i + 1].height : here;
            columns[i].speed += kTickSeconds * (kTension * (left + right - 2 * here) -
                                                kStiffness * here - kDamping * columns[i].speed);
        }
        for (Column& column : columns) {
            column.height =
                std::clamp(column.height + kTickSeconds * column.speed, -kHighest, kHighest);
        }
    }
}

void Ripples::strike(const Game& game, Vec2 point, Real speed, Real mass) {
    fit(game);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const kodo::Aabb& region = game.waters()[i].region;
        if (std::abs(point.y - region.upper.y) > kHighest || point.x < region.lower.x ||
            point.x > region.upper.x) {
            continue;
        }
        Surface& surface = surfaces_[i];
        for (std::size_t c = 0; c < surface.columns.size(); ++c) {
            const Real x = surface.left + kSpacing * static_cast<Real>(c);
            const Real share = 1 - std::abs(x - point.x) / kReach;
            surface.columns[c].speed +=
                std::max(share, Real(0)) * kThrown * speed * std::min(std::sqrt(mass), Real(1.5));
        }
    }
}

Real Ripples::heightAt(std::size_t water, Real x) const {
    if (water >= surfaces_.size() || surfaces_[water].columns.size() < 2) {
        return 0;
    }
    const std::vector<Column>& columns = surfaces_[water].columns;
    const Real last = static_cast<Real>(columns.size() - 1);
    const Real place = std::clamp((x - surfaces_[water].left) / kSpacing, Real(0), last);
    const std::size_t i = std::min(static_cast<std::size_t>(place), columns.size() - 2);
    const Real share = place - static_cast<Real>(i);
    return (1 - share) * columns[i].height + share * columns[i + 1].height;
}

} // namespace apart
