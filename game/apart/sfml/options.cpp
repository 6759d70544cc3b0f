// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/text_file.hpp>
#include <apart/core/version.hpp>
#include <apart/sfml/options.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>

namespace apart {

std::variant<Options, int> parseOptions(int argc, char** argv) {
    Options options;
    CLI::App app("aPart: a Breakout whose blocks come apart where they are hit.", "apart");
    app.footer(
        "Keys: mouse, left/right or A/D move the paddle; space or click serves; left button,\n"
        "down or S pulls, right button, up or W pushes; P or escape pauses, R restarts,\n"
        "M sound, F3 debug overlay of the engine; Options binds other keys. In menus: arrows,\n"
        "enter, escape, or the mouse.\n"
        "Settings and best scores: apart/profile.toml in XDG_CONFIG_HOME or ~/.config; beside\n"
        "it last.replay, the last game, and best/, the best one of each level\n"
        "and mode, and the best endless runs. Files in levels/ there are levels of your own.\n"
        "Exit code: 0 done, 2 wrong use or a bad file, 3 no display.");
    app.set_version_flag("--version", "aPart " + versionText());
    app.add_option("--level", options.level,
                   "Start with this level: the name of one of the game, daily, endless, or\n"
                   "a file .toml, which is read again whenever it changes")
        ->check(wrongName, "");
    app.add_option("--seed", options.seed,
                   "0..4294967295; the same seed and input give the same game")
        ->check(wrongSeed, "");
    auto* replay =
        app.add_option("--replay", options.replay, "Show a recorded game: a file, or a link");
    app.add_option("--film", options.film,
                   "Write the largest fall of the replay as a film (gif), and exit")
        ->needs(replay);
    auto* ghost = app.add_option("--ghost", options.ghost,
                                 "Play the level of this replay, file or link, beside its ghost");
    app.add_option("--page", options.page,
                   "Address of a page of the game, for links that are copied; none unless given");
    auto* edit = app.add_option("--edit", options.edit,
                                "Edit the level of this file .toml, which need not exist");
    auto* duel =
        app.add_flag("--duel", options.duel,
                     "Start with two players at this screen, each with a game of the level");
    app.add_flag("--all-levels", options.allLevels, "All levels of the map are open");
    app.add_flag("--mute", options.mute, "No sound");
    auto* shot = app.add_option("--screenshot", options.screenshot,
                                "Write a picture (png) of the bot's game or the replay, and exit");
    app.add_option("--at", options.at, "Tick of the screenshot, 120 a second")
        ->capture_default_str()
        ->check(CLI::Range(0u, 1000000u))
        ->needs(shot);
    app.add_option("--shots", options.shots, "Write this many pictures, NAME0000.png and on")
        ->capture_default_str()
        ->check(CLI::Range(1u, 9999u))
        ->needs(shot);
    app.add_option("--every", options.every, "Ticks from one picture to the next")
        ->capture_default_str()
        ->check(CLI::Range(1u, 10000u))
        ->needs(shot);
    auto* frames = app.add_option("--frames", options.frames,
                                  "Draw this many frames of the bot's game as fast as possible, "
                                  "print their times, and exit");
    frames->check(CLI::Range(1u, 1000000u))->excludes(shot);
    app.add_option("--crowd", options.crowd, "Time only frames with at least this many bodies")
        ->needs(frames);
    app.add_flag("--probe-display", options.probeDisplay,
                 "Report by the exit code whether a window can be opened: 0 yes, 3 no");
    ghost->excludes(replay)->excludes(edit);
    duel->excludes(replay)->excludes(edit)->excludes(ghost);
    edit->excludes(replay)->excludes(shot)->excludes(frames);
    app.get_option("--level")->excludes(replay)->excludes(edit);
    app.get_option("--seed")->excludes(replay);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            return app.exit(error); // --help
        }
        std::fprintf(stderr, "apart: %s. Try apart --help.\n", printable(error.what()).c_str());
        return kRefused;
    }
    return options;
}

} // namespace apart
