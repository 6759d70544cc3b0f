// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level_file.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace apart {

/// The folder that holds levels/, fonts/ and so on: what APART_ASSETS names, else the first of
///   assets beside the program or in a folder above it, ../share/apart beside the program,
///   the source folder that it was built from, assets in the working folder.
std::filesystem::path assetsFolder();

/// Names of all levels, in the order in which they are played.
std::vector<std::string> levelNames();

/// assets/levels/NAME.toml. A name is made of letters, digits, - and _. A name that parseEndless()
/// takes is made, not read.
Read<Level> loadLevel(const std::string& name);

/// The level of a replay: one beside it, in levels/NAME.toml, goes before those of the game.
Read<Level> loadLevelOf(const std::filesystem::path& replay, const std::string& name);

/// What is wrong with the name of a level before any file is looked for; empty: nothing.
std::string wrongName(const std::string& name);

/// "there is no level NAME; the levels are ..."
std::string noSuchLevel(const std::string& name);

} // namespace apart
