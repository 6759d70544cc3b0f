// SPDX-License-Identifier: MIT
#include <apart/core/player.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <functional>

namespace apart {

using kodo::Real;

namespace {

constexpr int kAims = 10;                                  // tried on each side of straight up
constexpr int kOffsets = 8;                                // on each side of the paddle's middle
constexpr Real kOffsetStep = Real(0.2);                    // m
constexpr Real kPlanSeconds = Real(0.3);                   // before the ball arrives
constexpr std::uint32_t kAheadTicks = 5 * kTicksPerSecond; // of a copy
constexpr std::int32_t kHitsOfAll = 6;                     // that a whole building is taken to need

/// Score that a game promises: with that of its lives and of its prize, if the blocks that are left
/// need hits in proportion.
double outlook(const Game& game) {
    if (game.result() != Result::Playing) {
        return game.score();
    }
    const Counts& counts = game.counts();
    double score = counts.score + counts.lives * kLifePoints;
    for (const Block& block : game.blocks()) {
        score += block.due;
    }
    const double share = static_cast<double>(counts.blocksLeft) / std::max(counts.blocksAtStart, 1);
    const double further = counts.isDown() ? 0 : 1 + kHitsOfAll * share;
    return score + counts.fullPrize / (std::max(counts.hits, 1) + further);
}

/// Sets what the shot needs in the input of a tick; false once the ball was met.
using Shot = std::function<bool(const Game&, Input&)>;

/// Outlook of a copy some seconds after a shot, if the ball is met without an aim from then on.
double tried(Game copy, const Shot& shot) {
    bool aims = true;
    for (std::uint32_t i = 0; i < kAheadTicks && copy.result() == Result::Playing; ++i) {
        Input input = bot(copy, BotKind::Lazy);
        aims = aims && shot(copy, input);
        copy.tick(input);
    }
    return outlook(copy);
}

Shot serveAt(std::int16_t aim) {
    return [aim](const Game& game, Input& input) {
        input.aim = aim;
        return game.serving();
    };
}

void meetAt(const Game& game, Real offset, Input& input) {
    constexpr Real kMost = kFieldWidth / 2;
    if (const std::optional<Arrival> arrival = firstArrival(game, offset)) {
        input.target =
            static_cast<std::int16_t>(std::clamp(arrival->x - offset, -kMost, kMost) * 1000);
    }
}

Shot returnAt(Real offset, std::uint32_t hitTick) {
    return [offset, hitTick](const Game& game, Input& input) {
        const bool met = game.counts().hitTick != hitTick;
        if (!met) {
            meetAt(game, offset, input);
        }
        return !met;
    };
}

std::int16_t bestServe(const Game& game) {
    std::int16_t best = 0;
    std::optional<double> most;
    for (int i = -kAims; i <= kAims; ++i) {
        const auto aim = static_cast<std::int16_t>(kMostAim * i / (kAims + 2));
        const double score = tried(game, serveAt(aim));
        if (!most || score > *most) {
            most = score;
            best = aim;
        }
    }
    return best;
}

Real bestReturn(const Game& game) {
    Real best = 0;
    std::optional<double> most;
    for (int i = -kOffsets; i <= kOffsets; ++i) {
        const Real offset = kOffsetStep * static_cast<Real>(i);
        const double score = tried(game, returnAt(offset, game.counts().hitTick));
        if (!most || score > *most) {
            most = score;
            best = offset;
        }
    }
    return best;
}

} // namespace

Input Player::next(const Game& game) {
    Input input = bot(game, kind_);
    if (kind_ != BotKind::Planner || game.result() != Result::Playing) {
        return input;
    }
    if (game.serving()) {
        input.aim = bestServe(game);
        return input;
    }
    const std::optional<Arrival> arrival = firstArrival(game, 0);
    if (!arrival || game.counts().hitTick != hitTick_) {
        offset_.reset(); // met, or turned away
    }
    if (arrival && arrival->seconds < kPlanSeconds) {
        if (!offset_) {
            offset_ = bestReturn(game);
            hitTick_ = game.counts().hitTick;
        }
        meetAt(game, *offset_, input);
    }
    return input;
}

} // namespace apart
