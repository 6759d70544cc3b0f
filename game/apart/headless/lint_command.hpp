// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/lint.hpp>

#include <string>
#include <vector>

namespace apart {

struct LintCommand {
    std::vector<std::string> levels; // names; all of assets/levels unless given
    LintOptions options;
    bool json = false;
};

/// Checks the levels and prints a table, or one JSON object, and a sentence about each thing that
/// is wrong. 1 when a level fails, else 0.
int runLint(const LintCommand& command);

} // namespace apart
