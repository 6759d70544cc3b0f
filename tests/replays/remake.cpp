// SPDX-License-Identifier: MIT
// Remakes scripted replays after a change of the engine or the rules: see kUsage.
#include <apart/core/assets.hpp>
#include <apart/core/generator.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "replay_text.hpp"

namespace {

using namespace apart;
using LevelPointer = std::shared_ptr<const Level>;

constexpr const char* kUsage =
    "remake-replays [--all] [--check] [FILE...]\n"
    "Remakes scripted replays whose expectations no longer hold; without FILE, all of the folder.\n"
    "A replay that expects largestFall shows a collapse. Seed and target of the paddle are those\n"
    "of the largest fall which half a ball (0.3 m) to either side brings down by half too, and\n"
    "its expectations are measured again. In other replays seed and targets are changed as little\n"
    "as possible until the expectations hold, with some tolerance.\n"
    "  --all    remakes every collapse, even if its expectations hold\n"
    "  --check  changes no file\n"
    "Exit code: 0 all hold, 1 some replay can only be changed by hand (or, with --check, must be\n"
    "remade), 2 wrong use.\n";

constexpr std::uint32_t kServeTick = 90;
constexpr std::uint32_t kSeeds = 20;
constexpr int kReach = 9000;       // 1/1000 m; largest target of the paddle
constexpr int kStride = 300;       // 1/1000 m, between the targets of the first scan
constexpr int kHalfBall = 300;     // 1/1000 m
constexpr std::size_t kBest = 300; // candidates whose neighbours are played
constexpr std::uint32_t kLongestScan = kServeTick + 8 * kTicksPerSecond;
constexpr std::uint32_t kCalmTicks = 2 * kTicksPerSecond; // without a further fall: it is over
constexpr std::int32_t kLeastFall = 6;                    // as in the test of buildings
constexpr std::uint32_t kTries = 12000;                   // of other replays

constexpr std::chrono::seconds kLongestSearch{20}; // of one of these

/// Calls work(i) for i in 0..count-1 on all cores.
void inParallel(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::thread& thread : threads) {
        thread = std::thread([&] {
            for (std::size_t i = next++; i < count; i = next++) {
                work(i);
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
}

/// Plays the first serve with the paddle at a fixed target. The serve of Mode::Pure is not hollow.
Collapsing collapseOf(const LevelPointer& level, Mode mode, std::uint32_t seed, int target) {
    Game game(level, seed, mode);
    Collapsing found{.seed = seed, .target = target, .blocks = game.blocksAtStart()};
    Input input;
    input.target = static_cast<std::int16_t>(target);
    while (game.ticks() < kLongestScan && game.result() == Result::Playing) {
        input.launch = game.ticks() == kServeTick;
        game.tick(input);
        for (const Event& event : game.events()) {
            const auto* hit = std::get_if<Struck>(&event);
            if (hit != nullptr && found.hitTick == 0 && hit->what == Role::Block) {
                found.hitTick = game.ticks();
                found.stuff = std::string(kStuffNames[static_cast<std::size_t>(hit->stuff)]);
                found.hitX = static_cast<double>(hit->point.x);
            }
            if (std::holds_alternative<LetGo>(event) && found.fallTick == 0) {
                found.fallTick = game.ticks();
            }
        }
        if (game.collapse().largest > found.largest) {
            found.largest = game.collapse().largest;
            found.largestTick = game.ticks();
        }
        if (found.largest > 0 && game.ticks() > found.largestTick + kCalmTicks) {
            break;
        }
    }
    return found;
}

/// The unmet expectations, with all targets moved by `shift` (1/1000 m).
std::vector<Playback::Failure> failuresOf(Replay replay, const LevelPointer& level, int shift) {
    moveTargets(replay, shift);
    Playback playback(std::move(replay), level);
    while (!playback.done() && playback.failures().empty()) {
        playback.tick();
    }
    return playback.failures();
}

/// Most blocks of one collapse, as the test of buildings measures it.
std::int32_t largestFall(Replay replay, const LevelPointer& level, int shift) {
    moveTargets(replay, shift);
    replay.end += 3 * kTicksPerSecond;
    Playback playback(std::move(replay), level);
    while (!playback.done()) {
        playback.tick();
    }
    return playback.game().collapse().largest;
}

bool isCollapse(const Replay& replay) {
    return std::any_of(replay.expectations.begin(), replay.expectations.end(),
                       [](const Expectation& e) { return e.field == Field::LargestFall; });
}

bool isSound(const Replay& replay, const LevelPointer& level) {
    if (!failuresOf(replay, level, 0).empty()) {
        return false;
    }
    if (!isCollapse(replay)) {
        return true;
    }
    const std::int32_t fall = largestFall(replay, level, 0);
    return fall >= kLeastFall && 2 * largestFall(replay, level, -kHalfBall) >= fall &&
           2 * largestFall(replay, level, kHalfBall) >= fall;
}

/// Parses text made by this program.
std::optional<Replay> parsed(const std::string& text, const std::string& file) {
    const Read<Replay> read = parseReplay(text, file);
    const auto* replay = std::get_if<Replay>(&read);
    return replay == nullptr ? std::nullopt : std::optional(*replay);
}

/// New text of a replay that shows a collapse; empty if no serve brings one down.
std::string remadeCollapse(const std::string& text, const Replay& replay,
                           const LevelPointer& level) {
    const FirstHit wanted = firstHitOf(text);
    std::vector<Collapsing> found;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        for (int target = -kReach; target <= kReach; target += kStride) {
            found.push_back({.seed = seed, .target = target});
        }
    }
    inParallel(found.size(), [&](std::size_t i) {
        found[i] = collapseOf(level, replay.mode, found[i].seed, found[i].target);
    });
    std::erase_if(found,
                  [&](const Collapsing& c) { return c.largest < kLeastFall || !wanted.allows(c); });
    std::stable_sort(found.begin(), found.end(), [](const Collapsing& a, const Collapsing& b) {
        return a.largest > b.largest;
    });
    found.resize(std::min(found.size(), kBest));
    inParallel(2 * found.size(), [&](std::size_t i) {
        Collapsing& middle = found[i / 2];
        const int side = i % 2 == 0 ? -kHalfBall : kHalfBall;
        const Collapsing beside = collapseOf(level, replay.mode, middle.seed, middle.target + side);
        (i % 2 == 0 ? middle.besideLeft : middle.besideRight) = beside.largest;
    });
    // The weakest of the three counts most, then the fall itself; late falls lose some.
    const auto worth = [](const Collapsing& c) {
        const std::int32_t weakest = std::min({c.largest, c.besideLeft, c.besideRight});
        return 1000 * weakest + 10 * c.largest - (c.largestTick > 600 ? 500 : 0);
    };
    std::stable_sort(found.begin(), found.end(),
                     [&](const Collapsing& a, const Collapsing& b) { return worth(a) > worth(b); });
    for (const Collapsing& collapse : found) {
        const std::string candidate = withCollapse(text, collapse);
        const std::optional<Replay> made = parsed(candidate, replay.level);
        if (made && isSound(*made, level)) {
            return candidate;
        }
    }
    return {};
}

/// The targets of a candidate: each group of equal targets is moved by its own amount, which grows
/// with the number of tries.
std::vector<int> shiftsOf(std::uint32_t attempt, std::size_t groups) {
    Generator chance(mixKeys(attempt, 5));
    const kodo::Real reach = 40 + kodo::Real(1500) * static_cast<kodo::Real>(attempt % 1000) / 1000;
    std::vector<int> shifts;
    for (std::size_t i = 0; i < groups; ++i) {
        shifts.push_back(10 * static_cast<int>(chance.between(-reach, reach) / 10));
    }
    return shifts;
}

/// Changed seed and targets with which the expectations hold; empty if none is found.
std::string remadeScript(const std::string& text, const Replay& replay, const LevelPointer& level) {
    const std::size_t groups = targetGroups(replay);
    if (groups == 0) {
        return {};
    }
    constexpr std::array<int, 4> kTolerances = {-10, 10, -30, 30}; // 1/1000 m
    const auto end = std::chrono::steady_clock::now() + kLongestSearch;
    std::vector<int> tolerated(kTries, -1);
    std::atomic<std::uint32_t> firstFirm = kTries; // the search ends there
    inParallel(kTries, [&](std::size_t i) {
        const auto attempt = static_cast<std::uint32_t>(i);
        if (attempt > firstFirm || std::chrono::steady_clock::now() > end) {
            return;
        }
        Replay changed = replay;
        changed.seed = seedOfAttempt(replay.seed, attempt);
        moveGroups(changed, shiftsOf(attempt, groups));
        if (!failuresOf(changed, level, 0).empty()) {
            return;
        }
        tolerated[i] =
            static_cast<int>(std::count_if(kTolerances.begin(), kTolerances.end(), [&](int shift) {
                return failuresOf(changed, level, shift).empty();
            }));
        if (tolerated[i] == static_cast<int>(kTolerances.size())) {
            std::uint32_t seen = firstFirm;
            while (attempt < seen && !firstFirm.compare_exchange_weak(seen, attempt)) {
            }
        }
    });
    const auto best = std::max_element(tolerated.begin(), tolerated.end());
    if (*best < 0) {
        return {};
    }
    const auto attempt = static_cast<std::uint32_t>(best - tolerated.begin());
    return withTargets(text, seedOfAttempt(replay.seed, attempt), shiftsOf(attempt, groups));
}

struct Options {
    bool all = false;
    bool check = false;
    std::vector<std::filesystem::path> files;
};

enum class Outcome { Holds, Remade, Stale, ByHand };

Outcome remake(const std::filesystem::path& file, const Options& options) {
    const Read<std::string> content = readTextFile(file, kLargestReplay);
    if (!std::holds_alternative<std::string>(content)) {
        std::printf("%s\n", std::get<FileProblem>(content).text().c_str());
        return Outcome::ByHand;
    }
    const std::string& text = std::get<std::string>(content);
    const std::optional<Replay> replay = parsed(text, file.string());
    const Read<Level> read = loadLevelOf(file, replay ? replay->level : "");
    if (!replay || !std::holds_alternative<Level>(read)) {
        return Outcome::ByHand;
    }
    const auto level = std::make_shared<const Level>(std::get<Level>(read));
    if (isSound(*replay, level) && !(options.all && isCollapse(*replay))) {
        return Outcome::Holds;
    }
    if (options.check) {
        return Outcome::Stale;
    }
    const std::string made = isCollapse(*replay) ? remadeCollapse(text, *replay, level)
                                                 : remadeScript(text, *replay, level);
    if (made.empty() || writeTextFile(file, made)) {
        return Outcome::ByHand;
    }
    return Outcome::Remade;
}

int run(const Options& options) {
    std::map<Outcome, int> count;
    for (const std::filesystem::path& file : options.files) {
        const Outcome outcome = remake(file, options);
        ++count[outcome];
        constexpr std::array<const char*, 4> kWords = {"", "remade", "must be remade",
                                                       "must be changed by hand"};
        if (outcome != Outcome::Holds) {
            std::printf("%s: %s\n", file.filename().string().c_str(),
                        kWords[static_cast<std::size_t>(outcome)]);
            std::fflush(stdout);
        }
    }
    std::printf("%d hold, %d remade, %d must be remade, %d must be changed by hand.\n",
                count[Outcome::Holds], count[Outcome::Remade], count[Outcome::Stale],
                count[Outcome::ByHand]);
    return count[Outcome::Stale] + count[Outcome::ByHand] > 0 ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    for (const std::string argument : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
        if (argument == "--all") {
            options.all = true;
        } else if (argument == "--check") {
            options.check = true;
        } else if (argument.starts_with("-")) {
            std::fputs(kUsage, argument == "--help" ? stdout : stderr);
            return argument == "--help" ? 0 : 2;
        } else {
            options.files.emplace_back(argument);
        }
    }
    if (options.files.empty()) {
        for (const auto& entry : std::filesystem::directory_iterator(APART_REPLAYS)) {
            if (entry.path().extension() == ".replay") {
                options.files.push_back(entry.path());
            }
        }
        std::sort(options.files.begin(), options.files.end());
    }
    return run(options);
}
