// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/game_observer.hpp>
#include <apart/core/player.hpp>
#include <apart/core/tuning.hpp>
#include <apart/headless/refusal.hpp>
#include <apart/headless/report.hpp>
#include <apart/headless/soak_command.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>

namespace apart {

namespace {

constexpr std::uint32_t kReportEvery = 2048;              // ticks
constexpr std::size_t kBotsInTurn = kBotNames.size() - 1; // the planner, the last, takes long

/// Statistics of the games on one level, or on all.
struct SoakStatistics {
    std::string level;
    std::uint32_t games = 0;
    std::uint32_t won = 0;
    std::uint32_t lost = 0;
    std::uint32_t unfinished = 0; // stopped at SoakCommand::longestGame
    std::uint64_t wonTicks = 0;
    std::int64_t livesLost = 0;
    Observations observed{};
    std::uint32_t waited = 0;           // games with LetGo::Why::Fatigue
    std::vector<std::uint32_t> waits{}; // longest wait of each game, ticks
    std::uint64_t glowTicks = 0;        // in play, with a patience other than Calm
    std::uint64_t lastTicks = 0;        // of the last kLastBlocks blocks, in games that were won
    std::uint64_t bounces = 0;          // of balls, in Mode::Standard
    std::uint64_t bentBounces = 0;      // of these, rotated out of the flat cone
    std::uint64_t thrownBounces = 0;    // of these, thrown off rubble
    std::uint64_t bentInPure = 0;       // in Mode::Pure; must be 0
    double gameSeconds = 0;             // processor time of Game::tick() alone

    void add(const SoakStatistics& other) {
        games += other.games;
        won += other.won;
        lost += other.lost;
        unfinished += other.unfinished;
        wonTicks += other.wonTicks;
        livesLost += other.livesLost;
        observed.add(other.observed);
        waited += other.waited;
        waits.insert(waits.end(), other.waits.begin(), other.waits.end());
        glowTicks += other.glowTicks;
        lastTicks += other.lastTicks;
        bounces += other.bounces;
        bentBounces += other.bentBounces;
        thrownBounces += other.thrownBounces;
        bentInPure += other.bentInPure;
        gameSeconds += other.gameSeconds;
    }
    bool clean() const {
        return observed.faults() == 0 && bentInPure == 0 && observed.longestWait <= kFailTicks + 1;
    }
    double microsecondsPerTick() const {
        return observed.ticks > 0 ? 1e6 * gameSeconds / static_cast<double>(observed.ticks) : 0;
    }
    double meanWin() const { // s
        return won > 0 ? static_cast<double>(wonTicks) / won / kTicksPerSecond : 0;
    }
    double meanLast() const { // s
        return won > 0 ? static_cast<double>(lastTicks) / won / kTicksPerSecond : 0;
    }
    /// Quantile of the longest waits (s): this share of the games does not exceed it.
    double wait(double share) const {
        if (waits.empty()) {
            return 0;
        }
        std::vector<std::uint32_t> sorted = waits;
        std::sort(sorted.begin(), sorted.end());
        const auto rank = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
        return static_cast<double>(sorted[rank]) / kTicksPerSecond;
    }
    double glowShare() const { // %
        return observed.ticks > 0
                   ? 100 * static_cast<double>(glowTicks) / static_cast<double>(observed.ticks)
                   : 0;
    }
};

double cpuSeconds() {
    timespec now{};
    if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now) != 0 || (now.tv_sec | now.tv_nsec) == 0) {
        clock_gettime(CLOCK_MONOTONIC, &now); // WebAssembly knows no other
    }
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Match {
    std::shared_ptr<const Level> level;
    std::uint32_t seed = 1;
    BotKind player = BotKind::Good;
    Mode mode = Mode::Standard;
};

/// Plays one game until it ends or `mostTicks` have passed.
SoakStatistics soak(const Match& match, std::uint64_t mostTicks,
                    const std::function<void(std::uint32_t)>& show) {
    Game game(match.level, match.seed, match.mode);
    Player player(match.player);
    GameObserver observer;
    SoakStatistics statistics{.level = match.level->name, .games = 1};
    std::uint64_t lastTicks = 0;
    while (game.result() == Result::Playing && game.ticks() < mostTicks) {
        const Input input = player.next(game);
        const double start = cpuSeconds();
        game.tick(input);
        statistics.gameSeconds += cpuSeconds() - start;
        observer.observe(game);
        statistics.glowTicks +=
            game.state().patience() != Patience::Calm && !game.serving() ? 1 : 0;
        lastTicks += game.blocksLeft() <= kLastBlocks ? 1 : 0;
        for (const Event& event : game.events()) {
            const auto* let = std::get_if<LetGo>(&event);
            statistics.waited =
                let != nullptr && let->why == LetGo::Why::Fatigue ? 1 : statistics.waited;
        }
        if (game.ticks() % kReportEvery == 0) {
            show(game.ticks());
        }
    }
    statistics.observed = observer.observations();
    statistics.won = game.result() == Result::Won ? 1 : 0;
    statistics.lost = game.result() == Result::Lost ? 1 : 0;
    statistics.wonTicks = statistics.won * statistics.observed.ticks;
    statistics.livesLost = match.level->lives - game.lives();
    statistics.waits.push_back(statistics.observed.longestWait);
    statistics.lastTicks = statistics.won * lastTicks;
    const Ledger& ledger = game.ledger();
    if (match.mode == Mode::Pure) {
        statistics.bentInPure = ledger.bentBounces + ledger.thrownBounces;
    } else {
        statistics.bounces = ledger.bounces;
        statistics.bentBounces = ledger.bentBounces;
        statistics.thrownBounces = ledger.thrownBounces;
    }
    if (!statistics.clean()) {
        fmt::print(stderr,
                   "{}, seed {}, {} player, {}: {} halts, {} escapes, {} bent paths, {} bent "
                   "bounces in pure mode, {} ticks without damage.\n",
                   match.level->name, match.seed, kBotNames[static_cast<std::size_t>(match.player)],
                   kModeNames[static_cast<std::size_t>(match.mode)], statistics.observed.halts,
                   statistics.observed.escapes, statistics.observed.bends, statistics.bentInPure,
                   statistics.observed.longestWait);
    }
    return statistics;
}

std::string asJson(const SoakStatistics& statistics) {
    return fmt::format(
        R"({{"level": "{}", "games": {}, "won": {}, "lost": {}, "unfinished": {}, "ticks": {}, )"
        R"("freeFlightTicks": {}, "meanWinSeconds": {:.1f}, "livesLost": {}, "halts": {}, )"
        R"("escapes": {}, "bends": {}, "longestWaitTicks": {}, "waited": {}, )"
        R"("waitSeconds50": {:.1f}, "waitSeconds90": {:.1f}, "waitSeconds99": {:.1f}, )"
        R"("glowPercent": {:.2f}, "lastBlocksSeconds": {:.1f}, "bounces": {}, "bentBounces": {}, )"
        R"("thrownBounces": {}, "bentBouncesInPure": {}, )"
        R"("microsecondsPerTick": {:.1f}}})",
        statistics.level, statistics.games, statistics.won, statistics.lost, statistics.unfinished,
        statistics.observed.ticks, statistics.observed.freeTicks, statistics.meanWin(),
        statistics.livesLost, statistics.observed.halts, statistics.observed.escapes,
        statistics.observed.bends, statistics.observed.longestWait, statistics.waited,
        statistics.wait(0.5), statistics.wait(0.9), statistics.wait(0.99), statistics.glowShare(),
        statistics.meanLast(), statistics.bounces, statistics.bentBounces, statistics.thrownBounces,
        statistics.bentInPure, statistics.microsecondsPerTick());
}

void printRow(const SoakStatistics& statistics) {
    fmt::print("{:<20} {:>6} {:>6} {:>5} {:>7} {:>9} {:>6.1f} {:>6.1f} {:>5} {:>5} {:>5} {:>5} "
               "{:>5.1f} {:>5.1f} {:>5.1f} {:>5.1f} {:>5.1f} {:>7.1f}\n",
               statistics.level, statistics.games, statistics.won, statistics.lost,
               statistics.unfinished, statistics.observed.ticks, statistics.meanWin(),
               statistics.meanLast(), statistics.livesLost, statistics.observed.halts,
               statistics.observed.escapes, statistics.observed.bends, statistics.wait(0.5),
               statistics.wait(0.9), statistics.wait(0.99), statistics.wait(1),
               statistics.glowShare(), statistics.microsecondsPerTick());
}

void printTable(const std::vector<SoakStatistics>& perLevel, const SoakStatistics& total) {
    fmt::print("{:<20} {:>6} {:>6} {:>5} {:>7} {:>9} {:>6} {:>6} {:>5} {:>5} {:>5} {:>5} {:>23} "
               "{:>5} {:>7}\n",
               "level", "games", "won", "lost", "cut off", "ticks", "won in", "last 3", "lives",
               "halts", "esca-", "bends", "longest wait of a game,", "glows", "us a");
    fmt::print("{:>62} {:>6} {:>5} {:>11} {:>29} {:>5} {:>7}\n", "s,mean", "s,mean", "lost", "pes",
               "s: 50 %  90 %  99 %   all", "%", "tick");
    for (const SoakStatistics& statistics : perLevel) {
        printRow(statistics);
    }
    printRow(total);
}

void printAll(const std::vector<SoakStatistics>& perLevel, const SoakStatistics& total, bool json) {
    if (json) {
        fmt::print("{{\"total\": {}, \"levels\": [", asJson(total));
        for (std::size_t i = 0; i < perLevel.size(); ++i) {
            fmt::print("{}{}", i == 0 ? "\n " : ",\n ", asJson(perLevel[i]));
        }
        fmt::print("]}}\n");
        return;
    }
    printTable(perLevel, total);
    const auto share = [&](std::uint64_t count) {
        return 100 * static_cast<double>(count) /
               static_cast<double>(std::max(total.bounces, std::uint64_t{1}));
    };
    fmt::print("In {:.1f} % of the games a mount failed after a time without damage.\n",
               100.0 * total.waited / std::max(total.games, 1u));
    fmt::print(
        "Of {} bounces, {:.2f} % were rotated from flat and {:.2f} % thrown off rubble; in pure "
        "games {}.\n",
        total.bounces, share(total.bentBounces), share(total.thrownBounces), total.bentInPure);
}

} // namespace

int runSoak(const SoakCommand& command) {
    std::vector<std::shared_ptr<const Level>> levels;
    std::vector<std::string> names = command.levels;
    if (names.empty()) {
        names = command.endless > 0 ? levelNames() : namesOfLevels();
    }
    for (const std::string& name : names) {
        levels.push_back(std::make_shared<const Level>(valueOrRefuse(loadLevel(name))));
    }
    std::vector<SoakStatistics> perLevel;
    for (const auto& level : levels) {
        perLevel.push_back({.level = level->name});
    }
    if (command.endless > 0) {
        perLevel.push_back({.level = "endless"});
    }
    SoakStatistics total{.level = "all"};
    Progress progress;
    for (std::uint32_t seed = command.firstSeed; total.observed.ticks < command.ticks; ++seed) {
        for (std::size_t i = 0; i < levels.size() + command.endless; ++i) {
            if (total.observed.ticks >= command.ticks) {
                break;
            }
            const auto number = static_cast<std::uint32_t>(i - levels.size() + 1);
            const auto level = i < levels.size()
                                   ? levels[i]
                                   : std::make_shared<const Level>(endlessLevel({seed, number}));
            const std::uint64_t left =
                std::min<std::uint64_t>(command.longestGame, command.ticks - total.observed.ticks);
            const std::uint32_t turn = seed - command.firstSeed;
            const Match match{level, seed,
                              command.player.value_or(static_cast<BotKind>(turn % kBotsInTurn)),
                              command.mode.value_or(static_cast<Mode>(turn % kModeNames.size()))};
            SoakStatistics game = soak(match, left, [&](std::uint32_t ticks) {
                progress.show(fmt::format("{}, seed {}: {} of {} ticks, {} games", level->name,
                                          seed, total.observed.ticks + ticks, command.ticks,
                                          total.games));
            });
            game.unfinished =
                game.observed.ticks >= command.longestGame && game.won + game.lost == 0;
            perLevel[std::min(i, levels.size())].add(game);
            total.add(game);
        }
    }
    progress.clear();
    printAll(perLevel, total, command.json);
    return total.clean() ? 0 : 1;
}

} // namespace apart
