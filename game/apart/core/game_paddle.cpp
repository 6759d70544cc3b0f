// SPDX-License-Identifier: MIT
// Paddle, serve, and the parts that stick to the paddle.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/generator.hpp>
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

// Gap (m) between the paddle and a riding ball, so that they do not touch.
constexpr Real kRideGap = Real(0.05);

/// Width (m) of the balls between the paddle and the wall on one side (-1 or 1), which it would
/// press into the wall. A ball whose centre is above the rim by more than half its radius is lifted
/// instead.
Real widthBetween(const GameState& game, const kodo::Aabb& paddle, Real side) {
    Real width = 0;
    for (const Ball& ball : game.balls) {
        const kodo::BodyView body = game.world[ball.body];
        const Vec2 place = body.position();
        const bool beyond = side < 0 ? place.x < paddle.lower.x : place.x > paddle.upper.x;
        const Real rim = kPaddleY + game.paddle.sway.lift;
        if (!ball.riding && beyond && place.y < rim + kBallRadius / 2 &&
            body.bounds().upper.y > paddle.lower.y) {
            width += body.bounds().upper.x - body.bounds().lower.x;
        }
    }
    return width;
}

Vec2 rideOffset(BallKind kind) {
    return {0, domeHeight(0) + reachOf(kind) + kRideGap};
}

/// Direction of a serve: the first of kServeDraws random ones whose path comes to a block within
/// kServeSeconds, else the one with the shortest path.
Vec2 drawServe(const GameState& game, Vec2 from) {
    Generator chance(mixKeys(game.origin.seed, game.counts.serves, 1));
    Vec2 best{};
    Real shortest = std::numeric_limits<Real>::max();
    for (int draw = 0; draw < kServeDraws; ++draw) {
        const Real slope = chance.between(kServeSlope / 4, kServeSlope);
        const Vec2 heading = normalize(Vec2{chance.below(2) == 0 ? slope : -slope, 1});
        const Real way = game.wayToBlock(from, heading).value_or(shortest);
        if (draw == 0 || way < shortest) {
            best = heading;
            shortest = way;
        }
        if (way <= kServeSeconds * game.ballSpeed()) {
            break;
        }
    }
    return best;
}

} // namespace

void newPaddle(GameState& game) {
    Real x = 0;
    if (game.world.contains(game.paddle.body)) {
        x = game.world[game.paddle.body].position().x;
        game.world.remove(game.paddle.body);
    }
    game.paddle.body = game.world.add(paddleDef(x));
    game.paddle.speed = 0;
    game.paddle.sway = {};
    game.paddle.welds.clear();
}

void newServe(GameState& game) {
    const BallKind kind = game.ballKind();
    const Vec2 place = game.world[game.paddle.body].position() + rideOffset(kind);
    game.paddle.serveHeading = drawServe(game, place);
    ++game.counts.serves;
    const bool hollow = game.origin.mode != Mode::Pure && asksForReturn(*game.origin.level);
    const BodyId ball = addBall(game.world, place, kind);
    game.world[ball].setType(kodo::BodyType::Kinematic);
    game.balls.push_back({ball, game.paddle.serveHeading, true, hollow, kind});
}

void aimServe(GameState& game, std::int16_t aim) {
    if (game.serving()) {
        const std::int16_t held = std::clamp<std::int16_t>(aim, -kMostAim, kMostAim);
        game.paddle.serveHeading = normalize(Vec2{static_cast<Real>(held) / 1000, 1});
    }
}

void serve(GameState& game) {
    for (Ball& ball : game.balls) {
        if (ball.riding) {
            ball.riding = false;
            ball.heading = game.paddle.serveHeading;
            kodo::BodyRef body = game.world[ball.body];
            body.setType(kodo::BodyType::Dynamic);
            if (ball.hollow) {
                body.setMass(kHollowShare * body.mass());
            }
            body.setVelocity(game.ballSpeed() * game.paddle.serveHeading);
            game.paddle.servedFrom = game.world[game.paddle.body].position().x;
            game.paddle.moved = 0;
            game.counts.hit(game.tick, game.beginsBlow(ball));
            game.events.emplace_back(Served{ball.body, body.position(), game.paddle.serveHeading});
        }
    }
}

void leap(GameState& game) {
    if (game.secondsLeft(Power::Spring) > 0 && std::abs(game.paddle.sway.lift) < kLeapReady) {
        game.paddle.sway.liftSpeed = kLeapSpeed;
        game.events.emplace_back(Leapt{game.world[game.paddle.body].position()});
    }
}

void steer(GameState& game, const Input& input) {
    kodo::BodyRef paddle = game.world[game.paddle.body];
    const Vec2 position = paddle.position();
    game.paddle.sway = swayed(game.paddle.sway, game.paddleKind());
    game.paddle.speed = drivenSpeed(input, position.x, game.paddle.speed, paddle.mass());

    // Welded parts must stay inside the field too, and balls must fit between paddle and wall.
    const kodo::Aabb bounds = paddle.bounds();
    const Real left = -kFieldWidth / 2 + widthBetween(game, bounds, -1);
    const Real right = kFieldWidth / 2 - widthBetween(game, bounds, 1);
    const Real roomLeft = std::min(left - bounds.lower.x, Real(0));
    const Real roomRight = std::max(right - bounds.upper.x, Real(0));
    const Real way = std::clamp(game.paddle.speed * kTickSeconds, roomLeft, roomRight);
    game.paddle.moved =
        std::max(game.paddle.moved, std::abs(position.x + way - game.paddle.servedFrom));
    game.paddle.speed = way / kTickSeconds;

    const kodo::Transform target{{position.x + way, kPaddleY + game.paddle.sway.lift},
                                 kodo::Rot::fromAngle(game.paddle.sway.tilt)};
    paddle.moveTo(target.position, target.rotation, kTickSeconds);
    for (const Ball& ball : game.balls) {
        if (ball.riding) {
            game.world[ball.body].moveTo(target * rideOffset(ball.kind), kTickSeconds);
        }
    }
    for (const Part& part : game.parts) {
        if (part.state == PartState::Stuck) {
            game.world[part.body].moveTo(target * part.offset, kTickSeconds);
        }
    }
}

void fireParts(GameState& game) {
    for (Part& part : game.parts) {
        kodo::BodyRef body = game.world[part.body];
        if (part.state == PartState::Stuck && game.tick - part.sinceTick >= kStickTicks) {
            part.state = PartState::Launched;
            part.sinceTick = game.tick;
            // From now on it collides with blocks only, not with other bodies or the top wall.
            body.setType(kodo::BodyType::Dynamic);
            body.setFlags(flagsOf(Role::Part) | kodo::kLockRotate | kodo::kMatchAny);
            body.setRequired(static_cast<std::uint16_t>(flagsOf(Role::Block)));
            body.setMaterial(kodo::withFriction(0, 0));
            body.setAngularVelocity(0);
            game.events.emplace_back(Launched{part.body, body.position()});
        }
        if (part.state == PartState::Launched) { // the drive restores the speed lost in impacts
            drive(body, {0, kLaunchSpeed}, game.ledger.kickWork);
        }
    }
}

void drive(kodo::BodyRef body, Vec2 velocity, double& work) {
    const Real gained = lengthSquared(velocity) - lengthSquared(body.velocity());
    work += static_cast<double>(body.mass() * gained / 2);
    body.setVelocity(velocity);
}

void letGoOfParts(GameState& game) {
    for (Part& part : game.parts) {
        if (part.state == PartState::Stuck) {
            part.state = PartState::Loose;
            part.sinceTick = game.tick;
            kodo::BodyRef body = game.world[part.body];
            body.setType(kodo::BodyType::Dynamic);
            body.setFlags(flagsOf(Role::Part) | kFalls);
            body.setMaterial(kPartMaterial);
        }
    }
}

} // namespace apart
