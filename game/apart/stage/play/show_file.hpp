// SPDX-License-Identifier: MIT
#pragma once

#include <apart/stage/records/theatre.hpp>

#include <filesystem>
#include <string>
#include <variant>

namespace apart {

/// The show of a replay file, or the reason why it cannot be played, as a sentence. `ownLevels`:
/// the folder of the player's levels, behind those of the game, which the reason names; may be
/// empty.
std::variant<Show, std::string> showOf(const std::filesystem::path& file,
                                       const std::filesystem::path& ownLevels);

} // namespace apart
