// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/stage/stage.hpp>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace apart {

/// Adds the valid levels of the player's folder, by name. Each of the others is a notice.
void addOwnLevels(StageDef& def, const std::filesystem::path& folder);

/// Starts with the level of a file, wherever it is, and follows its changes. It takes the place of
/// a listed level only if it is the same file, in one of `folders`. Otherwise a name that is taken
/// or invalid becomes FILE.toml, which is not recorded, and a notice says so. Returns the reason
/// if the level cannot be used, else "".
std::string takeLevelFile(StageDef& def, const std::filesystem::path& file,
                          const std::vector<std::filesystem::path>& folders);

/// The editor of a level of the list, or of a new one. A file of the player's folder is edited
/// itself; of another level a copy goes there. Its name is free.
EditorStart editorOf(const Level* level, const LevelList& levels,
                     const std::filesystem::path& folder);
/// The editor of a file, which need not exist; or the reason why it cannot be edited.
std::variant<EditorStart, std::string> editorOfFile(const std::filesystem::path& file);

} // namespace apart
