// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/tuning.hpp>
#include <kodo/version.hpp>

#include <string>

namespace apart {

/// What a report of a bug names: "0.2.0, rules 32".
inline std::string versionText() {
    return std::to_string(KODO_VERSION_MAJOR) + '.' + std::to_string(KODO_VERSION_MINOR) + '.' +
           std::to_string(KODO_VERSION_PATCH) + ", rules " + std::to_string(kRulesVersion);
}

} // namespace apart
