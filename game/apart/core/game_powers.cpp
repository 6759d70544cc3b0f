// SPDX-License-Identifier: MIT
// Timed powers.
#include <apart/core/field.hpp>
#include <apart/core/game_rules.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <memory>

namespace apart {

using kodo::BodyId;
using kodo::Real;
using kodo::Vec2;

namespace {

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

static void reshapeBalls(GameState& game);

void beginPower(GameState& game, Power power, Vec2 point, Vec2 origin) {
    if (ballKindOf(power)) { // all balls have one kind
        for (std::size_t i = game.powers.effects.size(); i-- > 0;) {
            if (ballKindOf(game.powers.effects[i].power) && game.powers.effects[i].power != power) {
                endPower(game, i);
            }
        }
    }
    const auto same = std::find_if(game.powers.effects.begin(), game.powers.effects.end(),
                                   [&](const Effect& effect) { return effect.power == power; });
    const int side = Generator(mixKeys(game.origin.seed, game.tick, 3)).below(2) == 0 ? 1 : -1;
    const Effect effect{power, game.tick + (movesAir(power) ? kBriefTicks : kEffectTicks), origin,
                        side};
    if (same == game.powers.effects.end()) {
        game.powers.effects.push_back(effect);
    } else {
        *same = effect;
    }
    game.powers.fieldsStale = game.powers.fieldsStale || movesAir(power);
    game.events.emplace_back(PowerBegan{power, point, effect.untilTick});
}

void endPower(GameState& game, std::size_t effect) {
    const Power power = game.powers.effects[effect].power;
    game.powers.effects.erase(game.powers.effects.begin() + static_cast<std::ptrdiff_t>(effect));
    game.powers.fieldsStale = game.powers.fieldsStale || movesAir(power);
    game.events.emplace_back(PowerEnded{power});
}

void endOldPowers(GameState& game) {
    for (std::size_t i = game.powers.effects.size(); i-- > 0;) {
        if (game.powers.effects[i].untilTick <= game.tick) {
            endPower(game, i);
        }
    }
    refreshPowers(game);
}

void refreshPowers(GameState& game) {
    reshapeBalls(game);
    if (game.powers.fieldsStale) {
        renewFields(game);
    }
}

void reshapeBalls(GameState& game) {
    const BallKind kind = game.ballKind();
    for (Ball& ball : game.balls) {
        if (ball.kind == kind) {
            continue;
        }
        const kodo::BodyRef before = game.world[ball.body];
        const Vec2 place = before.position();
        const Vec2 velocity = before.velocity();
        const Real spin = before.angularVelocity();
        const BodyId old = ball.body;
        game.world.remove(old);
        ball.kind = kind;
        ball.body = addBall(game.world, place, kind);
        kodo::BodyRef now = game.world[ball.body];
        if (ball.riding) {
            now.setType(kodo::BodyType::Kinematic);
        } else if (ball.hollow) {
            now.setMass(kHollowShare * now.mass());
        }
        now.setVelocity(velocity);
        now.setAngularVelocity(spin);
        game.events.emplace_back(BallChanged{old, ball.body, kind});
    }
}

void renewFields(GameState& game) {
    std::vector<kodo::FieldEntry> fields;
    fields.push_back({std::make_shared<kodo::Gravity>(Vec2{0, -kGravity}),
                      {.flags = kodo::kMatchAny, .required = kFalls | kStands}});
    if (game.windSpeed() != 0) {
        fields.push_back(
            {std::make_shared<kodo::Wind>(kWindLaw, Vec2{game.windSpeed(), 0}), kFlying});
    }
    for (const WellDef& well : game.origin.level->wells) {
        const Vec2 place{static_cast<Real>(well.x) / 1000, static_cast<Real>(well.y) / 1000};
        fields.push_back(wellField(place, static_cast<Real>(well.strength) / 1000));
    }
    for (const Effect& effect : game.powers.effects) {
        if (effect.power == Power::Well) {
            fields.push_back(wellField(effect.place, kWellStrength));
        }
    }
    addWaterFields(game, fields);
    game.world.setFields(std::move(fields));
    game.powers.fieldsStale = false;
}

bool weldWings(GameState& game) {
    Real restored = 0;
    for (Weld& weld : game.paddle.welds) {
        if (weld.wing) { // existing wings are repaired
            weld.strengthLeft = kWeldStrength;
            ++restored;
        }
    }
    if (restored == 0 && game.weldedParts() + 2 > kMostWelded) {
        return false;
    }
    if (restored == 0) {
        for (const kodo::Polygon& wing : wingShapes()) {
            game.world.weld(game.paddle.body, wing, kPaddleMaterial, kWingDensity);
            game.paddle.welds.push_back({.strengthLeft = kWeldStrength, .wing = true});
        }
    }
    return true;
}

} // namespace apart
