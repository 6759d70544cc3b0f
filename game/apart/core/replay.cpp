// SPDX-License-Identifier: MIT
#include <apart/core/replay.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <utility>

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

} // namespace

std::span<const std::string_view> valueNames(Field field) {
    switch (field) {
    case Field::Result:
        return kResultNames;
    case Field::BallKind:
        return kBallKindNames;
    case Field::Patience:
        return kPatienceNames;
    default:
        return {};
    }
}

std::int64_t valueOf(const Game& game, Field field) {
    switch (field) {
    case Field::BlocksLeft:
        return game.blocksLeft();
    case Field::Score:
        return game.score();
    case Field::Lives:
        return game.lives();
    case Field::Combo:
        return game.combo();
    case Field::Balls:
        return static_cast<std::int64_t>(game.balls().size());
    case Field::Shards:
        return static_cast<std::int64_t>(game.shards().size());
    case Field::Parts:
        return static_cast<std::int64_t>(game.parts().size());
    case Field::PaddleParts:
        return game.weldedParts();
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
        return inThousandths(game.windSpeed());
    case Field::LargestFall:
        return game.collapse().largest;
    case Field::BentBounces:
        return game.ledger().bentBounces;
    case Field::BallKind:
        return static_cast<std::int64_t>(game.ballKind());
    case Field::Patience:
        return static_cast<std::int64_t>(game.patience());
    default:
        break;
    }
    return static_cast<std::int64_t>(game.result());
}

bool holds(std::int64_t left, Comparison comparison, std::int64_t right) {
    switch (comparison) {
    case Comparison::Equal:
        return left == right;
    case Comparison::NotEqual:
        return left != right;
    case Comparison::Less:
        return left < right;
    case Comparison::AtMost:
        return left <= right;
    case Comparison::Greater:
        return left > right;
    case Comparison::AtLeast:
        break;
    }
    return left >= right;
}

std::optional<std::string> refusal(const Replay& replay, const Level& level) {
    if (replay.rules && *replay.rules != kRulesVersion) {
        return "was recorded with version " + std::to_string(*replay.rules) +
               " of the rules, and this game has version " + std::to_string(kRulesVersion);
    }
    if (replay.levelDigest && *replay.levelDigest != digestOf(level)) {
        return "was recorded on another version of the level " + replay.level +
               ", which has changed since";
    }
    return std::nullopt;
}

Playback::Playback(Replay replay, std::shared_ptr<const Level> level)
    : replay_(std::move(replay)), game_(std::move(level), replay_.seed, replay_.mode) {
    look();
}

void Playback::tick() {
    while (nextInput_ < replay_.inputs.size() && replay_.inputs[nextInput_].tick <= game_.ticks()) {
        input_ = replay_.inputs[nextInput_].input;
        ++nextInput_;
    }
    game_.tick(input_);
    for (const Event& event : game_.events()) {
        ++eventCounts_[event.index()];
    }
    look();
}

std::int64_t Playback::valueNow(Field field) const {
    const auto index = static_cast<std::size_t>(field);
    return index < kStateFields ? valueOf(game_, field) : eventCounts_[index - kStateFields];
}

void Playback::look() {
    for (; nextHash_ < replay_.hashes.size() && replay_.hashes[nextHash_].tick <= game_.ticks();
         ++nextHash_) {
        const HashMark& mark = replay_.hashes[nextHash_];
        if (divergence_) {
            continue;
        }
        if (mark.hash == game_.stateHash()) {
            agreed_ = mark.tick;
        } else {
            divergence_ = Divergence{mark.tick, agreed_};
        }
    }
    for (const Expectation& expectation : replay_.expectations) {
        if (expectation.tick != game_.ticks()) {
            continue;
        }
        const std::int64_t found = valueNow(expectation.field);
        if (!holds(found, expectation.comparison, expectation.value)) {
            failures_.push_back({expectation, found});
        }
    }
}

Recorder::Recorder(const Game& atStart, std::uint32_t hashEvery) : hashEvery_(hashEvery) {
    replay_.level = atStart.level().name;
    replay_.levelDigest = digestOf(atStart.level());
    replay_.rules = kRulesVersion;
    replay_.seed = atStart.seed();
    replay_.mode = atStart.mode();
}

void Recorder::record(const Input& input, const Game& after) {
    if (replay_.inputs.empty() || input != last_) {
        replay_.inputs.push_back({after.ticks() - 1, input});
        last_ = input;
    }
    if (after.ticks() % hashEvery_ == 0) {
        replay_.hashes.push_back({after.ticks(), after.stateHash()});
    }
}

Replay Recorder::finish(const Game& game) const {
    Replay result = replay_;
    result.end = game.ticks();
    if (result.hashes.empty() || result.hashes.back().tick != result.end) {
        result.hashes.push_back({result.end, game.stateHash()});
    }
    return result;
}

} // namespace apart
