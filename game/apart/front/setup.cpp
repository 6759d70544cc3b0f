// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/medals.hpp>
#include <apart/front/setup.hpp>
#include <apart/stage/own_levels.hpp>
#include <apart/stage/play/show_file.hpp>
#include <apart/stage/records/profile_file.hpp>
#include <apart/stage/records/replay_store.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <random>
#include <utility>

namespace apart {

namespace {

std::uint32_t anySeed() {
    return std::random_device{}() % 1000000;
}

/// All valid levels of the game. The first error of each other one is a sentence.
LevelList readLevels(std::vector<std::string>& leftOut) {
    LevelList levels;
    for (const std::string& name : levelNames()) {
        Read<Level> level = loadLevel(name);
        if (const auto* problem = std::get_if<FileProblem>(&level)) {
            leftOut.push_back(problem->text() + ". The level is left out.");
        } else {
            levels.push_back(std::make_shared<const Level>(std::get<Level>(std::move(level))));
        }
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
    std::variant<Show, std::string> show = showOf(file, ownLevels());
    if (auto* problem = std::get_if<std::string>(&show)) {
        return std::move(*problem);
    }
    def.show = std::get<Show>(std::move(show));
    return {};
}

/// Starts with the level of a replay, and its serves, beside that game.
std::string takeRival(StageDef& def, const std::string& file) {
    Read<ReplayRun> read = readRunFile(file);
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        return problem->text() + ".";
    }
    Replay& rival = std::get<ReplayRun>(read).front();
    if (parseEndless(rival.level)) {
        return "A replay of an endless level cannot be a ghost.";
    }
    if (const std::string problem = takeLevel(def, rival.level); !problem.empty()) {
        return problem;
    }
    if (const auto reason = refusal(rival, *def.levels[def.firstLevel])) {
        return "The ghost cannot play: the replay " + *reason + ".";
    }
    def.seed = rival.seed;
    def.rival = std::move(rival);
    return {};
}

std::string takeEdit(StageDef& def, const std::string& file) {
    std::variant<EditorStart, std::string> start = editorOfFile(file);
    if (auto* problem = std::get_if<std::string>(&start)) {
        return std::move(*problem);
    }
    def.firstEdit = std::get<EditorStart>(std::move(start));
    return {};
}

/// The replays of the player.
std::vector<ShowEntry> replaysIn(const std::filesystem::path& folder, const LevelList& levels) {
    std::vector<ShowEntry> entries;
    for (const std::filesystem::path& file : replayFiles(folder)) {
        entries.push_back(entryOf(file, levels));
        entries.back().load = [file] { return showOf(file, ownLevels()); };
    }
    return entries;
}

/// The folder of the game's levels and, if there is one, that of the player's.
std::vector<std::filesystem::path> levelFolders() {
    std::vector<std::filesystem::path> folders{assetsFolder() / "levels"};
    if (const std::filesystem::path own = ownLevels(); !own.empty()) {
        folders.push_back(own);
    }
    return folders;
}

/// Loads the profile and installs the functions that save it.
void takeProfile(StageDef& def) {
    const std::optional<std::filesystem::path> file = profileFile();
    const auto keepNothing = [&](const std::string& reason) { // shown with each score, too
        def.keeping.save = [reason](const Profile&) { return reason; };
    };
    if (!file) {
        def.notices.push_back(
            "Settings and scores are not kept: neither XDG_CONFIG_HOME nor HOME is set.");
        return keepNothing(def.notices.back());
    }
    addOwnLevels(def, ownLevels());
    def.edit = [levels = def.levels](const Level* level) {
        return editorOf(level, levels, ownLevels());
    };
    LoadedProfile loaded = loadProfile(*file);
    restoreScores(loaded, *file);
    def.profile = std::move(loaded.profile);
    if (!loaded.notice.empty()) {
        def.notices.push_back(loaded.notice);
    }
    def.replayFolder = file->parent_path().string();
    def.replays = [folder = file->parent_path(), levels = def.levels] {
        return replaysIn(folder, levels);
    };
    def.scores = scoresIn(file->parent_path(), def.levels);
    def.keeping.keepReplay = [folder = file->parent_path()](const ReplayRun& run,
                                                            const std::string& best) {
        return keepReplay(folder, run, best);
    };
    if (loaded.keepFile) {
        return keepNothing(loaded.notice);
    }
    def.keeping.saved = [path = *file] { return savedProfile(path); };
    def.keeping.save = profileSaver(*file, def.profile);
}

/// The current day (UTC).
Day today() {
    using namespace std::chrono;
    const year_month_day date(floor<days>(system_clock::now()));
    return static_cast<Day>(10000 * static_cast<int>(date.year())) +
           100 * static_cast<unsigned>(date.month()) + static_cast<unsigned>(date.day());
}

/// The scores for medals of the levels that are as they were measured.
void takeMarks(StageDef& def) {
    const std::filesystem::path file = assetsFolder() / "medals.toml";
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        return;
    }
    Read<std::vector<MedalMarks>> read = readMedals(file);
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        def.notices.push_back(problem->text() + ". There are no medals.");
        return;
    }
    for (MedalMarks& marks : std::get<std::vector<MedalMarks>>(read)) {
        if (std::any_of(def.levels.begin(), def.levels.end(),
                        [&](const auto& level) { return measuredOn(marks, *level); })) {
            def.marks.push_back(std::move(marks));
        }
    }
}

} // namespace

std::filesystem::path ownLevels() {
    const std::optional<std::filesystem::path> file = profileFile();
    return file ? file->parent_path() / "levels" : std::filesystem::path();
}

std::variant<StageDef, std::string> setUp(const StartOptions& options) {
    StageDef def;
    def.levels = readLevels(def.leftOut);
    if (def.levels.empty()) {
        return noLevelsText();
    }
    putBossesLast(def.levels);
    def.campaign = {kBosses, def.levels.size(), options.allLevels};
    def.bot = [](const Game& game) { return std::optional(bot(game)); };
    const bool picture = options.picture;
    if (!picture) { // a picture does not depend on the profile
        takeProfile(def);
    }
    def.seed = options.seed ? *options.seed : picture ? 1 : anySeed();
    std::optional<std::uint32_t> runSeed = options.seed;
    std::string problem;
    if (!options.replay.empty()) {
        problem = takeReplay(def, options.replay);
    } else if (!options.ghost.empty()) {
        problem = takeRival(def, options.ghost);
    } else if (!options.edit.empty()) {
        problem = takeEdit(def, options.edit);
    } else if (const auto day = options.level == "daily" ? today() : dayOf(options.level)) {
        def.firstDay = *day;
    } else if (const auto row = parseEndless(options.level)) {
        runSeed = options.level == "endless" ? runSeed : std::optional(row->seed);
        def.firstEndless = row->number;
    } else if (options.level.ends_with(".toml")) {
        problem = takeLevelFile(def, options.level, levelFolders());
    } else if (!options.level.empty()) {
        problem = takeLevel(def, options.level);
    }
    def.endless = [](std::uint32_t seed, std::uint32_t number) {
        return std::make_shared<const Level>(endlessLevel({seed, number}));
    };
    def.endlessSeed = [fixed = runSeed   ? runSeed
                               : picture ? std::optional(1u)
                                         : std::nullopt] { return fixed ? *fixed : anySeed(); };
    def.today = today;
    def.daily = [](Day day, std::uint32_t number) {
        return std::make_shared<const Level>(endlessLevel({day, number}));
    };
    takeMarks(def);
    if (!problem.empty()) {
        return problem;
    }
    def.duel = options.duel;
    if (def.duel && (def.firstDay > 0 || def.firstEndless > 0)) {
        return "A duel is one level long: not daily or endless.";
    }
    if (picture && !def.show) {
        def.pilot = def.bot;
        def.startAtOnce = true;
    }
    return def;
}

} // namespace apart
