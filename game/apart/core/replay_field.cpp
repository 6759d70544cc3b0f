// SPDX-License-Identifier: MIT
#include <apart/core/replay_field.hpp>

#include <algorithm>
#include <type_traits>

namespace apart {

namespace {

std::int64_t inThousandths(kodo::Real value) {
    return static_cast<std::int64_t>(value * 1000);
}

/// Value of the first ball; 0 without one.
std::int64_t valueOfBall(const Game& game, Field field) {
    if (game.balls().empty()) {
        return 0;
    }
    const kodo::BodyView ball = game.world()[game.balls()[0].body];
    if (field == Field::BallSpeed) {
        return inThousandths(length(ball.velocity()));
    }
    return inThousandths(field == Field::BallX ? ball.position().x : ball.position().y);
}

std::int64_t valueOfPaddle(const Game& game, Field field) {
    const kodo::BodyView paddle = game.world()[game.paddle()];
    switch (field) {
    case Field::PaddleX:
        return inThousandths(paddle.position().x);
    case Field::PaddleMass:
        return inThousandths(paddle.mass());
    case Field::Tilt:
        return inThousandths(game.sway().tilt);
    default:
        return inThousandths(game.sway().lift);
    }
}

std::int64_t looseBlocks(const Game& game) {
    return std::count_if(game.blocks().begin(), game.blocks().end(),
                         [](const Block& block) { return block.support == Support::Loose; });
}

/// Sums over the shards and the heaviest of them.
struct Pieces {
    kodo::Vec2 momentum;
    kodo::Real spin = 0; // kg m^2/s, about the common centre of mass
    kodo::Real fastest = 0;
    kodo::Real mass = 0;
    kodo::Real heaviest = 0;
    kodo::Vec2 center; // of the heaviest
};

Pieces piecesOf(const Game& game) {
    Pieces sum;
    kodo::Vec2 moment;
    for (const Shard& shard : game.shards()) {
        const kodo::BodyView body = game.world()[shard.body];
        sum.mass += body.mass();
        sum.momentum += body.mass() * body.velocity();
        sum.spin += body.mass() * cross(body.center(), body.velocity()) +
                    body.inertia() * body.angularVelocity();
        moment += body.mass() * body.center();
        sum.fastest = std::max(sum.fastest, length(body.velocity()));
        if (body.mass() > sum.heaviest) { // ties: the first
            sum.heaviest = body.mass();
            sum.center = body.center();
        }
    }
    if (sum.mass > 0) {
        sum.spin -= cross(moment, sum.momentum) / sum.mass;
    }
    return sum;
}

std::int64_t valueOfPieces(const Game& game, Field field) {
    const Pieces pieces = piecesOf(game);
    kodo::Vec2 momentum = pieces.momentum;
    for (const Ball& ball : game.balls()) {
        const kodo::BodyView body = game.world()[ball.body];
        momentum += body.mass() * body.velocity();
    }
    switch (field) {
    case Field::MomentumX:
        return inThousandths(momentum.x);
    case Field::MomentumY:
        return inThousandths(momentum.y);
    case Field::PieceMomentumX:
        return inThousandths(pieces.momentum.x);
    case Field::PieceMomentumY:
        return inThousandths(pieces.momentum.y);
    case Field::PieceSpin:
        return inThousandths(pieces.spin);
    case Field::PieceSpeed:
        return inThousandths(pieces.fastest);
    case Field::PieceMass:
        return inThousandths(pieces.heaviest);
    case Field::PieceX:
        return inThousandths(pieces.center.x);
    case Field::PieceY:
        return inThousandths(pieces.center.y);
    default:
        return inThousandths(pieces.mass);
    }
}

std::int64_t valueOfLedger(const Game& game, Field field) {
    const Ledger& ledger = game.ledger();
    const auto thousandths = [](double value) { return static_cast<std::int64_t>(value * 1000); };
    switch (field) {
    case Field::MountImpulseX:
        return thousandths(ledger.mountImpulseX);
    case Field::MountImpulseY:
        return thousandths(ledger.mountImpulseY);
    case Field::MountTurn:
        return thousandths(ledger.mountTurn);
    case Field::FieldImpulseX:
        return thousandths(ledger.fieldImpulseX);
    case Field::FieldImpulseY:
        return thousandths(ledger.fieldImpulseY);
    case Field::ServoWork:
        return thousandths(ledger.servoWork);
    case Field::FieldWork:
        return thousandths(ledger.fieldWork);
    case Field::BreakWork:
        return thousandths(ledger.breakWork);
    case Field::KickWork:
        return thousandths(ledger.kickWork);
    case Field::RemovedMass:
        return thousandths(ledger.removedMass);
    case Field::Bounces:
        return ledger.bounces;
    case Field::ThrownBounces:
        return ledger.thrownBounces;
    default:
        return ledger.bentBounces;
    }
}

std::int64_t powerTicks(const Game& game) {
    std::int64_t least = 0;
    for (const auto& effect : game.effects()) {
        const std::int64_t left = std::int64_t{effect.untilTick} - game.ticks();
        least = least == 0 ? left : std::min(least, left);
    }
    return least;
}

std::int64_t valueOfState(const Game& game, Field field) {
    switch (field) {
    case Field::BlocksLeft:
        return game.blocksLeft();
    case Field::Score:
        return game.score();
    case Field::Lives:
        return game.lives();
    case Field::Combo:
        return game.counts().combo;
    case Field::Balls:
        return static_cast<std::int64_t>(game.balls().size());
    case Field::Shards:
        return static_cast<std::int64_t>(game.shards().size());
    case Field::Parts:
        return static_cast<std::int64_t>(game.parts().size());
    case Field::PaddleParts:
        return static_cast<std::int64_t>(game.welds().size());
    case Field::PaddleX:
    case Field::PaddleMass:
    case Field::Tilt:
    case Field::Lift:
        return valueOfPaddle(game, field);
    case Field::BallX:
    case Field::BallY:
    case Field::BallSpeed:
        return valueOfBall(game, field);
    case Field::LooseBlocks:
        return looseBlocks(game);
    case Field::Meter:
        return inThousandths(game.meter());
    case Field::Effects:
        return static_cast<std::int64_t>(game.effects().size());
    case Field::Wind:
        return inThousandths(game.state().windSpeed());
    case Field::LargestFall:
        return game.collapse().largest;
    case Field::BallKind:
        return static_cast<std::int64_t>(game.state().ballKind());
    case Field::Patience:
        return static_cast<std::int64_t>(game.state().patience());
    case Field::Result:
        return static_cast<std::int64_t>(game.result());
    case Field::PowerTicks:
        return powerTicks(game);
    case Field::PaddleHits:
        return game.counts().hits;
    case Field::Prize:
        return game.counts().prize();
    case Field::ServeX:
        return inThousandths(game.serveHeading().x / game.serveHeading().y);
    default:
        break;
    }
    return field >= Field::MomentumX && field <= Field::PieceMassAll ? valueOfPieces(game, field)
                                                                     : valueOfLedger(game, field);
}

} // namespace

std::span<const std::string_view> valueNames(Field field) {
    switch (field) {
    case Field::Result:
        return kResultNames;
    case Field::BallKind:
        return kBallKindNames;
    case Field::Patience:
        return kPatienceNames;
    case Field::PowerName:
        return kPowerNames;
    default:
        return {};
    }
}

void FieldValues::set(Field field, std::int64_t value) {
    last_[static_cast<std::size_t>(field) - kStateFields] = value;
}

void FieldValues::set(Field field, kodo::Real value) {
    set(field, inThousandths(value));
}

void FieldValues::note(const Game& game) {
    for (const Event& event : game.events()) {
        ++counts_[event.index()];
        if (const auto* hit = std::get_if<Struck>(&event)) {
            set(Field::HitImpulse, hit->impulse);
            set(Field::HitX, hit->point.x);
            set(Field::HitY, hit->point.y);
        } else if (const auto* crack = std::get_if<Cracked>(&event)) {
            set(Field::CrackImpulse, crack->impulse);
            set(Field::CrackBlock, std::int64_t{crack->key});
        } else if (const auto* broke = std::get_if<Broke>(&event)) {
            set(Field::BreakImpulse, broke->impulse);
            set(Field::BreakX, broke->point.x);
            set(Field::BreakY, broke->point.y);
            set(Field::BreakBlock, std::int64_t{broke->key});
            set(Field::BreakPieces, std::int64_t{broke->shards});
        } else if (const auto* piece = std::get_if<ShardBroke>(&event)) {
            set(Field::PieceImpulse, piece->impulse);
            set(Field::PieceBroken, std::int64_t{piece->pieces});
        } else if (const auto* collapsed = std::get_if<Collapsed>(&event)) {
            set(Field::CollapseSize, std::int64_t{collapsed->blocks});
        } else if (const auto* snapped = std::get_if<Snapped>(&event)) {
            set(Field::SnapForce, snapped->force);
        } else if (const auto* power = std::get_if<PowerBegan>(&event)) {
            set(Field::PowerName, static_cast<std::int64_t>(power->power));
        }
    }
}

std::int64_t FieldValues::valueOf(const Game& game, Field field) const {
    const auto index = static_cast<std::size_t>(field);
    if (index >= kValueFields) {
        return counts_[index - kValueFields];
    }
    return index >= kStateFields ? last_[index - kStateFields] : valueOfState(game, field);
}

} // namespace apart
