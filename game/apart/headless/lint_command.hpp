// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/lint.hpp>

#include <string>
#include <vector>

namespace apart {

struct LintCommand {
    std::vector<std::string> levels; // names; empty: all of assets/levels
    LintOptions options;
    bool json = false;
    bool difficulty = false; // measure the difficulty instead
};

/// Checks the levels and prints a table or one JSON object, and a sentence for each problem.
/// Returns 1 if a level fails, else 0.
int runLint(const LintCommand& command);

/// Plays all skills on the levels and prints what they win, and how difficulty rises with the order
/// of the levels. Returns 1 if it does not rise as required, else 0.
int runDifficulty(const LintCommand& command);

struct MedalsCommand {
    std::vector<std::string> levels; // names; empty: all of assets/levels
    std::string file;                // where other levels keep their marks; empty: print the table
    std::uint32_t seeds = 10;        // games of the lazy and of the good bot
    std::uint32_t mostTicks = 3 * 14400; // of each game; six minutes
};

/// Measures the scores for medals and prints or writes them as the file assets/medals.toml. Prints
/// hits and medals of each bot, as comments of that file. Returns 0.
int runMedals(const MedalsCommand& command);

} // namespace apart
