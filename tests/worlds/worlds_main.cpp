// SPDX-License-Identifier: MIT
// Judges random worlds from the command line; see tools/worlds.
#include <CLI/CLI.hpp>
#include <base/assert.hpp>
#include <worlds/invariance.hpp>
#include <worlds/ordinary.hpp>
#include <worlds/recipe.hpp>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace {

constexpr const char* kPrecision = sizeof(kodo::Real) == 4 ? "float" : "double";

struct Options {
    std::uint64_t seed = 1;
    std::uint64_t count = 1000;
    unsigned jobs = 1;
    bool shrink = false;
    std::string into = ".";  // folder of shrunk worlds
    std::string replay = {}; // file
    bool print = false;
    bool ordinary = false;
    bool invariances = false;
};

void throwFailure(const char* condition, const char* file, int line) {
    throw std::logic_error(std::string(file) + ":" + std::to_string(line) + ": " + condition);
}

constexpr const char* kJudges =
    "Judges, and what they object to:\n"
    "  energy     kinetic and potential energy above what was put in, by 0.5 % of the scale\n"
    "  momentum   a change of momentum or angular momentum where nothing outside acts\n"
    "  through    the path of a body crosses another body\n"
    "  touch      a touch that begins twice, or has no begin, no end or no record\n"
    "  sleep      all bodies sleep, and one of them would move without sleep\n"
    "  twin       a copy, a snapshot, one with queries or a second thread has other bits\n"
    "  numbers    a number that is not finite, or a frozen body\n"
    "  exception  an exception, or an assertion that fails\n"
    "\"of the scale\" in a finding of energy: relative to the largest kinetic energy so far, or, "
    "if\n"
    "larger, to the weight of all bodies times one length unit; work that was put in is added.\n"
    "Exit code: 0 no finding, 1 a judge objected, 2 wrong use or a bad file.";

/// Accepts digits alone: conversions of the library also take a sign.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most) {
    const auto problem = [=](const std::string& text) {
        std::uint64_t number = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        const bool valid = stop == end && error == std::errc{} && number >= least && number <= most;
        return valid ? std::string()
                     : "must be a whole number from " + std::to_string(least) + " to " +
                           std::to_string(most) + ", but is '" + text + "'";
    };
    return CLI::Validator(problem, "");
}

void addOptions(CLI::App& app, Options& options) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    CLI::Option* const seed =
        app.add_option("--seed", options.seed, "The first seed, 1 unless given")
            ->check(wholeNumber(0, kMost));
    CLI::Option* const count =
        app.add_option("--count", options.count, "Number of worlds, 1000 unless given")
            ->check(wholeNumber(1, kMost));
    CLI::Option* const jobs =
        app.add_option("--jobs", options.jobs, "Number of threads, 1 unless given")
            ->check(wholeNumber(1, 256));
    CLI::Option* const shrink = app.add_flag(
        "--shrink", options.shrink, "Make each failing world as small as possible, and save it");
    CLI::Option* const into =
        app.add_option("--into", options.into, "Folder of the saved worlds; this one unless given")
            ->needs(shrink);
    CLI::Option* const replay =
        app.add_option("--replay", options.replay, "Judge this saved world instead");
    CLI::Option* const print =
        app.add_flag("--print", options.print, "Print the world of the seed instead");
    CLI::Option* const ordinary = app.add_flag("--ordinary", options.ordinary,
                                               "Judge ordinary scenes instead, for 30 s each");
    CLI::Option* const invariances = app.add_flag(
        "--invariances", options.invariances, "Judge what must not change the outcome of a world");
    ordinary->excludes(invariances);
    for (CLI::Option* const unused : {count, jobs, shrink, into}) {
        replay->excludes(unused);
        print->excludes(unused);
    }
    replay->excludes(seed)->excludes(print);
}

/// Throws CLI::ParseError.
void readOptions(CLI::App& app, Options& options, int argc, char** argv) {
    addOptions(app, options);
    app.parse(argc, argv);
    if (!options.print &&
        options.seed > std::numeric_limits<std::uint64_t>::max() - (options.count - 1)) {
        throw CLI::ValidationError("--seed + --count - 1, the last seed, must be below 2^64");
    }
}

worlds::Recipe recipeOf(const Options& options, std::uint64_t seed) {
    return options.ordinary      ? worlds::ordinaryRecipe(seed)
           : options.invariances ? worlds::invarianceRecipe(seed)
                                 : worlds::randomRecipe(seed);
}

std::vector<worlds::Finding> findingsOf(const Options& options, const worlds::Recipe& recipe) {
    if (options.invariances) {
        return worlds::judgeInvariances(recipe);
    }
    if (options.ordinary) {
        return worlds::runOrdinary(recipe, *worlds::ordinaryInKodo(recipe)).faults;
    }
    const std::optional<worlds::Finding> finding = worlds::judge(recipe);
    return finding ? std::vector{*finding} : std::vector<worlds::Finding>{};
}

/// Judges seeds on several threads, each at its own pace.
class Judging {
public:
    explicit Judging(const Options& options) : options_(options) {}

    bool run() {
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < options_.jobs; ++i) {
            threads.emplace_back([this] { work(); });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        std::printf("%s: %llu worlds from seed %llu on, %zu findings", kPrecision,
                    static_cast<unsigned long long>(options_.count),
                    static_cast<unsigned long long>(options_.seed), findings_);
        const char* comma = ": ";
        for (const auto& entry : byJudge_) {
            std::printf("%s%d %s", comma, entry.second, entry.first.c_str());
            comma = ", ";
        }
        std::printf("\n");
        return findings_ == 0;
    }

private:
    void work() {
        for (;;) {
            const std::uint64_t index = next_++;
            if (index >= options_.count) {
                return;
            }
            const std::uint64_t seed = options_.seed + index;
            const worlds::Recipe recipe = recipeOf(options_, seed);
            for (const worlds::Finding& finding : findingsOf(options_, recipe)) {
                report(seed, recipe, finding);
            }
            const std::uint64_t done = ++done_;
            if (done % (options_.count / 20 + 1) == 0) {
                const std::lock_guard lock(mutex_);
                std::printf("%s: %llu of %llu worlds, %zu findings\n", kPrecision,
                            static_cast<unsigned long long>(done),
                            static_cast<unsigned long long>(options_.count), findings_);
                std::fflush(stdout);
            }
        }
    }

    void report(std::uint64_t seed, const worlds::Recipe& recipe, const worlds::Finding& finding) {
        std::string file;
        if (options_.shrink) {
            const worlds::Judge again = [&](const worlds::Recipe& smaller) {
                return options_.invariances ? judgeInvariance(smaller, finding.judge)
                                            : worlds::judge(smaller);
            };
            const worlds::Recipe small = worlds::shrink(recipe, finding, again);
            file = options_.into + "/" + finding.judge + "_" + kPrecision + "_" +
                   std::to_string(seed) + ".world";
            std::ofstream(file) << worlds::toText(small);
        }
        const std::lock_guard lock(mutex_);
        ++findings_;
        ++byJudge_[finding.judge];
        std::printf("%s: seed %llu (%s): %s, step %d: %s %s\n", kPrecision,
                    static_cast<unsigned long long>(seed), worlds::kindOf(recipe).c_str(),
                    finding.judge.c_str(), finding.step, finding.text.c_str(), file.c_str());
        std::fflush(stdout);
    }

    const Options& options_;
    std::atomic<std::uint64_t> next_{0};
    std::atomic<std::uint64_t> done_{0};
    std::mutex mutex_;
    std::size_t findings_ = 0;
    std::map<std::string, int> byJudge_;
};

int replay(const Options& options) {
    std::error_code ignored;
    if (std::filesystem::is_directory(options.replay, ignored)) {
        std::fprintf(stderr, "worlds: %s is a folder, not a file.\n", options.replay.c_str());
        return 2;
    }
    std::ifstream file(options.replay);
    if (!file) {
        std::fprintf(stderr, "worlds: %s cannot be read.\n", options.replay.c_str());
        return 2;
    }
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::optional<worlds::Recipe> recipe = worlds::fromText(text);
    if (!recipe) {
        std::fprintf(stderr, "worlds: %s is no saved world.\n", options.replay.c_str());
        return 2;
    }
    const std::vector<worlds::Finding> findings = findingsOf(options, *recipe);
    const char* const path = options.replay.c_str();
    for (const worlds::Finding& finding : findings) {
        std::printf("%s: %s: %s, step %d: %s\n", kPrecision, path, finding.judge.c_str(),
                    finding.step, finding.text.c_str());
    }
    if (findings.empty()) {
        std::printf("%s: %s: no finding\n", kPrecision, path);
    }
    return findings.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Random worlds, judged in each step.");
    app.name("worlds");
    app.footer(kJudges);
    Options options;
    try {
        readOptions(app, options, argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            return app.exit(error); // --help
        }
        std::fprintf(stderr, "worlds: %s. Try worlds --help.\n", error.what());
        return 2;
    }
    kodo::setAssertHandler(&throwFailure);
    if (!options.replay.empty()) {
        return replay(options);
    }
    if (options.print) {
        std::fputs(worlds::toText(recipeOf(options, options.seed)).c_str(), stdout);
        return 0;
    }
    if (options.ordinary) {
        const std::string into = options.shrink ? options.into : std::string();
        return worlds::reportOrdinary({options.seed, options.count, options.jobs, into}) ? 0 : 1;
    }
    return Judging(options).run() ? 0 : 1;
}
