// SPDX-License-Identifier: MIT
#include <apart/core/bot.hpp>
#include <apart/core/generator.hpp>
#include <apart/core/soak.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

template <typename T>
bool happened(const Game& game) {
    return std::any_of(game.events().begin(), game.events().end(),
                       [](const Event& event) { return std::holds_alternative<T>(event); });
}

/// Does any field of force act on balls?
bool isCalm(const Game& game) {
    return game.force() == Force::None && game.windSpeed() == 0 && game.level().wells.empty() &&
           game.secondsLeft(Power::Magnet) <= 0 && game.secondsLeft(Power::Well) <= 0;
}

bool touches(const Game& game, kodo::BodyId ball) {
    const auto records = game.world().collisions();
    return std::any_of(records.begin(), records.end(),
                       [&](const kodo::CollisionRecord& hit) { return hit.involves(ball); });
}

std::int16_t targetOf(Real x) {
    return static_cast<std::int16_t>(std::clamp(x, -kFieldWidth / 2, kFieldWidth / 2) * 1000);
}

} // namespace

void Watch::look(const Game& game) {
    const bool news = happened<Cracked>(game) || happened<Broke>(game) || happened<LetGo>(game) ||
                      happened<Fell>(game) || game.serving();
    wait_ = news || game.result() != Result::Playing ? 0 : wait_ + 1;
    longestWait = std::max(longestWait, wait_);
    for (const Event& event : game.events()) {
        const auto* lost = std::get_if<BallLost>(&event);
        const bool below = lost == nullptr || (lost->point.y < 0 && // false for NaN
                                               std::abs(lost->point.x) < kFieldWidth / 2);
        escapes += below ? 0 : 1;
    }
    escapes += static_cast<std::uint32_t>(game.world().frozenBodies().size());
    now_.clear();
    for (const Ball& ball : game.balls()) {
        if (!ball.riding) {
            lookAtBall(game, ball);
        }
    }
    before_.swap(now_);
}

void Watch::lookAtBall(const Game& game, const Ball& ball) {
    const kodo::BodyView body = game.world()[ball.body];
    const Vec2 place = body.position();
    const bool inside = std::abs(place.x) < kFieldWidth / 2 && place.y < kFieldHeight;
    escapes += inside ? 0 : 1;
    const Real speed = length(body.velocity());
    Seen seen{ball.body, speed > 0 ? body.velocity() / speed : Vec2{}};
    const auto old = std::find_if(before_.begin(), before_.end(),
                                  [&](const Seen& s) { return s.body == ball.body; });
    if (old != before_.end()) {
        seen.slow = speed < game.ballSpeed() / 2 ? old->slow + 1 : 0;
        if (isCalm(game) && !touches(game, ball.body) && speed > kHaltSpeed) {
            worstBend = std::max(worstBend, std::abs(cross(old->heading, seen.heading)));
        }
    }
    longestSlow = std::max(longestSlow, seen.slow);
    now_.push_back(seen);
}

Input inputOf(Player player, const Game& game) {
    if (player == Player::Good) {
        return bot(game);
    }
    Input input;
    if (player == Player::Lazy) {
        if (!game.balls().empty()) {
            input.target = targetOf(game.world()[game.balls()[0].body].position().x);
        }
        input.launch = game.serving();
        return input;
    }
    Generator chance(mixKeys(game.seed(), game.ticks() / 30, 9));
    input = bot(game);
    switch (chance.below(4)) {
    case 0:
        input.target = targetOf(chance.between(-kFieldWidth / 2, kFieldWidth / 2));
        break;
    case 1:
        input.target.reset();
        input.paddle = static_cast<std::int8_t>(static_cast<int>(chance.below(255)) - 127);
        break;
    default:
        break;
    }
    input.launch = chance.below(3) == 0;
    input.force = static_cast<Force>(chance.below(3));
    return input;
}

SoakReport soak(std::span<const std::shared_ptr<const Level>> levels, std::uint64_t ticks,
                std::uint32_t seed) {
    SoakReport report;
    for (std::uint32_t i = 0; report.ticks < ticks && !levels.empty(); ++i) {
        const auto& level = levels[i % levels.size()];
        const auto turn = static_cast<std::uint32_t>(i / levels.size());
        const auto player = static_cast<Player>(turn % kPlayerNames.size());
        const Mode mode = turn % 2 == 0 ? Mode::Standard : Mode::Pure;
        Game game(level, seed + turn, mode);
        Watch watch;
        while (game.result() == Result::Playing && game.ticks() < kLongestSoakGame &&
               report.ticks < ticks) {
            game.tick(inputOf(player, game));
            watch.look(game);
            ++report.ticks;
        }
        ++report.games;
        report.won += game.result() == Result::Won ? 1 : 0;
        report.escapes += watch.escapes;
        report.longestSlow = std::max(report.longestSlow, watch.longestSlow);
        report.longestWait = std::max(report.longestWait, watch.longestWait);
        report.worstBend = std::max(report.worstBend, watch.worstBend);
        const Ledger& ledger = game.ledger();
        const std::uint32_t altered = ledger.bentBounces + ledger.thrownBounces;
        if (mode == Mode::Standard) {
            report.bounces += ledger.bounces;
            report.bent += ledger.bentBounces;
            report.thrown += ledger.thrownBounces;
        } else {
            report.alteredPure += altered;
        }
        if (watch.escapes > 0 || watch.longestSlow > kLongestSlow ||
            watch.longestWait > kFailTicks + 1 || watch.worstBend > kMostBend ||
            (mode == Mode::Pure && altered > 0)) {
            report.failures.push_back(
                level->name + ", seed " + std::to_string(game.seed()) + ", " +
                std::string(kPlayerNames[static_cast<std::size_t>(player)]) + " player, " +
                std::string(kModeNames[static_cast<std::size_t>(mode)]) + ": escapes " +
                std::to_string(watch.escapes) + ", slow for " + std::to_string(watch.longestSlow) +
                " ticks, nothing damaged for " + std::to_string(watch.longestWait) +
                " ticks, bent by " + std::to_string(watch.worstBend));
        }
    }
    return report;
}

} // namespace apart
