// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/medals.hpp>
#include <apart/headless/lint_command.hpp>
#include <apart/headless/refusal.hpp>
#include <apart/headless/report.hpp>

#include <fmt/format.h>

#include <algorithm>

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

} // namespace

int runMedals(const MedalsCommand& command) {
    std::vector<MedalMarks> old;
    if (!command.file.empty() && !command.levels.empty()) {
        old = valueOrRefuse(readMedals(command.file));
    }
    const std::vector<std::string> names =
        command.levels.empty() ? namesOfLevels() : command.levels;
    std::vector<MedalMarks> marks;
    Progress progress;
    for (const std::string& name : names) {
        progress.show(fmt::format("{}  {} of {} levels", name, marks.size(), names.size()));
        marks.push_back(
            measureMedals(valueOrRefuse(loadLevel(name)), command.seeds, command.mostTicks));
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
