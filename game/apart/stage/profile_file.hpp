// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>
#include <apart/stage/profile.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace apart {

/// apart/profile.toml in the user's folder for settings: XDG_CONFIG_HOME, else .config in HOME
/// (APPDATA on Windows). Nothing when none of them is set.
std::optional<std::filesystem::path> profileFile();

std::string toText(const Profile& profile);
Read<Profile> profileFrom(std::string_view text, const std::string& file);

struct LoadedProfile {
    Profile profile;
    std::string notice; // a sentence for the player, or nothing
};

/// A file that cannot be understood is renamed to *.broken, so that nothing in it is lost, and the
/// profile begins anew.
LoadedProfile loadProfile(const std::filesystem::path& file);

/// Makes its folder if need be. The old file stays whole whatever happens.
std::optional<FileProblem> saveProfile(const std::filesystem::path& file, const Profile& profile);

} // namespace apart
