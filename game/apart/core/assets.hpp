// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level_file.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace apart {

/// The folder of levels/ and fonts/: APART_ASSETS if set. Otherwise it is the first share/apart or
/// assets in the program's folder and those above it, else assets in the working folder. An
/// unpacked or installed tree may therefore lie anywhere.
std::filesystem::path assetsFolder();

/// The sentence for a player whose assets hold no levels.
std::string noLevelsText();

/// Names of all levels, in playing order.
std::vector<std::string> levelNames();

/// Reads assets/levels/NAME.toml, see levelNameProblem(); or the file at a path that ends in .toml.
/// A name that parseEndless() accepts is generated instead.
Read<Level> loadLevel(const std::string& name);

/// The level of a replay. levels/NAME.toml beside the replay has priority over the game's levels,
/// and these over NAME.toml in `own`, the player's folder of levels, if it is given.
Read<Level> loadLevelOf(const std::filesystem::path& replay, const std::string& name,
                        const std::filesystem::path& own = {});

/// Reason why no file can have this level name, without its subject; empty: one can. A replay could
/// not be read with it.
std::string levelNameProblem(const std::string& name);

/// Reason to refuse a level name before its file is searched; empty: none.
std::string wrongName(const std::string& name);

/// "there is no level NAME; the levels are ..."
std::string noSuchLevel(const std::string& name);

} // namespace apart
