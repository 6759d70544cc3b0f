// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/endless.hpp>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

namespace apart {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestName = 64;

bool holdsLevels(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder / "levels", error);
}

/// The folder of the program; the working folder on systems other than Linux.
fs::path programFolder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::current_path(error) : program.parent_path();
}

bool isName(const std::string& name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '-' || c == '_';
    };
    return !name.empty() && name.size() <= kLongestName &&
           std::all_of(name.begin(), name.end(), allowed);
}

} // namespace

std::string noLevelsText() {
    std::error_code error;
    const fs::path folder = assetsFolder() / "levels";
    const fs::path whole = fs::absolute(folder, error);
    return "There are no levels in " + (error ? folder : whole).string() +
           ". APART_ASSETS names another folder of assets.";
}

fs::path assetsFolder() {
    if (const char* named = std::getenv("APART_ASSETS"); named != nullptr && *named != '\0') {
        return named;
    }
    for (fs::path folder = programFolder(); !folder.empty(); folder = folder.parent_path()) {
        for (const char* name : {"share/apart", "assets"}) {
            if (holdsLevels(folder / name)) {
                return folder / name;
            }
        }
        if (folder == folder.parent_path()) {
            break;
        }
    }
    return "assets";
}

std::vector<std::string> levelNames() {
    std::vector<std::pair<std::int32_t, std::string>> found;
    std::error_code error;
    for (fs::directory_iterator entry(assetsFolder() / "levels", error), end; entry != end;
         entry.increment(error)) {
        const fs::path path = entry->path();
        if (path.extension() == ".toml" && isName(path.stem().string())) {
            const Read<Level> level = readLevelFile(path);
            const auto* good = std::get_if<Level>(&level);
            found.emplace_back(good != nullptr ? good->place : 9999, path.stem().string());
        }
    }
    std::sort(found.begin(), found.end()); // total order: names differ
    std::vector<std::string> names;
    for (auto& [place, name] : found) {
        names.push_back(std::move(name));
    }
    return names;
}

std::string noSuchLevel(const std::string& name) {
    std::string sentence = "there is no level " + name + "; the levels are";
    for (const std::string& other : levelNames()) {
        sentence += (sentence.ends_with("are") ? " " : ", ") + other;
    }
    return sentence + ", and endless[:SEED[:NUMBER]]";
}

Read<Level> loadLevel(const std::string& name) {
    if (const std::optional<EndlessName> endless = parseEndless(name)) {
        return endlessLevel(*endless);
    }
    if (name.starts_with("endless:")) {
        return FileProblem{name, 0,
                           "is not an endless level: endless:SEED:NUMBER has a SEED from 0 to " +
                               std::to_string(std::numeric_limits<std::uint32_t>::max()) +
                               " and a NUMBER from 1 to " + std::to_string(kMostEndless)};
    }
    if (name.ends_with(".toml")) {
        return readLevelFile(name);
    }
    if (std::string problem = levelNameProblem(name); !problem.empty()) {
        return FileProblem{name, 0, std::move(problem)};
    }
    const fs::path path = assetsFolder() / "levels" / (name + ".toml");
    std::error_code error;
    if (!fs::exists(path, error)) {
        return FileProblem{path.string(), 0, noSuchLevel(name)};
    }
    return readLevelFile(path);
}

Read<Level> loadLevelOf(const fs::path& replay, const std::string& name, const fs::path& own) {
    const fs::path file = fs::path("levels") / (name + ".toml");
    std::error_code error;
    for (const fs::path& folder : {replay.parent_path(), replay.parent_path() / ".."}) {
        if (isName(name) && fs::exists(folder / file, error)) {
            return readLevelFile(folder / file);
        }
    }
    const fs::path mine = own / file.filename();
    const bool taken = fs::exists(assetsFolder() / file, error);
    if (!own.empty() && isName(name) && !taken && fs::exists(mine, error)) {
        return readLevelFile(mine);
    }
    return loadLevel(name);
}

std::string levelNameProblem(const std::string& name) {
    if (parseEndless(name)) {
        return "is the name of an endless level";
    }
    return isName(name) ? ""
                        : "is not a level name: it has the letters a-z and A-Z, digits, - and _ "
                          "only, 1 to " +
                              std::to_string(kLongestName);
}

std::string wrongName(const std::string& name) {
    return name.empty() ? "the name of a level is missing" : "";
}

} // namespace apart
