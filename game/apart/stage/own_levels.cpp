// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/stage/own_levels.hpp>
#include <apart/stage/records/replay_store.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace apart {

namespace fs = std::filesystem;

namespace {

bool isListed(const LevelList& levels, const std::string& name) {
    return std::any_of(levels.begin(), levels.end(),
                       [&](const auto& level) { return level->name == name; });
}

/// True if the file is the one in these folders that has its name.
bool isIn(const std::vector<fs::path>& folders, const fs::path& file) {
    return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) {
        std::error_code error;
        return fs::equivalent(folder / file.filename(), file, error) && !error;
    });
}

/// Reads a level file again whenever it has changed. The level keeps its name.
class LevelWatch {
public:
    LevelWatch(fs::path file, std::string name) : file_(std::move(file)), name_(std::move(name)) {
        look();
    }

    /// The level, or its errors; nullopt while the file stays as it is.
    std::optional<LevelChange> operator()() {
        if (!look()) {
            return std::nullopt;
        }
        Read<Level> read = readLevelFile(file_);
        if (const auto* problem = std::get_if<FileProblem>(&read)) {
            return LevelChange{nullptr, problem->texts()};
        }
        std::get<Level>(read).name = name_;
        return LevelChange{std::make_shared<const Level>(std::get<Level>(std::move(read))), {}};
    }

private:
    bool look() {
        std::error_code error;
        const auto written = fs::last_write_time(file_, error);
        const auto time = error ? std::nullopt : std::optional(written);
        return std::exchange(time_, time) != time;
    }

    fs::path file_;
    std::string name_;
    std::optional<fs::file_time_type> time_; // of the last change; none: there is no file
};

} // namespace

void addOwnLevels(StageDef& def, const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry->path().extension() == ".toml") {
            files.push_back(entry->path());
        }
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        const std::string name = file.stem().string();
        if (const std::string problem = ownNameProblem(name); !problem.empty()) {
            def.leftOut.push_back(file.string() + ": " + name + " " + problem +
                                  ". The level is left out.");
            continue;
        }
        Read<Level> read = readLevelFile(file);
        if (const auto* problem = std::get_if<FileProblem>(&read)) {
            def.leftOut.push_back(problem->text() + ". The level is left out.");
        } else if (isListed(def.levels, name)) {
            def.leftOut.push_back(file.string() + ": the game has a level " + name +
                                  " already. The level is left out.");
        } else {
            def.levels.push_back(std::make_shared<const Level>(std::get<Level>(std::move(read))));
        }
    }
}

std::string takeLevelFile(StageDef& def, const fs::path& file,
                          const std::vector<fs::path>& folders) {
    Read<Level> read = readLevelFile(file);
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        std::string all;
        for (const std::string& text : problem->texts()) {
            all += (all.empty() ? "" : "\n") + text;
        }
        return all;
    }
    Level level = std::get<Level>(std::move(read));
    const std::string name = level.name;
    std::string problem = ownNameProblem(name);
    if (problem.empty() && isListed(def.levels, name) && !isIn(folders, file)) {
        problem = "is the name of another level";
    }
    if (!problem.empty()) {
        level.name = file.filename().string();
        def.notices.push_back(file.string() + ": " + name + " " + problem +
                              ". It is played without scores, honours and replays.");
    }
    const auto same = std::find_if(def.levels.begin(), def.levels.end(),
                                   [&](const auto& other) { return other->name == level.name; });
    if (same != def.levels.end()) {
        const auto index = static_cast<std::size_t>(same - def.levels.begin());
        def.campaign.own -= index < def.campaign.own ? 1 : 0;
        def.levels.erase(same);
    }
    def.reload = LevelWatch(file, level.name);
    def.levels.push_back(std::make_shared<const Level>(std::move(level)));
    def.firstLevel = def.levels.size() - 1;
    def.startAtOnce = true;
    return {};
}

EditorStart editorOf(const Level* level, const LevelList& levels, const fs::path& folder) {
    std::error_code error;
    const auto fileOf = [&](const std::string& name) { return folder / (name + ".toml"); };
    std::string name = level == nullptr ? "my_level" : level->name;
    if (level == nullptr || !fs::exists(fileOf(name), error)) {
        const std::string start = level == nullptr ? name : name + "_own";
        name = start;
        for (int i = 2; fs::exists(fileOf(name), error) || isListed(levels, name); ++i) {
            name = start + std::to_string(i);
        }
    }
    EditorStart start{level == nullptr ? newLevel(name) : *level, fileOf(name).string()};
    start.level.name = name;
    start.listed = true;
    start.save = [folder, file = fileOf(name)](const std::string& text) -> std::string {
        std::error_code failed;
        fs::create_directories(folder, failed); // else the file cannot be written
        const std::optional<FileProblem> problem = writeTextFile(file, text);
        return problem ? problem->text() : "";
    };
    return start;
}

std::variant<EditorStart, std::string> editorOfFile(const fs::path& file) {
    EditorStart start{newLevel(file.stem().string()), file.string()};
    std::error_code error;
    if (fs::exists(file, error)) {
        Read<Level> read = readLevelFile(file);
        if (const auto* problem = std::get_if<FileProblem>(&read)) {
            return problem->text() + ".";
        }
        start.level = std::get<Level>(std::move(read));
    }
    start.save = [file](const std::string& text) -> std::string {
        const std::optional<FileProblem> problem = writeTextFile(file, text);
        return problem ? problem->text() : "";
    };
    return start;
}

} // namespace apart
