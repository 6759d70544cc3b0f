// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>
#include <apart/stage/records/profile.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace apart {

/// Tables of the best scores in a profile file, by Mode.
inline constexpr std::array<const char*, kModeNames.size()> kBestTables = {"best", "best-pure",
                                                                           "best-assisted"};

/// What can be read of a profile. A wrong item is replaced by its default, and named.
struct SalvagedProfile {
    Profile profile{};
    std::optional<FileProblem> problem{}; // all faults by line; nullopt: none
    bool newer = false;                   // in a format of a newer game
};

SalvagedProfile salvageProfile(std::string_view text, const std::string& file);

} // namespace apart
