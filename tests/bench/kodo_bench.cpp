// SPDX-License-Identifier: MIT
// Benchmark of Kodo, Box2D 2.4.1 and Box2D 3: cost and accuracy of a step. Exit code: 0 done, 1 an
// engine was not repeatable or the memory is not enough, 2 invalid options.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <new>

#include "bench_report.hpp"

namespace bench {
namespace {

struct Options {
    RunOptions run;
    int repeat = 1;
    std::string against;
    std::optional<std::string> againstProfile{};
    bool json = false;
    bool list = false;
};

void addOptions(CLI::App& app, Options& options) {
    RunOptions& run = options.run;
    StepOptions& step = run.step;
    CLI::Option* const list = app.add_flag("--list", options.list,
                                           "List the scenes, their sizes and their error measures");
    app.add_option("--scene", run.scene, "The scene; pyramid unless given");
    app.add_option("--engine", run.engine, "kodo, kodo64, box2d or box2d3; kodo unless given")
        ->check(CLI::IsMember(engineNames()));
    app.add_option("--profile", step.profile,
                   "Settings of Kodo; balanced, its default, unless given")
        ->check(CLI::IsMember(profileNames()));
    app.add_option("--substeps", step.substeps,
                   "Number of substeps, instead of the profile's; of Box2D 3 (4)")
        ->check(CLI::Range(1, 64));
    app.add_option("--passes", step.passes, "Velocity iterations of Box2D 2.4.1 (8)")
        ->check(CLI::Range(1, 1000));
    app.add_option("--position-passes", step.positionPasses,
                   "Position iterations of Box2D 2.4.1 (3)")
        ->check(CLI::Range(0, 1000));
    app.add_option(
           "--set", step.set,
           "Other numbers of Kodo's settings: contactHertz=120,...; of Box2D 3: contactHertz, "
           "jointHertz and bullets=1")
        ->delimiter(',');
    app.add_option("--leave-out", step.leaveOut, "Features that Kodo omits, separated by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(featureNames()));
    app.add_option("--continuous", step.continuous, "ContinuousMode of all bodies of Kodo (all)")
        ->check(CLI::IsMember(continuousModeNames()));
    app.add_option("--threads", step.threads, "Number of threads; 1 unless given")
        ->check(CLI::Range(1, 64));
    app.add_option("--steps", run.steps, "Number of steps of 1/60 s, instead of the scene's")
        ->check(CLI::Range(1, 100000000));
    app.add_option("--size", run.size, "Size of the scene, instead of its default; see --list")
        ->check(CLI::Range(1, 10000000));
    app.add_option("--seed", run.seed, "Seed of the random numbers of a scene")
        ->check(CLI::Range(0u, 4294967295u)); // -1 would become 2^64 - 1
    app.add_flag("--peak", run.peak, "Measure depth in every 20th step (disturbs the caches)");
    app.add_flag("--worst", run.worst,
                 "Also the longest step (reads the clock in each, which takes some 0.5 us)");
    app.add_flag("--snapshot", run.snapshot,
                 "Also time and size of a snapshot and of a copy of the World at the end");
    app.add_option("--repeat", options.repeat,
                   "Number of runs; the median of their times is printed")
        ->check(CLI::Range(1, 1000));
    CLI::Option* against = app.add_option("--against", options.against,
                                          "Another engine, run alternately, for the ratio of times")
                               ->check(CLI::IsMember(engineNames()));
    app.add_option("--against-profile", options.againstProfile, "Settings of the other engine")
        ->check(CLI::IsMember(profileNames()))
        ->needs(against);
    app.add_flag("--stages", options.run.step.stages,
                 "Also the time of each stage of a step; of Box2D, of the step as a whole");
    app.add_flag("--json", options.json, "Print one JSON object for each engine");
    for (CLI::Option* const other : app.get_options()) {
        if (other != list && other != app.get_help_ptr()) {
            list->excludes(other);
        }
    }
}

void list() {
    for (const Recipe& recipe : recipes()) {
        const Scene scene = recipe.make(recipe.size, 1);
        fmt::print("{:<10} {}\n{:<10} {} steps", recipe.name, recipe.about, "", recipe.steps);
        if (!recipe.sizeMeans.empty()) {
            fmt::print("; size {}: {}", recipe.size, recipe.sizeMeans);
        }
        if (scene.error) {
            fmt::print("; error: {}", scene.error->name);
        }
        fmt::print("\n");
    }
    std::string names;
    for (const Recipe& recipe : sandboxRecipes()) {
        try {
            recipe.make(recipe.size, 1);
            names += (names.empty() ? "" : ", ") + recipe.name;
        } catch (const WrongUse&) { // no scene for all engines
        }
    }
    fmt::print(" Of the sandbox: {}\n", names);
}

/// The other engine has default step options: only the scene and what is measured are shared, but
/// for a snapshot, which Box2D 2.4.1 does not have.
RunOptions opponentOf(const Options& options) {
    RunOptions other = options.run;
    other.engine = options.against;
    other.step = {};
    other.snapshot = options.run.snapshot && options.against != "box2d";
    other.step.profile = options.againstProfile;
    return other;
}

void runAll(const Options& options) {
    std::vector<Result> ours;
    std::vector<Result> theirs;
    for (int i = 0; i < options.repeat; ++i) {
        ours.push_back(run(options.run));
        if (!options.against.empty()) {
            theirs.push_back(run(opponentOf(options)));
        }
    }
    std::vector<Summary> summaries{summaryOf(std::move(ours))};
    if (!theirs.empty()) {
        summaries.push_back(summaryOf(std::move(theirs)));
        summaries[0].against = options.against;
        summaries[0].ratio = summaries[0].result.cpuSeconds / summaries[1].result.cpuSeconds;
    }
    for (const Summary& summary : summaries) {
        fmt::print("{}\n", options.json ? asJson(summary, options.run.step.stages)
                                        : asText(summary, options.run.step.stages));
    }
}

std::string sceneOf(const RunOptions& options) {
    return fmt::format("--scene {}", options.scene) +
           (options.size ? fmt::format(" --size {}", *options.size) : "");
}

int main(int argc, char** argv) {
    CLI::App app("Cost and accuracy of a step, in Kodo, Box2D 2.4.1 and Box2D 3.");
    app.name("kodo-bench");
    app.footer(
        "Times are CPU times of the calling thread during steps, also those of the ratio by "
        "--against.\nThe gain by helper threads shows in the wall time. Exit code: 0 done, 1 an "
        "engine was not\nrepeatable or the memory is not enough, 2 wrong use.");
    Options options;
    addOptions(app, options);
    try {
        app.parse(argc, argv);
        options.list ? list() : runAll(options);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            return app.exit(error); // --help
        }
        fmt::print(stderr, "kodo-bench: {}. Try kodo-bench --help.\n", error.what());
        return 2;
    } catch (const NotRepeatable& error) {
        fmt::print(stderr, "kodo-bench: {}.\n", error.what());
        return 1;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "kodo-bench: the memory is not enough for {}.\n", sceneOf(options.run));
        return 1;
    } catch (const std::exception& error) { // WrongUse, or a size rejected by an engine
        fmt::print(stderr, "kodo-bench: {}.\n", error.what());
        return 2;
    }
    return 0;
}

} // namespace
} // namespace bench

int main(int argc, char** argv) {
    return bench::main(argc, argv);
}
