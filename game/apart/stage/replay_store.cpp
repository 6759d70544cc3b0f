// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/stage/profile_file.hpp>
#include <apart/stage/replay_store.hpp>

#include <algorithm>

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

} // namespace

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
