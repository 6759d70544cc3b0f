// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/text_file.hpp>
#include <apart/stage/records/profile.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace apart {

/// Path of apart/profile.toml in the user's configuration folder: XDG_CONFIG_HOME, else APPDATA,
/// else .config in HOME. Empty if none of these variables is set.
std::optional<std::filesystem::path> profileFile();

/// The first of FILE + `ending`, FILE + `ending` + "-2", ... that does not exist: the name for a
/// file that is kept aside.
std::filesystem::path freeAside(const std::filesystem::path& file, const std::string& ending);

std::string toText(const Profile& profile);
/// The profile, or all faults of the text.
Read<Profile> profileFrom(std::string_view text, const std::string& file);

struct LoadedProfile {
    Profile profile;
    std::string notice;    // a sentence for the player, or empty
    bool keepFile = false; // it must not be replaced: it cannot be read, or is of a newer game
    bool whole = false;    // there is a file, and all of it was read
};

/// Of a damaged file, each wrong item is replaced by its default; the notice names the first ones.
/// The file is renamed to *.broken (*.broken-2, ...), and one with what is right takes its place. A
/// file that cannot be read, and one of a newer game, stay as they are: the profile is the default.
LoadedProfile loadProfile(const std::filesystem::path& file);

/// What is right in the profile of a file that another running game may have saved; nullopt if it
/// cannot be read, or is of a newer game.
std::optional<Profile> savedProfile(const std::filesystem::path& file);

/// Keeps the better scores of the file, if another game has saved some meanwhile, and adds what was
/// counted since the profile `before` to its totals. Of the settings it replaces those that differ
/// from `before`; all, without one. Creates the folder if needed. On failure the old file stays
/// intact; so does one that loadProfile() would not replace.
std::optional<FileProblem> saveProfile(const std::filesystem::path& file, const Profile& profile,
                                       const std::optional<Profile>& before = std::nullopt);

/// Saves the profile of one run of the game, which was `loaded` at its start. Returns a sentence on
/// failure.
std::function<std::string(const Profile&)> profileSaver(const std::filesystem::path& file,
                                                        const Profile& loaded);

} // namespace apart
