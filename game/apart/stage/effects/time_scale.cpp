// SPDX-License-Identifier: MIT
#include <apart/stage/effects/juice.hpp>
#include <apart/stage/effects/time_scale.hpp>

#include <algorithm>

namespace apart {

namespace {

constexpr kodo::Real kNear = 4; // m, between ball and block
constexpr double kSlow = 0.3;   // relative to real time, at full setting
constexpr double kBrake = 6;    // 1/s
constexpr double kPatience = 4; // s of slow motion per level

// A collapse in slow motion.
constexpr double kFallSlow = 0.45;   // relative to real time, at full setting
constexpr double kFallSeconds = 1.0; // s of it per collapse

// Hit-freeze at full setting.
constexpr double kLongestFreeze = 0.06; // s, at the strongest impact
constexpr double kFreezePause = 0.3;    // s, minimum between two, so that a chain of breaks keeps
                                        // moving

bool aboutToFinish(const Game& game) {
    if (game.blocksLeft() != 1 || game.result() != Result::Playing) {
        return false;
    }
    for (const Block& block : game.blocks()) {
        if (!block.kind.breakable()) {
            continue;
        }
        const kodo::Vec2 place = game.world()[block.body].center();
        for (const Ball& ball : game.balls()) {
            const kodo::BodyView body = game.world()[ball.body];
            const kodo::Vec2 way = place - body.center();
            if (!ball.riding && length(way) < kNear && dot(way, body.velocity()) > 0) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

double TimeScale::next(const Game& game, double seconds) {
    if (game.ticks() < 2) {
        *this = {}; // new game
    }
    const bool slow = aboutToFinish(game) && slowSeconds_ < kPatience;
    slowSeconds_ += slow ? seconds : 0;
    fallSeconds_ = game.collapse().blocks == 0 ? 0 : fallSeconds_;
    const bool falls = game.collapse().blocks >= kLargeCollapse && fallSeconds_ < kFallSeconds;
    fallSeconds_ += falls ? seconds : 0;
    const double slowest = slow ? kSlow : falls ? kFallSlow : 1;
    const double goal = 1 - (1 - slowest) * slowShare_;
    timeScale_ += std::min(kBrake * seconds, 1.0) * (goal - timeScale_);
    freezePause_ -= seconds;
    if (freezeLeft_ > 0) {
        freezeLeft_ -= seconds;
        return 0;
    }
    return timeScale_;
}

void TimeScale::tick(const Game& game, const Settings& settings) {
    slowShare_ = static_cast<double>(share(settings.slow));
    for (const Event& event : game.events()) {
        const auto* broke = std::get_if<Broke>(&event);
        if (broke != nullptr && freezePause_ <= 0 && settings.freeze > 0) {
            const float strength = weightOf(broke->impulse) * share(settings.freeze);
            freezeLeft_ = kLongestFreeze * static_cast<double>(strength);
            freezePause_ = kFreezePause;
        }
    }
}

} // namespace apart
