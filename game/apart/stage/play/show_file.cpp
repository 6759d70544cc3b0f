// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/run.hpp>
#include <apart/stage/play/rerun.hpp>
#include <apart/stage/play/show_file.hpp>

#include <fmt/format.h>

#include <memory>
#include <system_error>
#include <utility>

namespace apart {

namespace {

/// A replay file that has been read.
struct ShowFile {
    std::filesystem::path path;
    std::filesystem::path ownLevels;
    ReplayRun run;
};

/// Gives the inputs of a replay by the tick of the game.
Pilot pilotOf(const Replay& replay) {
    return [replay](const Game& game) -> std::optional<Input> {
        if (game.ticks() >= replay.end) {
            return std::nullopt;
        }
        return inputAt(replay, game.ticks());
    };
}

/// Why the level of a replay cannot be read, in one line if it has no file.
std::string levelProblem(const std::string& name, const FileProblem& problem,
                         const std::filesystem::path& ownLevels) {
    std::error_code error;
    if (!levelNameProblem(name).empty() || std::filesystem::exists(problem.file, error)) {
        return problem.text();
    }
    const std::string place =
        ownLevels.empty() ? "" : " Levels of your own belong in " + ownLevels.string() + ".";
    return printable(fmt::format("The level {} is not among the levels.{}", name, place));
}

/// The show of one replay of a file, or the reason why it cannot be played.
std::variant<Show, std::string> showOf(const std::shared_ptr<const ShowFile>& file,
                                       std::size_t number) {
    const Replay& replay = file->run[number];
    Read<Level> level = loadLevelOf(file->path, replay.level, file->ownLevels);
    if (const auto* problem = std::get_if<FileProblem>(&level)) {
        return levelProblem(replay.level, *problem, file->ownLevels);
    }
    if (const auto problem = refusal(replay, std::get<Level>(level))) {
        return file->path.string() + " " + *problem + ".";
    }
    Show show{std::make_shared<const Level>(std::get<Level>(std::move(level))), replay.seed,
              replay.mode, pilotOf(replay), replay.end};
    show.hashes = replay.hashes;
    show.day = dailyOf(file->run).value_or(0);
    if (number + 1 < file->run.size()) {
        show.next = [file, number] { return showOf(file, number + 1); };
    }
    return show;
}

} // namespace

std::variant<Show, std::string> showOf(const std::filesystem::path& file,
                                       const std::filesystem::path& ownLevels) {
    Read<ReplayRun> read = readRunFile(file);
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        return problem->text();
    }
    return showOf(std::make_shared<const ShowFile>(
                      ShowFile{file, ownLevels, std::get<ReplayRun>(std::move(read))}),
                  0);
}

} // namespace apart
