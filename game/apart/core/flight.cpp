// SPDX-License-Identifier: MIT
#include <apart/core/field.hpp>
#include <apart/core/flight.hpp>
#include <apart/core/governor.hpp>
#include <apart/core/tuning.hpp>
#include <kodo/query.hpp>

#include <algorithm>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr int kLegSteps = 90;     // of LoneFlight, at most
constexpr Real kOff = Real(0.01); // m; distance from the surface after a bounce

} // namespace

bool isBent(const Game& game) {
    const auto effects = game.effects();
    return !game.level().wells.empty() || game.state().windSpeed() != 0 ||
           std::any_of(effects.begin(), effects.end(),
                       [](const Effect& effect) { return effect.power == Power::Well; });
}

LoneFlight::LoneFlight(const Game& game, Vec2 place, Vec2 heading, Vec2 velocity)
    : heading_(heading), speed_(game.state().ballSpeed()) {
    world_.setFields(game.world().fields());
    for (const kodo::BodyDef& def : wallDefs()) {
        world_.add(def);
    }
    ball_ = addBall(world_, place, BallKind::Round);
    world_[ball_].setVelocity(velocity);
}

void LoneFlight::step() {
    world_.step(kStep);
    kodo::BodyRef body = world_[ball_];
    body.setVelocity(servoVelocity(body.velocity(), heading_, speed_));
}

std::vector<Vec2> servePath(const Game& game) {
    const auto balls = game.balls();
    const auto riding =
        std::find_if(balls.begin(), balls.end(), [](const Ball& ball) { return ball.riding; });
    if (riding == balls.end()) {
        return {};
    }
    Vec2 heading = game.serveHeading();
    std::vector<Vec2> leg = {game.world()[riding->body].position()};
    if (!isBent(game)) {
        Vec2 from = leg[0];
        for (int bounces = game.mode() == Mode::Assisted ? kAssistedBounces : 0;; --bounces) {
            const Vec2 way = kFarSight * heading;
            const std::optional<kodo::QueryHit> hit = game.state().ahead(from, way);
            leg.push_back(from + (hit ? hit->fraction : Real(1)) * way);
            if (bounces == 0 || !hit) {
                return leg;
            }
            from = leg.back() + kOff * hit->normal;
            heading -= 2 * dot(heading, hit->normal) * hit->normal;
        }
    }
    LoneFlight flight(game, leg[0], heading, game.state().ballSpeed() * heading);
    for (int step = 0; step < kLegSteps; ++step) {
        flight.step();
        const Vec2 way = flight.place() - leg.back();
        const std::optional<kodo::QueryHit> hit = game.state().ahead(leg.back(), way);
        leg.push_back(leg.back() + (hit ? hit->fraction : Real(1)) * way);
        if (hit) {
            break;
        }
    }
    return leg;
}

} // namespace apart
