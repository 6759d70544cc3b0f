// SPDX-License-Identifier: MIT
// aPart without a screen: replays, checks and the bot. Exit code: 0 success, 1 an unmet
// expectation, a diverging replay or a failed level check, 2 wrong use or a bad file.
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/daily.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/player.hpp>
#include <apart/core/replay.hpp>
#include <apart/core/replay_link.hpp>
#include <apart/core/text_file.hpp>
#include <apart/core/tuning.hpp>
#include <apart/core/version.hpp>
#include <apart/headless/lint_command.hpp>
#include <apart/headless/refusal.hpp>
#include <apart/headless/replay_commands.hpp>
#include <apart/headless/report.hpp>
#include <apart/headless/soak_command.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace apart {
namespace {

void print(const Report& report, bool json) {
    fmt::print("{}\n", json ? asJson(report) : asSentence(report));
}

constexpr const char* kLinkHelp =
    "Print a link to the game, to be put behind the address of a page of the game";

constexpr const char* kLevelHelp =
    "File of its level; unless given, levels/NAME.toml beside the replay or the game's level";

struct BotOptions {
    std::string level;
    std::uint32_t seed = 1;
    std::uint32_t ticks = 5 * 60 * kTicksPerSecond;
    std::uint32_t hashEvery = kHashEvery;
    std::string record;
    bool link = false;
    std::optional<BotKind> player{}; // good unless given
    std::optional<Mode> mode{};      // standard unless given
    bool json = false;
};

/// Adds an option whose values are the names of enumerators.
template <typename T, std::size_t kCount>
CLI::Option* addChoice(CLI::App& command, const std::string& option, std::optional<T>& choice,
                       const std::array<std::string_view, kCount>& names) {
    return command
        .add_option_function<std::string>(option,
                                          [&choice, &names](const std::string& name) {
                                              const auto found =
                                                  std::find(names.begin(), names.end(), name);
                                              choice = static_cast<T>(found - names.begin());
                                          })
        ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
}

int playBot(const BotOptions& options) {
    std::string name = options.level;
    if (name.empty()) {
        name = namesOfLevels().front();
    } else if (name == "endless") {
        name = EndlessName{options.seed}.text(); // one seed for the levels and the game
    }
    Game game(std::make_shared<const Level>(valueOrRefuse(loadLevel(name))), options.seed,
              options.mode.value_or(Mode::Standard));
    Recorder recorder(game, options.hashEvery);
    Player player(options.player.value_or(BotKind::Good));
    {
        Progress progress;
        while (game.ticks() < options.ticks && game.result() == Result::Playing) {
            const Input input = player.next(game);
            game.tick(input);
            recorder.record(input, game);
            progress.show(game, options.ticks);
        }
    }
    if (!options.record.empty()) {
        if (const auto problem = writeTextFile(options.record, toText(recorder.finish(game)))) {
            throw Refusal{problem->text()};
        }
    }
    print(reportOf(game), options.json);
    if (options.link) {
        fmt::print("{}\n", linkOf({recorder.finish(game)}));
    }
    return 0;
}

/// Says where the game diverges from the hashes of the replay. False if it does.
bool agrees(const std::string& file, const Playback& playback) {
    if (!playback.divergence()) {
        return true;
    }
    const auto& [tick, agreed] = *playback.divergence();
    complain(fmt::format("{}: the game diverges: tick {} is the first whose hash differs{}", file,
                         tick, agreed ? fmt::format("; tick {} agrees", *agreed) : ""));
    return false;
}

/// Names the unmet expectations. False if there are some.
bool meets(const std::string& file, const Playback& playback) {
    for (const Playback::Failure& failure : playback.failures()) {
        complain(fmt::format("{}:{}: {}", file, failure.expectation.line, failure.text()));
    }
    return playback.failures().empty();
}

/// Plays one replay of a file and prints its report; adds it to `daily`. False if an expectation is
/// unmet or a hash differs.
bool playReplay(const std::string& file, Playback playback, bool json, DailyResult& daily) {
    const std::optional<std::uint32_t> ended = playToEnd(playback);
    const bool met = meets(file, playback);
    daily.score += playback.game().score();
    daily.ticks += playback.replay().end;
    ++daily.levels;
    Report report = reportOf(playback.game());
    report.ended = ended;
    report.expectationsFailed = playback.failures().size();
    print(report, json);
    if (!json && !playback.replay().expectations.empty()) {
        fmt::print("{} of {} expectations met.\n",
                   playback.replay().expectations.size() - playback.failures().size(),
                   playback.replay().expectations.size());
    }
    return agrees(file, playback) && met;
}

int playRun(const PlayCommand& options) {
    const auto& [file, level, json, link] = options;
    bool good = true;
    const ReplayRun run = readRun(file);
    DailyResult daily{.day = dailyOf(run).value_or(0)};
    for (const Replay& replay : run) {
        good = playReplay(file, openReplay(file, replay, level), json, daily) && good;
    }
    if (daily.day > 0 && !json) {
        fmt::print("{}\n", dailyLine(daily));
    }
    if (link) {
        fmt::print("{}\n", linkOf(run));
    }
    return good ? 0 : 1;
}

/// False if the game diverges or an expectation is unmet.
bool verifyReplay(const std::string& file, Playback playback, bool json) {
    const std::size_t hashes = playback.replay().hashes.size();
    const std::size_t expected = playback.replay().expectations.size();
    if (hashes + expected == 0) {
        throw Refusal{file + ": there is no hash line and no expectation to verify"};
    }
    const std::optional<std::uint32_t> ended = playToEnd(playback);
    Report report = reportOf(playback.game());
    report.ended = ended;
    report.hashesChecked = hashes;
    if (expected > 0) {
        report.expectationsFailed = playback.failures().size();
    }
    if (playback.divergence()) {
        report.firstDifference = playback.divergence()->tick;
    }
    print(report, json);
    const bool met = meets(file, playback);
    const bool agreed = agrees(file, playback);
    if (!json && agreed && hashes > 0) {
        fmt::print("All {} hashes agree.\n", hashes);
    }
    if (!json && met && expected > 0) {
        fmt::print("All {} expectations are met.\n", expected);
    }
    return met && agreed;
}

int verify(const PlayCommand& options) {
    bool agreed = true;
    for (const Replay& replay : readRun(options.file)) {
        Playback playback = openReplay(options.file, replay, options.level);
        agreed = verifyReplay(options.file, std::move(playback), options.json) && agreed;
    }
    return agreed ? 0 : 1;
}

int listLevels() {
    for (const std::string& name : namesOfLevels()) {
        const Level found = valueOrRefuse(loadLevel(name));
        fmt::print("{:<16} {:<12} {}: {}\n", printable(name),
                   kThemeNames[static_cast<std::size_t>(found.theme)], printable(found.title),
                   printable(found.idea));
    }
    return 0;
}

/// Options of `lint`, `soak` and `trace`.
struct Checks {
    LintCommand lint;
    SoakCommand soak;
    TraceCommand trace;
    MedalsCommand medals;
    std::vector<std::string> hashed; // files
};

CLI::App* addTrace(CLI::App& app, TraceCommand& trace) {
    CLI::App* command = app.add_subcommand("trace", "Print what happens in a replay, by tick");
    command->add_option("FILE", trace.file, "The replay")->required();
    command->add_option("--level", trace.level, kLevelHelp);
    command->add_option("--from", trace.from, "First tick, 0 unless given");
    command->add_option("--to", trace.to, "Last tick, the end unless given");
    command->add_option("--field", trace.fields,
                        "A field of expectations; its value is printed when it changes");
    return command;
}

CLI::App* addLint(CLI::App& app, LintCommand& lint) {
    CLI::App* command = app.add_subcommand("lint", "Check that levels can be played and won");
    command->add_option("LEVEL", lint.levels, "Names of levels; all unless given");
    command
        ->add_option("--seeds", lint.options.seeds,
                     "Games of the bot on each level, 1 unless given")
        ->check(CLI::Range(1u, 1000000u));
    command
        ->add_option("--first-seed", lint.options.firstSeed,
                     "Seed of the first game on each level, 1 unless given; then one more each")
        ->check(CLI::Range(0u, kMostSeed));
    command
        ->add_option("--ticks", lint.options.mostTicks, "Longest game in ticks, 36000 unless given")
        ->check(CLI::Range(1u, kLongestReplay));
    auto* json = command->add_flag("--json", lint.json, "Print one JSON object");
    command
        ->add_flag("--difficulty", lint.difficulty,
                   "Instead, what bots of each skill win, and how difficulty rises level by level")
        ->excludes(json);
    return command;
}

CLI::App* addMedals(CLI::App& app, MedalsCommand& medals) {
    CLI::App* command = app.add_subcommand(
        "medals",
        "Measure the scores for medals; print assets/medals.toml, and what each bot wins");
    command->add_option("LEVEL", medals.levels, "Names of levels; all unless given");
    command->add_option("--file", medals.file,
                        "Write this file instead, in which other levels keep their marks");
    command
        ->add_option("--seeds", medals.seeds,
                     "Games of the lazy and of the good bot on each level, 10 unless given")
        ->check(CLI::Range(1u, 10000u));
    command->add_option("--ticks", medals.mostTicks, "Longest game in ticks, 43200 unless given")
        ->check(CLI::Range(1u, kLongestReplay));
    return command;
}

CLI::App* addSoak(CLI::App& app, SoakCommand& soak) {
    CLI::App* command = app.add_subcommand(
        "soak", "Play many games with the bot; report halts, escapes and bent paths");
    command->add_option("LEVEL", soak.levels, "Names of levels; all unless given");
    command->add_option("--ticks", soak.ticks, "Ticks in total, 1000000 unless given")
        ->check(CLI::Range(std::uint64_t{1}, kMostSoaked));
    command->add_option("--first-seed", soak.firstSeed, "1 unless given; then 2, 3, ...")
        ->check(CLI::Range(0u, kMostSeed));
    command->add_option("--endless", soak.endless, "Endless levels for each seed, 0 unless given")
        ->check(CLI::Range(0u, kMostEndless));
    command->add_option("--longest", soak.longestGame, "Longest game in ticks, 72000 unless given")
        ->check(CLI::Range(1u, kLongestReplay));
    addChoice(*command, "--player", soak.player, kBotNames)
        ->description("Kind of bot: each but the planner in turn, seed by seed, unless given");
    addChoice(*command, "--mode", soak.mode, kModeNames)
        ->description("Rules of the game: each in turn unless given");
    command->add_flag("--json", soak.json, "Print one JSON object");
    return command;
}

/// The command whose --help explains the error.
std::string helpOf(const CLI::App& app) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return "apart-headless " + (chosen.empty() ? "" : chosen.front()->get_name() + " ") + "--help";
}

/// CLI11 reports only that a command is missing. This names the unknown word in its place.
std::string problemOf(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> unknown = app.remaining();
    if (!app.get_subcommands().empty() || unknown.empty()) {
        return error.what();
    }
    const bool option = unknown.front().starts_with('-');
    return fmt::format("There is no {} '{}'", option ? "option" : "command", unknown.front());
}

int run(int argc, char** argv) {
    CLI::App app("aPart without a screen: plays replays, checks them, lets the bot play.");
    app.name("apart-headless");
    app.require_subcommand(1);
    app.footer(
        "Levels come from the folder levels of share/apart or assets, beside the program or in\n"
        "a folder above it. APART_ASSETS names another folder of assets.\n"
        "endless, endless:SEED and endless:SEED:NUMBER are generated levels.\n"
        "Exit code: 0 success, 1 an unmet expectation, a diverging replay or a failed\n"
        "level check, 2 wrong use or a bad file.");
    app.set_version_flag("--version", "aPart " + versionText());
    PlayCommand play;
    BotOptions options;

    CLI::App* replayCommand = app.add_subcommand("replay", "Play a replay; report expectations");
    CLI::App* verifyCommand = app.add_subcommand("verify", "Play a replay; judge all its lines");
    for (CLI::App* command : {replayCommand, verifyCommand}) {
        command->add_option("FILE", play.file, "The replay, or a link to one")->required();
        command->add_option("--level", play.level, kLevelHelp);
        command->add_flag("--json", play.json, "Print one JSON object");
    }
    replayCommand->add_flag("--link", play.link, kLinkHelp);
    CLI::App* botCommand = app.add_subcommand("bot", "Let the bot play a level until it ends");
    botCommand->add_option("--level", options.level, "Name of the level; the first unless given")
        ->check(wrongName, "");
    botCommand->add_option("--seed", options.seed, "0..4294967295, 1 unless given")
        ->check(wrongSeed, "");
    botCommand->add_option("--ticks", options.ticks, "Stop after so many ticks, 120 a second")
        ->check(CLI::Range(std::uint32_t{1}, kLongestReplay));
    botCommand->add_option("--record", options.record, "Write the game to this file, as a replay");
    botCommand->add_flag("--link", options.link, kLinkHelp);
    botCommand->add_option("--hash-every", options.hashEvery, "Ticks between recorded hashes")
        ->check(CLI::Range(std::uint32_t{1}, kLongestReplay));
    addChoice(*botCommand, "--mode", options.mode, kModeNames)
        ->description("Rules of the game: standard unless given");
    addChoice(*botCommand, "--player", options.player, kBotNames)
        ->description("Kind of bot: good unless given");
    botCommand->add_flag("--json", options.json, "Print one JSON object");
    Checks checks;
    const CLI::App* lintCommand = addLint(app, checks.lint);
    const CLI::App* medalsCommand = addMedals(app, checks.medals);
    const CLI::App* soakCommand = addSoak(app, checks.soak);
    const CLI::App* traceCommand = addTrace(app, checks.trace);
    CLI::App* hashCommand =
        app.add_subcommand("hash", "Play handwritten replays and replace their hash lines");
    hashCommand->add_option("FILE", checks.hashed, "The replays")->required();
    CLI::App* levelsCommand = app.add_subcommand("levels", "List the levels");

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            return app.exit(error); // --help
        }
        complain(fmt::format("apart-headless: {}. Try {}.", problemOf(app, error), helpOf(app)));
        return 2;
    }
    if (replayCommand->parsed()) {
        return playRun(play);
    }
    if (verifyCommand->parsed()) {
        return verify(play);
    }
    if (traceCommand->parsed()) {
        return runTrace(checks.trace);
    }
    if (hashCommand->parsed()) {
        return runHash(checks.hashed);
    }
    if (lintCommand->parsed()) {
        return checks.lint.difficulty ? runDifficulty(checks.lint) : runLint(checks.lint);
    }
    if (medalsCommand->parsed()) {
        return runMedals(checks.medals);
    }
    if (soakCommand->parsed()) {
        return runSoak(checks.soak);
    }
    return levelsCommand->parsed() ? listLevels() : playBot(options);
}

} // namespace
} // namespace apart

int main(int argc, char** argv) {
    try {
        const int code = apart::run(argc, argv);
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            throw apart::Refusal{"the output could not be written to its end"};
        }
        return code;
    } catch (const apart::Refusal& refusal) {
        apart::complain("apart-headless: " + refusal.sentence);
    } catch (const std::exception& error) {
        apart::complain(std::string("apart-headless: ") + error.what());
    }
    return 2;
}
