// SPDX-License-Identifier: MIT
#include <apart/core/replay.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <utility>

namespace apart {

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
    settled_.resize(replay_.expectations.size());
    look();
}

void Playback::tick() {
    while (nextInput_ < replay_.inputs.size() && replay_.inputs[nextInput_].tick <= game_.ticks()) {
        input_ = replay_.inputs[nextInput_].input;
        ++nextInput_;
    }
    game_.tick(input_);
    values_.note(game_);
    look();
}

void Playback::compareHashes() {
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
}

void Playback::judge(std::size_t index) {
    const Expectation& expectation = replay_.expectations[index];
    const std::uint32_t tick = game_.ticks();
    if (settled_[index] != 0 || tick < expectation.from || tick > expectation.tick) {
        return;
    }
    const std::int64_t found = values_.valueOf(game_, expectation.field);
    const bool holdsNow = holds(found, expectation.comparison, expectation.value);
    const bool last = tick == expectation.tick;
    const bool fails = expectation.when == When::Never ? holdsNow : !holdsNow;
    if (expectation.when == When::By) {
        settled_[index] = holdsNow ? 1 : 0;
        if (last && !holdsNow) {
            failures_.push_back({expectation, found, tick});
        }
    } else if (fails) {
        settled_[index] = 1;
        failures_.push_back({expectation, found, tick});
    }
}

void Playback::look() {
    compareHashes();
    for (std::size_t i = 0; i < replay_.expectations.size(); ++i) {
        judge(i);
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
