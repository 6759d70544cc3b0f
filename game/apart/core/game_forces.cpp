// SPDX-License-Identifier: MIT
// Force field and magnet of the paddle. The paddle receives the opposite impulse.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

void Game::useForce(const Input& input) {
    const bool wanted = input.force != Force::None && result_ == Result::Playing;
    // Hysteresis: a field that started at an almost empty meter would flicker.
    const bool enough = input.force == force_ ? meter_ > 0 : meter_ >= kMeterStart;
    const Force next = wanted && enough ? input.force : Force::None;
    if (next != force_) {
        force_ = next;
        events_.emplace_back(ForceChanged{next});
    }
    if (force_ != Force::None) {
        meter_ = std::max(meter_ - kTickSeconds / kMeterSeconds, Real(0));
        return;
    }
    const Real hurry = patience() == Patience::Calm ? Real(1) : kHurry;
    meter_ = std::min(meter_ + hurry * kTickSeconds / kRefillSeconds, Real(1));
}

Vec2 Game::draw(BodyId body, Vec2 center, Real acceleration, Real reach) {
    kodo::BodyRef drawn = world_[body];
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
    ledger_.fieldWork +=
        static_cast<double>(kTickSeconds * dot(force, drawn.velocity() + gained / 2));
    return kTickSeconds * force;
}

void Game::applyForces() {
    const bool magnet = secondsLeft(Power::Magnet) > 0;
    if (force_ == Force::None && !magnet) {
        return;
    }
    const Vec2 center = world_[paddle_].position();
    const Real pull = force_ == Force::None   ? Real(0)
                      : force_ == Force::Pull ? kForceAcceleration
                                              : -kForceAcceleration;
    Vec2 given;
    const auto use = [&](BodyId body, bool magnetic) {
        if (pull != 0) {
            given += draw(body, center, pull, kForceReach);
        }
        if (magnet && magnetic) {
            given += draw(body, center, kMagnetAcceleration, kMagnetReach);
        }
    };
    for (const Ball& ball : balls_) {
        if (!ball.riding) {
            use(ball.body, true);
        }
    }
    for (const Part& part : parts_) {
        if (part.state == PartState::Loose) {
            use(part.body, true);
        }
    }
    for (const Shard& shard : shards_) {
        use(shard.body, false);
    }
    for (const Block& block : blocks_) {
        if (block.support == Support::Loose || block.support == Support::Hanging ||
            block.support == Support::Fallen) {
            use(block.body, false);
        }
    }
    if (tears()) {
        given += tear(center);
    }
    pushPaddleBack(given);
}

bool Game::tears() const {
    return force_ == Force::Pull && patience() != Patience::Calm && !serving() &&
           nextToFall() != nullptr;
}

/// One tick of the pull on the mount of nextToFall(), which fails once the free block would move at
/// kTornSpeed. Returns the impulse (N s) that the mount took.
Vec2 Game::tear(Vec2 center) {
    const Block* block = nextToFall();
    const Vec2 way = center - frameOf(*block).position;
    const Real share = std::max(1 - length(way) / kForceReach, Real(0));
    const Real gained = kForceAcceleration * share * kTickSeconds;
    tornSpeed_ += gained;
    if (block->support == Support::Hanging) {
        return {}; // draw() acts on it, as on loose blocks
    }
    const Real mass = block->ownsBody() ? world_[block->body].mass()
                                        : densityOf(block->kind) * kCellWidth * kCellHeight;
    return mass * gained * normalize(way);
}

void Game::pushPaddleBack(Vec2 impulse) {
    ledger_.fieldImpulseX += static_cast<double>(impulse.x);
    ledger_.fieldImpulseY += static_cast<double>(impulse.y);
    const Real mass = world_[paddle_].mass();
    paddleSpeed_ -= impulse.x / mass;
    if (recoils(paddleKind())) {
        sway_.liftSpeed -= impulse.y / mass; // otherwise the carriage takes it
    }
}

} // namespace apart
