// SPDX-License-Identifier: MIT
#include <apart/core/replay.hpp>
#include <apart/core/tuning.hpp>

#include <utility>

namespace apart {

std::int64_t valueOf(const Game& game, Field field) {
    const auto thousandths = [](kodo::Real value) {
        return static_cast<std::int64_t>(value * 1000);
    };
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
        return thousandths(game.world()[game.paddle()].position().x);
    case Field::PaddleMass:
        return thousandths(game.world()[game.paddle()].mass());
    case Field::Result:
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
    : replay_(std::move(replay)), game_(std::move(level), replay_.seed) {
    look();
}

void Playback::tick() {
    while (nextInput_ < replay_.inputs.size() && replay_.inputs[nextInput_].tick <= game_.ticks()) {
        input_ = replay_.inputs[nextInput_].input;
        ++nextInput_;
    }
    game_.tick(input_);
    look();
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
        const std::int64_t found = valueOf(game_, expectation.field);
        if (expectation.tick == game_.ticks() &&
            !holds(found, expectation.comparison, expectation.value)) {
            failures_.push_back({expectation, found});
        }
    }
}

Recorder::Recorder(const Game& atStart, std::uint32_t hashEvery) : hashEvery_(hashEvery) {
    replay_.level = atStart.level().name;
    replay_.levelDigest = digestOf(atStart.level());
    replay_.rules = kRulesVersion;
    replay_.seed = atStart.seed();
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
