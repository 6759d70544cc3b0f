// SPDX-License-Identifier: MIT
#include <apart/stage/records.hpp>

#include <algorithm>
#include <iterator>

namespace apart {

namespace {

constexpr std::uint32_t kLastSlice = 150;
constexpr std::uint32_t kLastTicks = 20000; // of checks at most, when the game is left: 1 s

} // namespace

Standing Records::standingOf(Mode mode, const std::string& key) const {
    return book_.standingOf({mode, key}, profile_.bestOf(mode, key).score);
}

std::int32_t Records::provedScore(Mode mode, const std::string& key) const {
    const Standing standing = standingOf(mode, key);
    return standing.proof == Proof::Proved ? standing.score : 0;
}

void Records::checkFirst(Mode mode, const std::string& key) {
    book_.checkFirst({mode, key}, profile_.bestOf(mode, key).score);
}

void Records::checkLast(Mode mode, const std::string& key) {
    book_.checkLast({mode, key}, profile_.bestOf(mode, key).score);
}

bool Records::advance(std::uint32_t ticks, bool loads) {
    const std::optional<ScoreBook::Finding> finding = book_.advance(ticks, loads);
    if (!finding) {
        return false;
    }
    const auto& [mode, key] = finding->key;
    const Standing& standing = finding->standing;
    if (standing.proof == Proof::Proved && standing.score != profile_.bestOf(mode, key).score) {
        profile_.correct(mode, key, standing.score);
    }
    std::vector<Result> due;
    for (std::size_t i = 0; i < waiting_.size();) {
        if (waiting_[i].key == finding->key) {
            due.push_back(std::move(waiting_[i]));
            waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
            ++i;
        }
    }
    for (const Result& result : due) {
        enterBest(result);
    }
    if (!due.empty()) {
        save();
    }
    return true;
}

std::optional<Replay> Records::bestGame(Mode mode, const Level& level) const {
    const Proof proof = standingOf(mode, level.name).proof;
    if (!scores_.load || (proof != Proof::Proved && proof != Proof::Waiting)) {
        return std::nullopt;
    }
    const std::variant<ReplayRun, std::string> loaded = scores_.load(mode, level.name);
    const auto* run = std::get_if<ReplayRun>(&loaded);
    const bool fits = run != nullptr && run->size() == 1 && (*run)[0].level == level.name &&
                      (*run)[0].mode == mode && !refusal((*run)[0], level);
    return fits ? std::optional((*run)[0]) : std::nullopt;
}

Medal Records::medalOf(Mode mode, const std::string& level) const {
    return apart::medalOf(provedScore(mode, level), level, marks_);
}

void Records::count(Theme theme, const PlayTotals& game) {
    add(profile_.totals[static_cast<std::size_t>(theme)], game);
}

/// Enters a result whose rival is known: it replaces a score that is not proved.
void Records::enterBest(const Result& result) {
    const auto& [mode, key] = result.key;
    const Proof proof = standingOf(mode, key).proof;
    if (proof == Proof::Older || proof == Proof::Missing) {
        profile_.correct(mode, key, 0);
    }
    const bool best = result.best.score > profile_.bestOf(mode, key).score;
    profile_.enter(mode, key, result.best);
    if (best) {
        book_.prove(result.key, result.best.score);
        keepRun(result.run, key);
    }
}

bool Records::enter(Result result) {
    const auto& [mode, key] = result.key;
    const Standing standing = standingOf(mode, key);
    const bool beats = standing.proof == Proof::Proved && result.best.score > standing.score;
    keepLast(result.run);
    if (standing.proof == Proof::Waiting && result.best.score <= standing.score) {
        Best honours = result.best;
        honours.score = 0;
        profile_.enter(mode, key, honours);
        checkFirst(mode, key);
        waiting_.push_back(std::move(result));
    } else {
        enterBest(result);
    }
    save();
    return beats;
}

void Records::keepLast(const ReplayRun& run) {
    keepRun(run, "");
}

void Records::keepRun(const ReplayRun& run, const std::string& best) {
    if (keeping_.keepReplay && !run.empty()) {
        note(keeping_.keepReplay(run, best));
    }
}

void Records::save() {
    if (keeping_.save) {
        note(keeping_.save(profile_));
    }
}

void Records::close() {
    for (std::uint32_t ticks = 0; !waiting_.empty() && ticks < kLastTicks; ticks += kLastSlice) {
        advance(kLastSlice);
    }
    save();
}

void Records::note(std::string sentence) {
    if (!sentence.empty() &&
        std::find(notices_.begin(), notices_.end(), sentence) == notices_.end()) {
        notices_.push_back(std::move(sentence));
    }
}

} // namespace apart
