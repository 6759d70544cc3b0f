// SPDX-License-Identifier: MIT
// Applies the governor to the balls.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/governor.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

void Game::govern() {
    for (Ball& ball : balls_) {
        if (!ball.riding) {
            governBall(ball);
        }
    }
}

void Game::governBall(Ball& ball) {
    std::vector<Vec2> normals; // towards the ball
    bool touching = false;     // also while it leaves an overlap without an impulse
    bool rubble = false;
    bool carried = false;
    for (const kodo::CollisionRecord& hit : world_.collisions()) {
        if (!hit.involves(ball.body)) {
            continue;
        }
        touching = touching || hit.maxPointImpulse() > 0 || hit.separation < 0;
        if (hit.maxPointImpulse() > 0) {
            normals.push_back(hit.b == ball.body ? hit.normal : -hit.normal);
            rubble = rubble || isRubble(hit.other(ball.body));
            carried = carried || canCarry(hit.other(ball.body));
        }
    }
    const bool quick = clock_.idleTicks() > kQuickTicks && mode_ == Mode::Standard &&
                       world_[ball.body].position().y > kQuickHeight;
    const Real target = quick ? kQuickFactor * ballSpeed() : ballSpeed();
    const bool slow = length(world_[ball.body].velocity()) < kSwallowed * ballSpeed();
    ball.carriedTicks = !slow ? 0 : carried ? ball.carriedTicks + 1 : ball.carriedTicks;
    rubble = rubble || (carried && ball.carriedTicks > kCarriedTicks);
    kodo::BodyRef body = world_[ball.body];
    const Vec2 velocity = body.velocity();
    Vec2 next = velocity;
    if (!touching || (normals.empty() && slow)) { // or slides along a wall without an impulse
        next = servoVelocity(velocity, ball.heading, target);
        const Real spin = body.angularVelocity();
        if (std::abs(spin) > kMostSpin) {
            body.setAngularVelocity(spin < 0 ? -kMostSpin : kMostSpin);
            ledger_.servoWork +=
                static_cast<double>(body.inertia() * (kMostSpin * kMostSpin - spin * spin) / 2);
        }
    } else if (!normals.empty()) {
        ++ledger_.bounces;
        if (mode_ == Mode::Standard) {
            const Vec2 thrown =
                rubble ? throwOff(velocity, ball.heading, normals, ballSpeed()) : velocity;
            next = turnedFromFlat(thrown, normals);
            if (next != thrown && meetsBlock(body.position(), kFieldWidth * normalize(thrown))) {
                next = thrown; // flat, but it hits a block
            }
            ledger_.thrownBounces += thrown == velocity ? 0 : 1;
            ledger_.bentBounces += next == thrown ? 0 : 1;
        }
        if (length(next) < kSwallowed * ballSpeed()) {
            // Slowed by rubble, or by a wind that presses it against a surface. The servo raises
            // the speed and keeps the direction.
            next = servoVelocity(next, ball.heading, ballSpeed());
        }
    }
    if (next != velocity) {
        drive(body, next, ledger_.servoWork);
    }
    if (length(next) >= kHaltSpeed) {
        ball.heading = normalize(next);
    }
}

std::optional<kodo::QueryHit> Game::ahead(Vec2 from, Vec2 way) const {
    constexpr Real kSlim = Real(0.9); // share of the radius: the ball may touch a surface
    const auto what = static_cast<std::uint16_t>(flagsOf(Role::Wall) | flagsOf(Role::Block) |
                                                 flagsOf(Role::Obstruction));
    return shapeCast(world_, kodo::Circle{kSlim * kBallRadius}, {from, {}}, way,
                     {kodo::kMatchAny, what});
}

bool Game::meetsBlock(Vec2 from, Vec2 way) const {
    const std::optional<kodo::QueryHit> hit = ahead(from, way);
    const Block* block = hit ? findBlock(hit->body, hit->part) : nullptr;
    return block != nullptr && block->counts();
}

bool Game::canCarry(BodyId body) const {
    if (!world_.contains(body)) {
        return false;
    }
    const kodo::BodyView view = world_[body];
    const Role role = roleOf(view.flags());
    return (role == Role::Obstruction || role == Role::Block) &&
           view.type() == kodo::BodyType::Dynamic;
}

bool Game::isRubble(BodyId body) const {
    if (!world_.contains(body)) {
        return false;
    }
    const kodo::Flags flags = world_[body].flags();
    const Role role = roleOf(flags);
    // A block of a building falls as rubble does.
    return role == Role::Shard || role == Role::Part ||
           (role == Role::Block && (flags & kStands) != 0);
}

} // namespace apart
