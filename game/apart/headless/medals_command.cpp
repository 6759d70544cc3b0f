// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/medals.hpp>
#include <apart/headless/lint_command.hpp>
#include <apart/headless/refusal.hpp>
#include <apart/headless/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <unistd.h>

namespace apart {

namespace {

/// The levels of the game, in their order, with the new marks where there are some.
std::vector<MedalMarks> merged(const std::vector<MedalMarks>& old,
                               const std::vector<MedalMarks>& measured) {
    std::vector<MedalMarks> all;
    for (const std::string& name : namesOfLevels()) {
        for (const auto* marks : {&measured, &old}) {
            const auto found = std::find_if(marks->begin(), marks->end(),
                                            [&](const MedalMarks& m) { return m.level == name; });
            if (found != marks->end()) {
                all.push_back(*found);
                break;
            }
        }
    }
    return all;
}

void printBotHead() {
    fmt::print("# {:<18}", "medals by bot");
    for (const char* name : {"planner", "good", "lazy", "absent"}) {
        fmt::print(" {:>9}: hits  gold silver bronze  none", name);
    }
    fmt::print("\n");
}

/// Mean hits of the won games, and the number of games by medal.
void printBot(const PlayedGames& games, const MedalMarks& marks) {
    std::array<int, kMedalNames.size()> counts{};
    for (const std::int32_t score : games.scores) {
        ++counts[static_cast<std::size_t>(medalOf(score, marks.level, {&marks, 1}))];
    }
    const double sum = std::accumulate(games.hits.begin(), games.hits.end(), 0.0);
    const double won = std::max(static_cast<double>(games.hits.size()), 1.0);
    fmt::print(" {:>15.1f} {:>5} {:>6} {:>6} {:>5}", sum / won, counts[3], counts[2], counts[1],
               counts[0]);
}

/// In how many won games each way was seen, by planner, good and lazy bot.
void printWays(const MedalGames& games, const Level& level) {
    for (std::size_t way = 0; way < level.ways.size(); ++way) {
        fmt::print("#   {:<24} {} of {} games of the planner, {} of {} of the good bot, {} of {} "
                   "of the lazy one\n",
                   level.ways[way].name, games.planner.ways[way], games.planner.hits.size(),
                   games.good.ways[way], games.good.hits.size(), games.lazy.ways[way],
                   games.lazy.hits.size());
    }
    std::fflush(stdout);
}

void printBotRow(const MedalGames& games, const MedalMarks& marks) {
    fmt::print("# {:<18}", marks.level);
    for (const PlayedGames* played : {&games.planner, &games.good, &games.lazy, &games.absent}) {
        printBot(*played, marks);
    }
    fmt::print("\n");
    std::fflush(stdout);
}

} // namespace

int runMedals(const MedalsCommand& command) {
    std::vector<MedalMarks> old;
    if (!command.file.empty() && !command.levels.empty()) {
        old = valueOrRefuse(readMedals(command.file));
    }
    const std::vector<std::string> names =
        command.levels.empty() ? namesOfLevels() : command.levels;
    std::vector<MedalMarks> marks;
    Progress progress(STDOUT_FILENO);
    printBotHead();
    for (const std::string& name : names) {
        progress.show(fmt::format("{}  {} of {} levels", name, marks.size(), names.size()));
        const Level level = valueOrRefuse(loadLevel(name));
        const MedalGames games = playForMedals(level, command.seeds, command.mostTicks);
        marks.push_back(marksOf(level, games));
        progress.clear();
        printBotRow(games, marks.back());
        printWays(games, level);
    }
    progress.clear();
    if (command.file.empty()) {
        fmt::print("{}", toText(marks));
    } else if (const auto problem = writeTextFile(command.file, toText(merged(old, marks)))) {
        throw Refusal{problem->text()};
    }
    return 0;
}

} // namespace apart
