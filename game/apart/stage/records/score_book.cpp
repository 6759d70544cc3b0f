// SPDX-License-Identifier: MIT
#include <apart/core/daily.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/tuning.hpp>
#include <apart/stage/records/score_book.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace apart {

namespace {

std::uint64_t runDigest(const ReplayRun& run) {
    return digestOf(toText(run));
}

/// True if the run can be the best game of this key. Keys that are no level are endless runs.
bool fits(const ReplayRun& run, const ScoreBook::Key& key) {
    const auto& [mode, level] = key;
    if (run.empty() || run[0].mode != mode) {
        return false;
    }
    if (const std::optional<Day> day = dayOf(level)) {
        return isDaily(run, *day);
    }
    return level == kEndlessKey ? parseEndless(run[0].level).has_value() : run[0].level == level;
}

} // namespace

bool ScoreBook::isChecked(const Key& key, std::int32_t score) const {
    const Proof proof = standingOf(key, score).proof;
    return proof != Proof::Waiting;
}

void ScoreBook::checkFirst(const Key& key, std::int32_t score) {
    if (isChecked(key, score)) {
        return;
    }
    const auto found = std::find_if(checks_.begin(), checks_.end(),
                                    [&](const Check& check) { return check.key == key; });
    if (found == checks_.end()) {
        checks_.insert(checks_.begin(), {key, score});
    } else {
        std::rotate(checks_.begin(), found, found + 1);
    }
}

void ScoreBook::checkLast(const Key& key, std::int32_t score) {
    const bool queued = std::any_of(checks_.begin(), checks_.end(),
                                    [&](const Check& check) { return check.key == key; });
    if (!queued && !isChecked(key, score)) {
        checks_.push_back({key, score});
    }
}

void ScoreBook::recheck(const Key& key, std::int32_t score) {
    std::erase_if(checks_, [&](const Check& check) { return check.key == key; });
    known_.erase(key);
    checks_.insert(checks_.begin(), {key, score});
}

void ScoreBook::setLevel(std::shared_ptr<const Level> level) {
    std::erase_if(known_, [&](const auto& known) { return known.first.second == level->name; });
    for (Check& check : checks_) {
        if (check.key.second == level->name) {
            check.run.reset();
        }
    }
    level_ = std::move(level);
}

/// The store's way to find a level, except for that of setLevel().
LevelFinder ScoreBook::finder() const {
    if (!level_) {
        return store_.levelOf;
    }
    return [level = level_, others = store_.levelOf](const Replay& replay) -> LevelOrReason {
        if (replay.level == level->name) {
            return level;
        }
        return others(replay);
    };
}

void ScoreBook::prove(const Key& key, std::int32_t score, const ReplayRun& run) {
    std::erase_if(checks_, [&](const Check& check) { return check.key == key; });
    const bool older = level_ && !run.empty() && run[0].level == level_->name &&
                       refusal(run[0], *level_).has_value();
    known_[key] =
        older ? Standing{Proof::Older, score, kOlderLevel} : Standing{Proof::Proved, score};
    digests_[key] = runDigest(run);
}

bool ScoreBook::isReplaced(const Key& key) const {
    if (!store_.load) {
        return false;
    }
    const std::variant<ReplayRun, std::string> stored = store_.load(key.first, key.second);
    const auto* run = std::get_if<ReplayRun>(&stored);
    const auto known = digests_.find(key);
    return run != nullptr && (known == digests_.end() || known->second != runDigest(*run));
}

ScoreBook::Finding ScoreBook::settle(Standing standing) {
    const Finding finding{checks_[0].key, std::move(standing)};
    known_[finding.key] = finding.standing;
    checks_.erase(checks_.begin());
    return finding;
}

/// Loads the replay. The finding, if it cannot be played.
std::optional<ScoreBook::Finding> ScoreBook::begin(Check& check) {
    if (!store_.load) {
        return settle({Proof::Missing, check.score, "no replay"});
    }
    std::variant<ReplayRun, std::string> loaded = store_.load(check.key.first, check.key.second);
    if (const auto* reason = std::get_if<std::string>(&loaded)) {
        return settle({Proof::Missing, check.score, *reason});
    }
    ReplayRun& run = std::get<ReplayRun>(loaded);
    digests_[check.key] = runDigest(run);
    if (!fits(run, check.key)) {
        return settle({Proof::Missing, check.score, "replay of another level"});
    }
    if (run[0].rules.value_or(kRulesVersion) != kRulesVersion) {
        return settle({Proof::Older, check.score, fmt::format("rules {}", *run[0].rules)});
    }
    if (parseEndless(run[0].level)) { // it is made later, and depends on the rules alone
        check.run.emplace(std::move(run), finder());
        return std::nullopt;
    }
    const LevelOrReason level = finder()(run[0]);
    const auto* found = std::get_if<std::shared_ptr<const Level>>(&level);
    if (found == nullptr) {
        return settle({Proof::Missing, check.score, "level missing"});
    }
    if (refusal(run[0], **found)) {
        return settle({Proof::Older, check.score, kOlderLevel});
    }
    check.run.emplace(std::move(run), finder());
    return std::nullopt;
}

std::optional<ScoreBook::Finding> ScoreBook::advance(std::uint32_t ticks, bool loads) {
    if (checks_.empty()) {
        return std::nullopt;
    }
    Check& check = checks_[0];
    if (!check.run) {
        return begin(check);
    }
    if (!loads && check.run->loads()) {
        return std::nullopt;
    }
    check.run->advance(ticks);
    if (!check.run->done()) {
        return std::nullopt;
    }
    if (const std::optional<std::int32_t> score = check.run->score()) {
        return settle({Proof::Proved, *score, {}, check.run->won()});
    }
    return settle({Proof::Missing, check.score, "its replay fails"});
}

Standing ScoreBook::standingOf(const Key& key, std::int32_t score) const {
    if (score <= 0) {
        return {};
    }
    const auto known = known_.find(key);
    if (known != known_.end() && known->second.score == score) {
        return known->second;
    }
    Standing waiting{Proof::Waiting, score, "not checked yet"};
    if (!checks_.empty() && checks_[0].key == key && checks_[0].run) {
        waiting.note = fmt::format("checked: {:.0f} %", 100 * checks_[0].run->share());
    }
    return waiting;
}

} // namespace apart
