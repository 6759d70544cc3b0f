// SPDX-License-Identifier: MIT
#include <apart/core/player.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <optional>

namespace apart {

using kodo::Real;

namespace {

constexpr int kAims = 10;                                  // tried on each side of straight up
constexpr int kOffsets = 8;                                // on each side of the paddle's middle
constexpr Real kOffsetStep = Real(0.2);                    // m
constexpr Real kPlanSeconds = Real(0.3);                   // before the ball arrives
constexpr std::uint32_t kAheadTicks = 8 * kTicksPerSecond; // of a copy, for a serve or a return

/// Score that a game promises: with what its end will add if it is won.
double outlook(const Game& game) {
    if (game.result() != Result::Playing) {
        return game.score();
    }
    const Counts& counts = game.counts();
    double score = counts.score + counts.lives * kLifePoints + counts.prize();
    for (const Block& block : game.blocks()) {
        score += block.due;
    }
    return game.state().keeps() ? score + kSparedPoints : score;
}

bool isNear(const std::optional<Arrival>& arrival) {
    return arrival && arrival->seconds < kPlanSeconds;
}

void meetAt(const Game& game, Real offset, Input& input) {
    constexpr Real kMost = kFieldWidth / 2;
    if (const std::optional<Arrival> arrival = firstArrival(game, offset)) {
        input.target =
            static_cast<std::int16_t>(std::clamp(arrival->x - offset, -kMost, kMost) * 1000);
    }
}

/// Outlook of a copy at the hit that follows a return, or once the building is down.
double afterReturn(Game copy, Real offset) {
    const std::int32_t hits = copy.counts().hits;
    for (std::uint32_t i = 0; i < kAheadTicks && copy.result() == Result::Playing; ++i) {
        Input input = bot(copy, BotKind::Lazy);
        if (copy.counts().hits == hits) {
            meetAt(copy, offset, input);
        }
        copy.tick(input);
        if (copy.counts().hits > hits + 1 || copy.counts().isDown()) {
            break;
        }
    }
    return outlook(copy);
}

struct Return {
    Real offset = 0; // m, from the paddle's middle
    double outlook = 0;
};

Return bestReturn(const Game& game) {
    std::optional<Return> best;
    for (int i = -kOffsets; i <= kOffsets; ++i) {
        const Real offset = kOffsetStep * static_cast<Real>(i);
        const double score = afterReturn(game, offset);
        if (!best || score > best->outlook) {
            best = {offset, score};
        }
    }
    return *best;
}

/// Outlook of a copy after a serve and the best return of it.
double afterServe(Game copy, std::int16_t aim) {
    for (std::uint32_t i = 0; i < kAheadTicks && copy.result() == Result::Playing; ++i) {
        Input input = bot(copy, BotKind::Lazy);
        if (copy.serving()) {
            input.aim = aim;
        } else if (isNear(firstArrival(copy, 0))) {
            return bestReturn(copy).outlook;
        }
        copy.tick(input);
        if (copy.counts().isDown()) {
            break;
        }
    }
    return outlook(copy);
}

std::int16_t bestServe(const Game& game) {
    std::int16_t best = 0;
    std::optional<double> most;
    for (int i = -kAims; i <= kAims; ++i) {
        const auto aim = static_cast<std::int16_t>(kMostAim * i / (kAims + 2));
        const double score = afterServe(game, aim);
        if (!most || score > *most) {
            most = score;
            best = aim;
        }
    }
    return best;
}

} // namespace

Input Player::next(const Game& game) {
    if (kind_ != BotKind::Planner) {
        return bot(game, kind_);
    }
    Input input = bot(game, BotKind::Lazy); // as on the copies
    if (game.result() != Result::Playing || game.counts().isDown()) {
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
    if (isNear(arrival)) {
        if (!offset_) {
            offset_ = bestReturn(game).offset;
            hitTick_ = game.counts().hitTick;
        }
        meetAt(game, *offset_, input);
    }
    return input;
}

} // namespace apart
