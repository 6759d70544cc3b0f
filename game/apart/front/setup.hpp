// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/stage.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace apart {

/// What to start with.
struct StartOptions {
    std::string level;                 // empty: choose on the title screen; daily, endless
    std::optional<std::uint32_t> seed; // nullopt: random
    std::string replay;                // file; empty: the player plays
    std::string ghost;                 // file or link of a rival's replay; empty: none
    std::string edit;                  // file of a level to edit; empty: none
    bool allLevels = false;            // of the map are open
    bool duel = false;                 // two players, in the first level unless one is named
    bool picture = false;              // the bot plays, and no profile is read
};

/// The player's folder of levels; empty if there is none.
std::filesystem::path ownLevels();

/// The stage for these options, or the reason why there is none, as a sentence.
std::variant<StageDef, std::string> setUp(const StartOptions& options);

} // namespace apart
