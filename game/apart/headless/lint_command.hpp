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

} // namespace apart
