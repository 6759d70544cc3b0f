// SPDX-License-Identifier: MIT
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/paddle.hpp>
#include <apart/core/tuning.hpp>
#include <kodo/state_hash.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

// Gap (m) between the paddle and a riding ball, so that they do not touch.
constexpr Real kRideGap = Real(0.05);

Vec2 rideOffset(BallKind kind) {
    return {0, domeHeight(0) + reachOf(kind) + kRideGap};
}

} // namespace

Game::Game(const Level& level, std::uint32_t seed, Mode mode)
    : Game(std::make_shared<const Level>(level), seed, mode) {}

Game::Game(std::shared_ptr<const Level> level, std::uint32_t seed, Mode mode)
    : level_(std::move(level)), seed_(seed), mode_(mode), lives_(level_->lives) {
    buildField();
    buildBlocks();
    buildBoss();
    buildObstructions();
    buildFreeBlocks();
    buildLinks();
    newPaddle();
    newServe();
}

void Game::newPaddle() {
    Real x = 0;
    if (world_.contains(paddle_)) {
        x = world_[paddle_].position().x;
        world_.remove(paddle_);
    }
    paddle_ = world_.add(paddleDef(x));
    paddleSpeed_ = 0;
    sway_ = {};
    welds_.clear();
}

void Game::newServe() {
    Generator chance(mixKeys(seed_, serves_, 1));
    ++serves_;
    const Real slope = chance.between(kServeSlope / 4, kServeSlope);
    serveHeading_ = normalize(Vec2{chance.below(2) == 0 ? slope : -slope, 1});
    const BallKind kind = ballKind();
    const BodyId ball = addBall(world_, world_[paddle_].position() + rideOffset(kind), kind);
    world_[ball].setType(kodo::BodyType::Kinematic);
    balls_.push_back({ball, serveHeading_, true, kind});
}

void Game::serve() {
    for (Ball& ball : balls_) {
        if (ball.riding) {
            ball.riding = false;
            ball.heading = serveHeading_;
            kodo::BodyRef body = world_[ball.body];
            body.setType(kodo::BodyType::Dynamic);
            body.setVelocity(ballSpeed() * serveHeading_);
            events_.emplace_back(Served{ball.body, body.position(), serveHeading_});
        }
    }
}

void Game::tick(const Input& input) {
    events_.clear();
    ++tick_;
    if (input.launch && result_ == Result::Playing) {
        serving() ? serve() : leap();
    }
    endOldPowers();
    useForce(input);
    applyForces();
    steer(input);
    driveBoss();
    fireParts();
    world_.step(kTickSeconds);
    judge();
    govern();
    watchBuildings();
    watchProgress();
    removeGone();
    conclude();
}

void Game::leap() {
    if (secondsLeft(Power::Spring) > 0 && std::abs(sway_.lift) < kLeapReady) {
        sway_.liftSpeed = kLeapSpeed;
        events_.emplace_back(Leapt{world_[paddle_].position()});
    }
}

void Game::steer(const Input& input) {
    kodo::BodyRef paddle = world_[paddle_];
    const Vec2 position = paddle.position();
    sway_ = swayed(sway_, paddleKind());
    paddleSpeed_ = drivenSpeed(input, position.x, paddleSpeed_, paddle.mass());

    // Welded parts must stay inside the field too.
    const kodo::Aabb bounds = paddle.bounds();
    const Real roomLeft = std::min(-kFieldWidth / 2 - bounds.lower.x, Real(0));
    const Real roomRight = std::max(kFieldWidth / 2 - bounds.upper.x, Real(0));
    const Real way = std::clamp(paddleSpeed_ * kTickSeconds, roomLeft, roomRight);
    paddleSpeed_ = way / kTickSeconds;

    const kodo::Transform target{{position.x + way, kPaddleY + sway_.lift},
                                 kodo::Rot::fromAngle(sway_.tilt)};
    paddle.moveTo(target.position, target.rotation, kTickSeconds);
    for (const Ball& ball : balls_) {
        if (ball.riding) {
            world_[ball.body].moveTo(target * rideOffset(ball.kind), kTickSeconds);
        }
    }
    for (const Part& part : parts_) {
        if (part.state == PartState::Stuck) {
            world_[part.body].moveTo(target * part.offset, kTickSeconds);
        }
    }
}

void Game::fireParts() {
    for (Part& part : parts_) {
        kodo::BodyRef body = world_[part.body];
        if (part.state == PartState::Stuck && tick_ - part.sinceTick >= kStickTicks) {
            part.state = PartState::Launched;
            part.sinceTick = tick_;
            // From now on it collides with blocks only, not with other bodies or the top wall.
            body.setType(kodo::BodyType::Dynamic);
            body.setFlags(flagsOf(Role::Part) | kodo::kLockRotate | kodo::kMatchAny);
            body.setRequired(static_cast<std::uint16_t>(flagsOf(Role::Block)));
            body.setMaterial(kodo::withFriction(0, 0));
            body.setAngularVelocity(0);
            events_.emplace_back(Launched{part.body, body.position()});
        }
        if (part.state == PartState::Launched) { // the drive restores the speed lost in impacts
            drive(body, {0, kLaunchSpeed}, ledger_.kickWork);
        }
    }
}

void Game::drive(kodo::BodyRef body, Vec2 velocity, double& work) {
    const Real gained = lengthSquared(velocity) - lengthSquared(body.velocity());
    work += static_cast<double>(body.mass() * gained / 2);
    body.setVelocity(velocity);
}

void Game::conclude() {
    if (result_ != Result::Playing) {
        return;
    }
    if (blocksLeft_ == 0) {
        endCollapse();
        result_ = Result::Won;
        score_ += lives_ * kLifePoints;
        events_.emplace_back(Cleared{score_});
    } else if (balls_.empty()) {
        --lives_;
        combo_ = 0; // a combo ends with the last ball
        events_.emplace_back(LifeLost{lives_});
        if (lives_ == 0) {
            result_ = Result::Lost;
            events_.emplace_back(Lost{score_});
            return;
        }
        letGoOfParts();
        while (!effects_.empty()) {
            endPower(effects_.size() - 1);
        }
        refreshPowers();
        newPaddle();
        newServe();
    }
}

const Block* Game::findBlock(BodyId body, std::size_t part) const {
    const auto found = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& block) {
        return block.body == body && (block.ownsBody() || block.part == part);
    });
    return found == blocks_.end() ? nullptr : &*found;
}

bool Game::serving() const {
    return std::any_of(balls_.begin(), balls_.end(), [](const Ball& ball) { return ball.riding; });
}

Real Game::ballSpeed() const {
    const auto broken = static_cast<Real>(blocksAtStart_ - blocksLeft_);
    const Real share = blocksAtStart_ > 0 ? broken / static_cast<Real>(blocksAtStart_) : Real(0);
    return static_cast<Real>(level_->ballSpeed) / 1000 * (1 + kSpeedUp * share);
}

} // namespace apart
