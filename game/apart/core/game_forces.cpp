// SPDX-License-Identifier: MIT
// Force field and magnet of the paddle. The paddle receives the opposite impulse.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

static Vec2 draw(GameState& game, BodyId body, Vec2 center, Real acceleration, Real reach);
static void pushPaddleBack(GameState& game, Vec2 impulse);
static Vec2 tear(GameState& game, Vec2 center);

void useForce(GameState& game, const Input& input) {
    const bool begun = game.counts.hits > 0 || !game.serving(); // by the first serve
    const bool wanted = begun && input.force != Force::None && game.result == Result::Playing;
    // Hysteresis: a field that started at an almost empty meter would flicker.
    const bool enough = input.force == game.paddle.field.force
                            ? game.paddle.field.meter > 0
                            : game.paddle.field.meter >= kMeterStart;
    const Force next = wanted && enough ? input.force : Force::None;
    if (next != game.paddle.field.force) {
        game.paddle.field.force = next;
        game.events.emplace_back(ForceChanged{next});
    }
    if (game.paddle.field.force != Force::None) {
        game.paddle.field.meter =
            std::max(game.paddle.field.meter - kTickSeconds / kMeterSeconds, Real(0));
        return;
    }
    const Real hurry = game.patience() == Patience::Calm ? Real(1) : kHurry;
    game.paddle.field.meter =
        std::min(game.paddle.field.meter + hurry * kTickSeconds / kRefillSeconds, Real(1));
}

Vec2 draw(GameState& game, BodyId body, Vec2 center, Real acceleration, Real reach) {
    kodo::BodyRef drawn = game.world[body];
    const Vec2 way = center - drawn.center();
    const Real distance = length(way);
    if (distance >= reach || distance <= 0) {
        return {};
    }
    const Real share = (1 - distance / reach) / distance;
    const Vec2 force = drawn.mass() * acceleration * share * way;
    drawn.applyForce(force);
    const bool falls = (drawn.flags() & kFalls) != 0;
    const Vec2 gained = kTickSeconds * (force / drawn.mass() - Vec2{0, falls ? kGravity : 0});
    game.ledger.fieldWork +=
        static_cast<double>(kTickSeconds * dot(force, drawn.velocity() + gained / 2));
    return kTickSeconds * force;
}

void applyForces(GameState& game) {
    const bool magnet = game.secondsLeft(Power::Magnet) > 0;
    if (game.paddle.field.force == Force::None && !magnet) {
        return;
    }
    const Vec2 center = game.world[game.paddle.body].position();
    const Real pull = game.paddle.field.force == Force::None   ? Real(0)
                      : game.paddle.field.force == Force::Pull ? kForceAcceleration
                                                               : -kForceAcceleration;
    Vec2 given;
    const auto use = [&](BodyId body, bool magnetic) {
        if (pull != 0) {
            given += draw(game, body, center, pull, kForceReach);
        }
        if (magnet && magnetic) {
            given += draw(game, body, center, kMagnetAcceleration, kMagnetReach);
        }
    };
    for (const Ball& ball : game.balls) {
        if (!ball.riding) {
            use(ball.body, true);
        }
    }
    for (const Part& part : game.parts) {
        if (part.state == PartState::Loose) {
            use(part.body, true);
        }
    }
    for (const Shard& shard : game.shards) {
        use(shard.body, false);
    }
    for (const Block& block : game.blocks) {
        if (block.support == Support::Loose || block.support == Support::Hanging ||
            block.support == Support::Fallen) {
            use(block.body, false);
        }
    }
    if (game.tears()) {
        given += tear(game, center);
    }
    pushPaddleBack(game, given);
}

/// One tick of the pull on the mount of nextToFall(), which fails once the free block would move at
/// kTornSpeed. Returns the impulse (N s) that the mount took.
Vec2 tear(GameState& game, Vec2 center) {
    const Block* block = game.nextToFall();
    const Vec2 way = center - game.frameOf(*block).position;
    const Real share = std::max(1 - length(way) / kForceReach, Real(0));
    const Real gained = kForceAcceleration * share * kTickSeconds;
    game.paddle.field.tornSpeed += gained;
    if (block->support == Support::Hanging) {
        return {}; // draw(game) acts on it, as on loose blocks
    }
    const Real mass = block->ownsBody() ? game.world[block->body].mass()
                                        : densityOf(block->kind) * kCellWidth * kCellHeight;
    return mass * gained * normalize(way);
}

void pushPaddleBack(GameState& game, Vec2 impulse) {
    game.ledger.fieldImpulseX += static_cast<double>(impulse.x);
    game.ledger.fieldImpulseY += static_cast<double>(impulse.y);
    const Real mass = game.world[game.paddle.body].mass();
    game.paddle.speed -= impulse.x / mass;
    if (recoils(game.paddleKind())) {
        game.paddle.sway.liftSpeed -= impulse.y / mass; // otherwise the carriage takes it
    }
}

} // namespace apart
