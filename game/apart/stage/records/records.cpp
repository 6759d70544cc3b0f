// SPDX-License-Identifier: MIT
#include <apart/core/daily.hpp>
#include <apart/stage/records/records.hpp>

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

Best Records::honoursOf(Mode mode, const std::string& key) const {
    const Proof proof = standingOf(mode, key).proof;
    return proof == Proof::None || proof == Proof::Missing ? Best{} : profile_.bestOf(mode, key);
}

bool Records::isCleared(const std::string& key) const {
    bool cleared = false;
    for (std::size_t mode = 0; mode < kModeNames.size(); ++mode) {
        cleared = cleared || honoursOf(static_cast<Mode>(mode), key).cleared;
    }
    return cleared;
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
    const bool mends = mend(*finding);
    if (standing.proof != Proof::Proved && standing.score == kUnreadScore) {
        profile_.best[static_cast<std::size_t>(mode)][key].score = 0;
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
    for (Result& result : due) {
        enterBest(std::move(result));
    }
    if (!due.empty() || mends) {
        save();
    }
    return true;
}

/// Takes score and victory from the replay. False if the profile has them already.
bool Records::mend(const ScoreBook::Finding& finding) {
    const auto& [mode, key] = finding.key;
    const Best known = profile_.bestOf(mode, key);
    const bool scored = finding.standing.score == known.score;
    const bool cleared = known.cleared || !finding.standing.cleared;
    if (finding.standing.proof != Proof::Proved || (scored && cleared)) {
        return false;
    }
    if (!scored) {
        profile_.correct(mode, key, finding.standing.score);
    }
    profile_.best[static_cast<std::size_t>(mode)][key].cleared |= finding.standing.cleared;
    return true;
}

void Records::checkDoubtful() {
    for (std::size_t mode = 0; mode < profile_.best.size(); ++mode) {
        for (const auto& [key, best] : profile_.best[mode]) {
            const bool level = key != kEndlessKey && !dayOf(key);
            if (best.score == kUnreadScore || (level && !best.cleared)) {
                checkLast(static_cast<Mode>(mode), key);
            }
        }
    }
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
    const bool won = profile_.bestOf(mode, level).cleared;
    return medalWon(provedScore(mode, level), won, level, marks_);
}

void Records::count(Theme theme, const PlayTotals& game) {
    add(profile_.totals[static_cast<std::size_t>(theme)], game);
}

/// Takes over what another running game has saved of a key.
void Records::adoptSaved(const ScoreBook::Key& key) {
    const std::optional<Profile> saved = keeping_.saved ? keeping_.saved() : std::nullopt;
    if (saved) {
        profile_.adopt(key.first, key.second, saved->bestOf(key.first, key.second));
    }
}

void Records::enterHonours(const Result& result) {
    Best honours = result.best;
    honours.score = 0;
    profile_.enter(result.key.first, result.key.second, honours);
}

/// Enters a result once the score before it is known: it replaces a score that is not proved. False
/// if it waits for the check of a stored replay that was not checked yet.
bool Records::enterBest(Result result) {
    const auto& [mode, key] = result.key;
    const Proof proof = standingOf(mode, key).proof;
    const bool unproved = proof == Proof::Older || proof == Proof::Missing;
    const std::int32_t former = unproved ? 0 : profile_.bestOf(mode, key).score;
    const bool best = result.best.score > former;
    if (best && proof != Proof::Waiting && book_.isReplaced(result.key)) {
        enterHonours(result);
        book_.recheck(result.key, former);
        waiting_.push_back(std::move(result));
        return false;
    }
    if (unproved) {
        profile_.correct(mode, key, 0);
    }
    profile_.enter(mode, key, result.best);
    if (best) {
        book_.prove(result.key, result.best.score, result.run);
        keepRun(result.run, key);
    }
    return true;
}

bool Records::enter(Result result) {
    const auto& [mode, key] = result.key;
    lost_.clear();
    adoptSaved(result.key);
    const Standing standing = standingOf(mode, key);
    const bool beats = standing.proof == Proof::Proved && result.best.score > standing.score;
    keepLast(result.run);
    bool entered = false;
    if (standing.proof == Proof::Waiting && result.best.score <= standing.score) {
        enterHonours(result);
        checkFirst(mode, key);
        waiting_.push_back(std::move(result));
    } else {
        entered = enterBest(std::move(result));
    }
    save();
    return beats && entered;
}

void Records::keepLast(const ReplayRun& run) {
    keepRun(run, "");
}

void Records::keepRun(const ReplayRun& run, const std::string& best) {
    if (keeping_.keepReplay && !run.empty()) {
        noteLoss(keeping_.keepReplay(run, best));
    }
}

void Records::save() {
    if (keeping_.save) {
        noteLoss(keeping_.save(profile_));
    }
}

void Records::settleWaiting() {
    for (std::uint32_t ticks = 0; !waiting_.empty() && ticks < kLastTicks; ticks += kLastSlice) {
        advance(kLastSlice);
    }
}

void Records::setLevel(std::shared_ptr<const Level> level) {
    settleWaiting();
    book_.setLevel(std::move(level));
}

void Records::close() {
    settleWaiting();
    save();
}

void Records::noteLoss(const std::string& sentence) {
    if (!sentence.empty() && std::find(lost_.begin(), lost_.end(), sentence) == lost_.end()) {
        lost_.push_back(sentence);
    }
    note(sentence);
}

void Records::note(std::string sentence) {
    if (!sentence.empty() &&
        std::find(notices_.begin(), notices_.end(), sentence) == notices_.end()) {
        notices_.push_back(std::move(sentence));
    }
}

} // namespace apart
