// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/replay.hpp>
#include <apart/sfml/setup.hpp>
#include <apart/stage/profile_file.hpp>

#include <algorithm>
#include <memory>
#include <random>

namespace apart {

namespace {

/// Gives the inputs of a replay by the tick of the game.
Pilot pilotOf(const Replay& replay) {
    return [replay](const Game& game) -> std::optional<Input> {
        if (game.ticks() >= replay.end) {
            return std::nullopt;
        }
        const auto later = std::upper_bound(
            replay.inputs.begin(), replay.inputs.end(), game.ticks(),
            [](std::uint32_t tick, const InputChange& change) { return tick < change.tick; });
        return later == replay.inputs.begin() ? Input{} : std::prev(later)->input;
    };
}

/// All levels, or the problem of the first invalid one, as a sentence.
std::variant<std::vector<std::shared_ptr<const Level>>, std::string> readLevels() {
    std::vector<std::shared_ptr<const Level>> levels;
    for (const std::string& name : levelNames()) {
        Read<Level> level = loadLevel(name);
        if (const auto* problem = std::get_if<FileProblem>(&level)) {
            return problem->text();
        }
        levels.push_back(std::make_shared<const Level>(std::get<Level>(std::move(level))));
    }
    if (levels.empty()) {
        return "There are no levels in " + (assetsFolder() / "levels").string() + ".";
    }
    return levels;
}

/// Returns the reason if the level cannot be used, else "".
std::string takeLevel(StageDef& def, const std::string& name) {
    const auto found = std::find_if(def.levels.begin(), def.levels.end(),
                                    [&](const auto& level) { return level->name == name; });
    if (found == def.levels.end()) {
        const Read<Level> level = loadLevel(name); // for the reason
        return std::get<FileProblem>(level).text();
    }
    def.firstLevel = static_cast<std::size_t>(found - def.levels.begin());
    def.startAtOnce = true;
    return {};
}

std::string takeReplay(StageDef& def, const std::string& file) {
    const Read<Replay> read = readReplayFile(file);
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        return problem->text();
    }
    const Replay& replay = std::get<Replay>(read);
    Read<Level> level = loadLevelOf(file, replay.level);
    if (const auto* problem = std::get_if<FileProblem>(&level)) {
        return problem->text();
    }
    if (const auto problem = refusal(replay, std::get<Level>(level))) {
        return *problem;
    }
    def.show = Show{std::make_shared<const Level>(std::get<Level>(std::move(level))), replay.seed,
                    replay.mode, pilotOf(replay)};
    return {};
}

/// Writes the game to last.replay and, if it is the best of its level and mode, to best/. Endless
/// runs have several games, so only the last one is kept. Returns an error sentence or "".
std::string keepReplay(const std::filesystem::path& folder, const Replay& replay, bool best) {
    std::vector<std::filesystem::path> files = {folder / "last.replay"};
    if (best && !parseEndless(replay.level)) {
        const std::string mode(kModeNames[static_cast<std::size_t>(replay.mode)]);
        files.push_back(folder / "best" / (replay.level + "-" + mode + ".replay"));
    }
    const std::string text = toText(replay);
    for (const std::filesystem::path& file : files) {
        std::error_code error;
        std::filesystem::create_directories(file.parent_path(), error);
        if (const std::optional<FileProblem> problem = writeTextFile(file, text)) {
            return "The game is not recorded: " + problem->text() + ".";
        }
    }
    return {};
}

/// Loads the profile and installs the functions that save it.
void takeProfile(StageDef& def) {
    const std::optional<std::filesystem::path> file = profileFile();
    if (!file) {
        def.notices.push_back(
            "Settings and scores are not kept: neither XDG_CONFIG_HOME nor HOME is set.");
        return;
    }
    LoadedProfile loaded = loadProfile(*file);
    def.profile = std::move(loaded.profile);
    if (!loaded.notice.empty()) {
        def.notices.push_back(std::move(loaded.notice));
    }
    def.keepReplay = [folder = file->parent_path()](const Replay& replay, bool best) {
        return keepReplay(folder, replay, best);
    };
    if (loaded.keepFile) {
        return;
    }
    def.save = [path = *file](const Profile& profile) -> std::string {
        const std::optional<FileProblem> problem = saveProfile(path, profile);
        return problem ? "Settings and scores are not kept: " + problem->text() + "." : "";
    };
}

} // namespace

std::variant<StageDef, std::string> setUp(const Options& options) {
    auto levels = readLevels();
    if (auto* problem = std::get_if<std::string>(&levels)) {
        return std::move(*problem);
    }
    StageDef def;
    def.levels = std::get<0>(std::move(levels));
    def.bot = [](const Game& game) { return std::optional(bot(game)); };
    const bool picture = !options.screenshot.empty() || options.frames > 0;
    if (!picture) { // a picture does not depend on the profile
        takeProfile(def);
    }
    def.seed = options.seed ? *options.seed : picture ? 1 : std::random_device{}() % 1000000;
    EndlessName endless{def.seed};
    std::string problem;
    if (!options.replay.empty()) {
        problem = takeReplay(def, options.replay);
    } else if (const auto row = parseEndless(options.level)) {
        endless = options.level == "endless" ? endless : *row;
        def.firstEndless = endless.number;
    } else if (!options.level.empty()) {
        problem = takeLevel(def, options.level);
    }
    def.endless = [seed = endless.seed](std::uint32_t number) {
        return std::make_shared<const Level>(endlessLevel({seed, number}));
    };
    if (!problem.empty()) {
        return problem;
    }
    if (picture && !def.show) {
        def.pilot = def.bot;
        def.startAtOnce = true;
    }
    return def;
}

} // namespace apart
