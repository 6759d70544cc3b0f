// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/daily.hpp>
#include <apart/core/endless.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/records/replay_store.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace apart {

namespace {

/// Renames the best game so far if it cannot be compared with games of this version: it is kept.
void setAside(const std::filesystem::path& file, const ReplayRun& better) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        return;
    }
    const Read<ReplayRun> read = readRunFile(file);
    const auto* old = std::get_if<ReplayRun>(&read);
    std::string ending;
    if (old == nullptr) {
        ending = ".broken";
    } else if ((*old)[0].rules != better[0].rules) {
        ending = ".rules-" + std::to_string((*old)[0].rules.value_or(0));
    } else if ((*old)[0].level == better[0].level &&
               (*old)[0].levelDigest != better[0].levelDigest) {
        ending = ".older-level";
    }
    if (!ending.empty()) {
        std::filesystem::rename(file, freeAside(file, ending), error);
    }
}

/// The day of the last change (UTC): 2026-11-26.
std::string dateOf(const std::filesystem::path& file) {
    using namespace std::chrono;
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    if (error) {
        return {};
    }
    // Not every standard library has file_clock::to_sys().
    const auto age = std::filesystem::file_time_type::clock::now() - time;
    const year_month_day date(
        floor<days>(system_clock::now() - duration_cast<system_clock::duration>(age)));
    return fmt::format("{}-{:02}-{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

/// Title of the level, or of the run.
std::string titleOf(const std::filesystem::path& file, const ReplayRun& run,
                    const LevelList& levels) {
    const std::string& name = run[0].level;
    if (parseEndless(name)) {
        const std::string count =
            run.size() > 1 ? fmt::format(", {} levels", run.size()) : std::string(", 1 level");
        const std::optional<Day> day = dailyOf(run);
        return (day ? dailyName(*day) : "Endless") + count;
    }
    const auto listed = std::find_if(levels.begin(), levels.end(),
                                     [&](const auto& level) { return level->name == name; });
    if (listed != levels.end()) {
        return (*listed)->title;
    }
    const Read<Level> level = loadLevelOf(file, name);
    const auto* read = std::get_if<Level>(&level);
    return read != nullptr ? read->title : name;
}

/// The value that a replay expects of a field at its end, if it has one.
std::optional<std::int64_t> atEnd(const Replay& replay, Field field) {
    for (const Expectation& expectation : replay.expectations) {
        if (expectation.field == field && expectation.when == When::At &&
            expectation.comparison == Comparison::Equal && expectation.tick == replay.end) {
            return expectation.value;
        }
    }
    return std::nullopt;
}

/// Sum of the scores; nullopt if one is not noted.
std::optional<std::int64_t> scoreOf(const ReplayRun& run) {
    std::int64_t sum = 0;
    for (const Replay& replay : run) {
        const std::optional<std::int64_t> score = atEnd(replay, Field::Score);
        if (!score) {
            return std::nullopt;
        }
        sum += *score;
    }
    return sum;
}

/// Mode and key of the best game that a file has by its name: KEY-MODE.replay.
std::optional<std::pair<Mode, std::string>> keyOf(const std::filesystem::path& file) {
    for (std::size_t mode = 0; mode < kModeNames.size(); ++mode) {
        const std::string ending = "-" + std::string(kModeNames[mode]);
        std::string key = file.stem().string();
        if (file.extension() == ".replay" && key.size() > ending.size() && key.ends_with(ending)) {
            key.resize(key.size() - ending.size());
            return std::pair{static_cast<Mode>(mode), key};
        }
    }
    return std::nullopt;
}

std::filesystem::file_time_type timeOf(const std::filesystem::path& file) {
    std::error_code unread;
    return std::filesystem::last_write_time(file, unread);
}

} // namespace

std::string ownNameProblem(const std::string& name) {
    return dayOf(name) ? "is the name of a daily run" : levelNameProblem(name);
}

bool isRecorded(const Level& level) {
    return parseEndless(level.name) || ownNameProblem(level.name).empty();
}

ShowEntry entryOf(const std::filesystem::path& file, const LevelList& levels) {
    const bool last = file.filename() == "last.replay";
    ShowEntry entry;
    entry.date = dateOf(file);
    const Read<ReplayRun> read = readRunFile(file);
    const auto* run = std::get_if<ReplayRun>(&read);
    if (run == nullptr) {
        entry.title = file.filename().string();
        entry.result = "cannot be read";
        return entry;
    }
    const Replay& end = run->back();
    entry.title = (last ? "Last game: " : "") + titleOf(file, *run, levels) +
                  (end.mode == Mode::Standard
                       ? ""
                       : fmt::format(" ({})", kModeNames[static_cast<std::size_t>(end.mode)]));
    entry.score = scoreOf(*run);
    if (const std::optional<std::int64_t> result = atEnd(end, Field::Result)) {
        constexpr std::array<std::string_view, 3> kWords = {"left", "won", "lost"};
        entry.result = kWords.at(static_cast<std::size_t>(*result));
    }
    if (const auto key = keyOf(file); !last && key && key->first == end.mode) {
        entry.best = key;
    }
    return entry;
}

void restoreScores(LoadedProfile& loaded, const std::filesystem::path& profile) {
    if (loaded.whole || loaded.keepFile) {
        return;
    }
    std::int64_t restored = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(profile.parent_path() / "best", error), end;
         !error && entry != end; entry.increment(error)) {
        const auto key = keyOf(entry->path());
        if (key && loaded.profile.bestOf(key->first, key->second).score == 0) {
            auto& bests = loaded.profile.best[static_cast<std::size_t>(key->first)];
            bests[key->second].score = kUnreadScore;
            ++restored;
        }
    }
    if (restored == 0) {
        return;
    }
    const std::string from =
        fmt::format("taken from {} in best, once each is checked.", countText(restored, "replay"));
    loaded.notice +=
        loaded.notice.empty()
            ? fmt::format("The profile {} is missing: the scores are {}", profile.string(), from)
            : " Missing scores are " + from;
}

std::vector<std::filesystem::path> replayFiles(const std::filesystem::path& folder) {
    std::error_code error;
    std::vector<std::filesystem::path> files;
    for (std::filesystem::directory_iterator entry(folder / "best", error), end;
         !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() == ".replay") {
            files.push_back(entry->path());
        }
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
        return timeOf(a) != timeOf(b) ? timeOf(a) > timeOf(b) : a < b;
    });
    if (std::filesystem::exists(folder / "last.replay", error)) {
        files.insert(files.begin(), folder / "last.replay");
    }
    files.resize(std::min(files.size(), kMostReplays));
    return files;
}

std::filesystem::path bestFile(const std::filesystem::path& folder, Mode mode,
                               const std::string& level) {
    const std::string name(kModeNames[static_cast<std::size_t>(mode)]);
    return folder / "best" / (level + "-" + name + ".replay");
}

std::string keepReplay(const std::filesystem::path& folder, const ReplayRun& run,
                       const std::string& best) {
    const std::filesystem::path file =
        best.empty() ? folder / "last.replay" : bestFile(folder, run[0].mode, best);
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (!best.empty()) {
        setAside(file, run);
    }
    const std::optional<FileProblem> problem = writeTextFile(file, toText(run));
    return problem ? "The game is not recorded: " + problem->text() + "." : "";
}

ScoreStore scoresIn(const std::filesystem::path& folder, const LevelList& levels) {
    ScoreStore store;
    store.load = [folder](Mode mode,
                          const std::string& level) -> std::variant<ReplayRun, std::string> {
        const std::filesystem::path file = bestFile(folder, mode, level);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) {
            return "no replay";
        }
        Read<ReplayRun> read = readRunFile(file);
        if (auto* run = std::get_if<ReplayRun>(&read)) {
            return std::move(*run);
        }
        return "damaged replay";
    };
    store.levelOf = [folder, levels](const Replay& replay) -> LevelOrReason {
        const auto listed = std::find_if(levels.begin(), levels.end(), [&](const auto& level) {
            return level->name == replay.level;
        });
        if (listed != levels.end()) {
            return *listed;
        }
        Read<Level> level = loadLevelOf(folder / "last.replay", replay.level);
        if (const auto* problem = std::get_if<FileProblem>(&level)) {
            return problem->text();
        }
        return std::make_shared<const Level>(std::get<Level>(std::move(level)));
    };
    return store;
}

} // namespace apart
