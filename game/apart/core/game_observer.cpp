// SPDX-License-Identifier: MIT
#include <apart/core/game_observer.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr std::uint32_t kSlowTicks = kTicksPerSecond / 2; // limit between rubble and paddle
// Largest sine of the turn in one tick that rounding explains. The servo scales both coordinates,
// each with a relative error of 2^-24 in float. A close contact without an impulse adds as little.
constexpr Real kStraight = Real(2e-6);

bool touches(const Game& game, kodo::BodyId ball) {
    const auto hits = game.world().collisions();
    return std::any_of(hits.begin(), hits.end(), [&](const kodo::CollisionRecord& hit) {
        return hit.involves(ball) && (hit.maxImpulse > 0 || hit.separation < 0);
    });
}

/// True if a force field or the magnet acts on balls, so that their paths may bend.
bool isPulled(const Game& game) {
    const auto effects = game.effects();
    return game.force() != Force::None || game.state().windSpeed() != 0 ||
           !game.level().wells.empty() ||
           std::any_of(effects.begin(), effects.end(), [](const Effect& effect) {
               return effect.power == Power::Magnet || effect.power == Power::Well ||
                      effect.power == Power::Wind;
           });
}

bool isOutside(Vec2 place) {
    return std::abs(place.x) > kFieldWidth / 2 || place.y > kFieldHeight;
}

} // namespace

void Observations::add(const Observations& other) {
    ticks += other.ticks;
    freeTicks += other.freeTicks;
    halts += other.halts;
    escapes += other.escapes;
    bends += other.bends;
    longestWait = std::max(longestWait, other.longestWait);
}

void GameObserver::observe(const Game& game) {
    ++observations_.ticks;
    const bool pulled = isPulled(game);
    free_ = !pulled && !pulled_; // a field that ended in this tick may have acted in it
    pulled_ = pulled;
    next_.clear();
    observations_.escapes += static_cast<std::uint32_t>(game.world().frozenBodies().size());
    for (const Ball& ball : game.balls()) {
        if (!ball.riding) {
            const auto before = std::find_if(tracks_.begin(), tracks_.end(),
                                             [&](const Track& t) { return t.body == ball.body; });
            follow(game, ball, before == tracks_.end() ? nullptr : &*before);
        }
    }
    tracks_.swap(next_);
    count(game);
}

void GameObserver::follow(const Game& game, const Ball& ball, const Track* before) {
    const kodo::BodyView body = game.world()[ball.body];
    Track now{ball.body, body.velocity()};
    const Real speed = length(now.velocity);
    if (speed < game.state().ballSpeed() / 2) {
        now.slowTicks = before != nullptr ? before->slowTicks + 1 : 1;
        observations_.halts += now.slowTicks == kSlowTicks ? 1 : 0;
    }
    if (isOutside(body.position())) {
        ++observations_.escapes;
    }
    // A ball below kHaltSpeed restarts along its last heading, which is no bend.
    const bool flew = before != nullptr && length(before->velocity) >= kHaltSpeed;
    if (flew && free_ && !touches(game, ball.body)) {
        ++observations_.freeTicks;
        const Real turn = std::abs(cross(before->velocity, now.velocity));
        const bool back = dot(before->velocity, now.velocity) < 0;
        if (back || turn > kStraight * length(before->velocity) * speed) {
            ++observations_.bends;
        }
    }
    next_.push_back(now);
}

void GameObserver::count(const Game& game) {
    bool progress = tracks_.empty();
    for (const Event& event : game.events()) {
        progress = progress || std::holds_alternative<Cracked>(event) ||
                   std::holds_alternative<Broke>(event) || std::holds_alternative<LetGo>(event);
    }
    wait_ = progress || game.result() != Result::Playing ? 0 : wait_ + 1;
    observations_.longestWait = std::max(observations_.longestWait, wait_);
}

} // namespace apart
