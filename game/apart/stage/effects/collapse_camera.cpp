// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/effects/collapse_camera.hpp>
#include <apart/stage/effects/time_scale.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Real kLargest = Real(1.35);              // scale at full strength
constexpr double kIn = 2.2;                        // 1/s
constexpr double kOut = 1.4;                       // 1/s
constexpr std::uint32_t kRecent = kTicksPerSecond; // ticks; older falls do not attract the camera
constexpr Real kMargin = Real(0.7);                // m, around paddle and balls

/// The field with its walls: the part of the picture that is enlarged.
constexpr Aabb kField{layout::kShown.lower, {layout::kRight + Real(0.85), layout::kShown.upper.y}};

/// Bounds of all that the player must see.
Aabb needed(const Game& game) {
    Aabb box = game.world()[game.paddle()].bounds();
    for (const Ball& ball : game.balls()) {
        const Aabb own = game.world()[ball.body].bounds();
        box = unite(box, own);
    }
    box = box.grown(kMargin);
    return {{std::max(box.lower.x, kField.lower.x), std::max(box.lower.y, kField.lower.y)},
            {std::min(box.upper.x, kField.upper.x), std::min(box.upper.y, kField.upper.y)}};
}

/// Mean place of the blocks that fell a moment ago.
std::optional<Vec2> middleOfFall(const Game& game) {
    Vec2 sum;
    int count = 0;
    for (const Block& block : game.blocks()) {
        if (block.support == Support::Fallen && game.ticks() - block.looseTick < kRecent) {
            sum += game.world()[block.body].center();
            ++count;
        }
    }
    return count > 0 ? std::optional(sum / static_cast<Real>(count)) : std::nullopt;
}

/// The focus nearest to `wanted` whose closeup shows [from, to] of the range [low, high].
Real focusFor(Real wanted, Real scale, std::pair<Real, Real> range, std::pair<Real, Real> shown) {
    if (scale <= 1) {
        return wanted;
    }
    // A closeup shows focus * (1 - 1 / scale) + [low, high] / scale.
    const Real moved = 1 - 1 / scale;
    const Real least = (shown.second - range.second / scale) / moved;
    const Real most = (shown.first - range.first / scale) / moved;
    const Real near = std::clamp(wanted, range.first, range.second);
    return std::clamp(near, std::min(least, most), most);
}

} // namespace

void CollapseCamera::advance(const Game& game, double seconds, float share) {
    if (game.ticks() < 2) {
        *this = {}; // new game
    }
    const std::optional<Vec2> fall =
        game.collapse().blocks >= kLargeCollapse ? middleOfFall(game) : std::nullopt;
    const Real goal = fall ? 1 + (kLargest - 1) * share : 1;
    const double rate = goal > scale_ ? kIn : kOut;
    const auto step = static_cast<Real>(std::min(rate * seconds, 1.0));
    if (fall) {
        focus_ = scale_ < Real(1.002) ? *fall : focus_ + step * (*fall - focus_);
    }
    scale_ += step * (goal - scale_);
}

Closeup CollapseCamera::closeup(const Game& game) const {
    if (scale_ < Real(1.002)) {
        return {};
    }
    const Aabb keep = needed(game);
    const Vec2 room = kField.extent();
    const Vec2 size = keep.extent();
    const Real scale = std::max(std::min({scale_, room.x / size.x, room.y / size.y}), Real(1));
    return {
        {focusFor(focus_.x, scale, {kField.lower.x, kField.upper.x}, {keep.lower.x, keep.upper.x}),
         focusFor(focus_.y, scale, {kField.lower.y, kField.upper.y}, {keep.lower.y, keep.upper.y})},
        scale};
}

Aabb shownBy(const Closeup& closeup) {
    const auto at = [&](Vec2 corner) {
        return closeup.focus + (corner - closeup.focus) / closeup.scale;
    };
    return {at(kField.lower), at(kField.upper)};
}

} // namespace apart
