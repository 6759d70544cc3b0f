// SPDX-License-Identifier: MIT
#include <apart/core/endless.hpp>
#include <apart/core/replay_link.hpp>
#include <apart/core/run.hpp>

#include <algorithm>
#include <utility>

namespace apart {

namespace {

constexpr std::string_view kHead = "apart-replay ";
constexpr std::uint64_t kLoading = 240; // ticks that loading a level is worth, in share()

/// Starts of the replays in a text. The first one is 0: comments may precede its first line.
std::vector<std::size_t> startsOf(std::string_view text) {
    std::vector<std::size_t> starts;
    for (std::size_t at = 0; at < text.size();) {
        if (text.substr(at).starts_with(kHead)) {
            starts.push_back(starts.empty() ? 0 : at);
        }
        const std::size_t end = text.find('\n', at);
        at = end == std::string_view::npos ? text.size() : end + 1;
    }
    if (starts.empty()) {
        starts.push_back(0);
    }
    return starts;
}

/// Why these replays are no run; empty if they are.
std::string problemOf(const ReplayRun& run) {
    for (std::size_t i = 1; i < run.size(); ++i) {
        const auto before = parseEndless(run[i - 1].level);
        const auto now = parseEndless(run[i].level);
        if (!before || !now || now->seed != before->seed || now->number != before->number + 1) {
            return "its replays are not consecutive endless levels of one seed: " +
                   run[i - 1].level + " is followed by " + run[i].level;
        }
        if (run[i].mode != run[0].mode || run[i].rules != run[0].rules) {
            return "its replays have not all the same mode and version of the rules";
        }
    }
    return "";
}

} // namespace

Read<ReplayRun> parseRun(std::string_view text, const std::string& file) {
    if (text.size() > kLargestReplay) {
        return longerThanLargest(file);
    }
    ReplayRun run;
    const std::vector<std::size_t> starts = startsOf(text);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : text.size();
        Read<Replay> read = parseReplay(text.substr(starts[i], end - starts[i]), file);
        if (auto* problem = std::get_if<FileProblem>(&read)) {
            const std::string_view before = text.substr(0, starts[i]);
            problem->line += static_cast<int>(std::count(before.begin(), before.end(), '\n'));
            return std::move(*problem);
        }
        run.push_back(std::get<Replay>(std::move(read)));
    }
    if (std::string reason = problemOf(run); !reason.empty()) {
        return FileProblem{file, 0, std::move(reason)};
    }
    return run;
}

Read<ReplayRun> readRunFile(const std::filesystem::path& path) {
    if (isLink(path.string())) {
        return runOfLink(path.string());
    }
    const Read<std::string> text = readTextFile(path, kLargestReplay);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        return *problem;
    }
    const std::string& content = std::get<std::string>(text);
    return content.starts_with(kPackedMark) ? unpacked(content, path.string())
                                            : parseRun(content, path.string());
}

std::string toText(const ReplayRun& run) {
    std::string text;
    for (const Replay& replay : run) {
        text += toText(replay);
    }
    return text;
}

RunCheck::RunCheck(ReplayRun run, LevelFinder levelOf)
    : run_(std::move(run)), levelOf_(std::move(levelOf)) {
    for (const Replay& replay : run_) {
        allTicks_ += replay.end + kLoading;
    }
    done_ = failed_ = run_.empty();
}

void RunCheck::open() {
    const Replay& replay = run_[next_];
    LevelOrReason level = levelOf_(replay);
    auto* found = std::get_if<std::shared_ptr<const Level>>(&level);
    if (found == nullptr || refusal(replay, **found)) {
        done_ = failed_ = true;
        return;
    }
    playback_.emplace(replay, std::move(*found));
    ++next_;
    ticks_ += kLoading;
}

void RunCheck::close() {
    const Game& game = playback_->game();
    const bool last = next_ == run_.size();
    score_ += game.score();
    done_ = last;
    won_ = game.result() == Result::Won;
    if (playback_->divergence() || (!last && game.result() != Result::Won)) {
        done_ = failed_ = true;
    }
    playback_.reset();
}

void RunCheck::advance(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks && !done_; ++i) {
        if (!playback_) {
            return open(); // takes as long as some ticks
        }
        if (playback_->done() || playback_->divergence()) {
            close();
            continue;
        }
        playback_->tick();
        ++ticks_;
    }
}

bool RunCheck::loads() const {
    return !done_ && !playback_ && parseEndless(run_[next_].level).has_value();
}

double RunCheck::share() const {
    return done_ || allTicks_ == 0 ? 1
                                   : static_cast<double>(ticks_) / static_cast<double>(allTicks_);
}

std::optional<std::int32_t> RunCheck::score() const {
    return done_ && !failed_ ? std::optional(score_) : std::nullopt;
}

} // namespace apart
