// SPDX-License-Identifier: MIT
// Applies the governor to the balls.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/governor.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

static void governBall(GameState& game, Ball& ball);
static void keepInside(GameState& game, const Ball& ball);
static void limitSpeed(GameState& game, const Ball& ball);

void govern(GameState& game) {
    for (Ball& ball : game.balls) {
        if (!ball.riding) {
            keepInside(game, ball);
            limitSpeed(game, ball);
            governBall(game, ball);
        }
    }
}

void governBall(GameState& game, Ball& ball) {
    std::vector<Vec2> normals; // towards the ball
    bool touching = false;     // also while it leaves an overlap without an impulse
    bool rubble = false;
    bool carried = false;
    for (const kodo::CollisionRecord& hit : game.world.collisions()) {
        if (!hit.involves(ball.body)) {
            continue;
        }
        touching = touching || hit.maxImpulse > 0 || hit.separation < 0;
        if (hit.maxImpulse > 0) {
            normals.push_back(hit.b == ball.body ? hit.normal : -hit.normal);
            rubble = rubble || game.isRubble(hit.other(ball.body));
            carried = carried || game.canCarry(hit.other(ball.body));
        }
    }
    const bool idle = ball.hollow || game.clock.idleTicks() > kQuickTicks;
    const bool quick =
        idle && game.origin.mode != Mode::Pure && game.world[ball.body].position().y > kQuickHeight;
    const Real target = quick ? kQuickFactor * game.ballSpeed() : game.ballSpeed();
    const bool slow = length(game.world[ball.body].velocity()) < kSwallowed * game.ballSpeed();
    ball.carriedTicks = !slow ? 0 : carried ? ball.carriedTicks + 1 : ball.carriedTicks;
    rubble = rubble || (carried && ball.carriedTicks > kCarriedTicks);
    kodo::BodyRef body = game.world[ball.body];
    const Vec2 velocity = body.velocity();
    Vec2 next = velocity;
    if (!touching || (normals.empty() && slow)) { // or slides along a wall without an impulse
        next = servoVelocity(velocity, ball.heading, target);
        const Real spin = body.angularVelocity();
        if (std::abs(spin) > kMostSpin) {
            body.setAngularVelocity(spin < 0 ? -kMostSpin : kMostSpin);
            game.ledger.servoWork +=
                static_cast<double>(body.inertia() * (kMostSpin * kMostSpin - spin * spin) / 2);
        }
    } else if (!normals.empty()) {
        ++game.ledger.bounces;
        if (game.origin.mode != Mode::Pure) {
            const Vec2 thrown =
                rubble ? throwOff(velocity, ball.heading, normals, game.ballSpeed()) : velocity;
            next = turnedFromFlat(thrown, normals);
            if (next != thrown &&
                game.meetsBlock(body.position(), kFieldWidth * normalize(thrown))) {
                next = thrown; // flat, but it hits a block
            }
            game.ledger.thrownBounces += thrown == velocity ? 0 : 1;
            game.ledger.bentBounces += next == thrown ? 0 : 1;
        }
        if (length(next) < kSwallowed * game.ballSpeed()) {
            // Slowed by rubble, or by a wind that presses it against a surface. The servo raises
            // the speed and keeps the direction.
            next = servoVelocity(next, ball.heading, game.ballSpeed());
        }
    }
    if (next != velocity) {
        drive(body, next, game.ledger.servoWork);
    }
    if (length(next) >= kHaltSpeed) {
        ball.heading = normalize(next);
    }
}

/// Moves a ball that has been pressed deep into a wall back into the field.
void keepInside(GameState& game, const Ball& ball) {
    kodo::BodyRef body = game.world[ball.body];
    const kodo::Aabb bounds = body.bounds();
    const Real left = -kFieldWidth / 2 - bounds.lower.x; // overlaps (m)
    const Real right = bounds.upper.x - kFieldWidth / 2;
    const Real top = bounds.upper.y - kFieldHeight;
    const Vec2 in{left > kMostPressed    ? left
                  : right > kMostPressed ? -right
                                         : Real(0),
                  top > kMostPressed ? -top : Real(0)};
    if (in == Vec2{}) {
        return;
    }
    body.setPosition(body.position() + in);
    Vec2 velocity = body.velocity();
    velocity.x = in.x == 0 ? velocity.x : std::copysign(velocity.x, in.x);
    velocity.y = in.y == 0 ? velocity.y : -std::abs(velocity.y);
    body.setVelocity(velocity);
}

/// A ball between paddle and wall, or between two bars, bounces many times in one tick.
void limitSpeed(GameState& game, const Ball& ball) {
    kodo::BodyRef body = game.world[ball.body];
    const Real most = kMostBallFactor * game.ballSpeed();
    const Real speed = length(body.velocity());
    if (speed > most) {
        drive(body, (most / speed) * body.velocity(), game.ledger.servoWork);
    }
}

} // namespace apart
