// SPDX-License-Identifier: MIT
// Timed powers.
#include <apart/core/field.hpp>
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <memory>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

std::optional<BallKind> ballKindOf(Power power) {
    switch (power) {
    case Power::Heavy:
        return BallKind::Heavy;
    case Power::Lopsided:
        return BallKind::Lopsided;
    case Power::Egg:
        return BallKind::Egg;
    case Power::Rough:
        return BallKind::Rough;
    default:
        return std::nullopt;
    }
}

bool movesAir(Power power) {
    return power == Power::Well || power == Power::Wind;
}

// Bodies that force fields act on.
constexpr kodo::CollisionFilter kFlying{kodo::kMatchAny,
                                        static_cast<std::uint16_t>(flagsOf(Role::Ball) | kFalls)};

kodo::FieldEntry wellField(Vec2 place, Real strength) {
    return {std::make_shared<kodo::Attractor>(kodo::Attractor::Law::InverseSquare, place, strength,
                                              kWellSoftening),
            kFlying};
}

} // namespace

void Game::beginPower(Power power, Vec2 point, Vec2 origin) {
    if (ballKindOf(power)) { // all balls have one kind
        for (std::size_t i = effects_.size(); i-- > 0;) {
            if (ballKindOf(effects_[i].power) && effects_[i].power != power) {
                endPower(i);
            }
        }
    }
    const auto same = std::find_if(effects_.begin(), effects_.end(),
                                   [&](const Effect& effect) { return effect.power == power; });
    const int side = Generator(mixKeys(seed_, tick_, 3)).below(2) == 0 ? 1 : -1;
    const Effect effect{power, tick_ + (movesAir(power) ? kBriefTicks : kEffectTicks), origin,
                        side};
    if (same == effects_.end()) {
        effects_.push_back(effect);
    } else {
        *same = effect;
    }
    fieldsStale_ = fieldsStale_ || movesAir(power);
    events_.emplace_back(PowerBegan{power, point, effect.untilTick});
}

void Game::endPower(std::size_t effect) {
    const Power power = effects_[effect].power;
    effects_.erase(effects_.begin() + static_cast<std::ptrdiff_t>(effect));
    fieldsStale_ = fieldsStale_ || movesAir(power);
    events_.emplace_back(PowerEnded{power});
}

void Game::endOldPowers() {
    for (std::size_t i = effects_.size(); i-- > 0;) {
        if (effects_[i].untilTick <= tick_) {
            endPower(i);
        }
    }
    refreshPowers();
}

void Game::refreshPowers() {
    reshapeBalls();
    if (fieldsStale_) {
        renewFields();
    }
}

void Game::reshapeBalls() {
    const BallKind kind = ballKind();
    for (Ball& ball : balls_) {
        if (ball.kind == kind) {
            continue;
        }
        const kodo::BodyRef before = world_[ball.body];
        const Vec2 place = before.position();
        const Vec2 velocity = before.velocity();
        const Real spin = before.angularVelocity();
        const BodyId old = ball.body;
        world_.remove(old);
        ball.kind = kind;
        ball.body = addBall(world_, place, kind);
        kodo::BodyRef now = world_[ball.body];
        if (ball.riding) {
            now.setType(kodo::BodyType::Kinematic);
        }
        now.setVelocity(velocity);
        now.setAngularVelocity(spin);
        events_.emplace_back(BallChanged{old, ball.body, kind});
    }
}

void Game::renewFields() {
    std::vector<kodo::FieldEntry> fields;
    fields.push_back({std::make_shared<kodo::Gravity>(Vec2{0, -kGravity}),
                      {.flags = kodo::kMatchAny, .required = kFalls | kStands}});
    if (windSpeed() != 0) {
        fields.push_back({std::make_shared<kodo::Wind>(kWindLaw, Vec2{windSpeed(), 0}), kFlying});
    }
    for (const WellDef& well : level_->wells) {
        const Vec2 place{static_cast<Real>(well.x) / 1000, static_cast<Real>(well.y) / 1000};
        fields.push_back(wellField(place, static_cast<Real>(well.strength) / 1000));
    }
    for (const Effect& effect : effects_) {
        if (effect.power == Power::Well) {
            fields.push_back(wellField(effect.place, kWellStrength));
        }
    }
    world_.setFields(std::move(fields));
    fieldsStale_ = false;
}

bool Game::weldWings() {
    Real restored = 0;
    for (Weld& weld : welds_) {
        if (weld.wing) { // existing wings are repaired
            weld.strengthLeft = kWeldStrength;
            ++restored;
        }
    }
    if (restored == 0 && weldedParts() + 2 > kMostWelded) {
        return false;
    }
    if (restored == 0) {
        for (const kodo::Polygon& wing : wingShapes()) {
            world_.weld(paddle_, wing, kPaddleMaterial, kWingDensity);
            welds_.push_back({.strengthLeft = kWeldStrength, .wing = true});
        }
    }
    return true;
}

BallKind Game::ballKind() const {
    for (const Effect& effect : effects_) {
        if (const std::optional<BallKind> kind = ballKindOf(effect.power)) {
            return *kind;
        }
    }
    return level_->ball;
}

PaddleKind Game::paddleKind() const {
    if (secondsLeft(Power::Spring) <= 0) {
        return level_->paddle;
    }
    return tilts(level_->paddle) ? PaddleKind::Loose : PaddleKind::Recoiling;
}

Real Game::secondsLeft(Power power) const {
    for (const Effect& effect : effects_) {
        if (effect.power == power && effect.untilTick > tick_) {
            return static_cast<Real>(effect.untilTick - tick_) * kTickSeconds;
        }
    }
    return 0;
}

Real Game::windSpeed() const {
    Real speed = static_cast<Real>(level_->wind) / 1000;
    for (const Effect& effect : effects_) {
        if (effect.power == Power::Wind) {
            speed += static_cast<Real>(effect.side) * kWindSpeed;
        }
    }
    return speed;
}

} // namespace apart
