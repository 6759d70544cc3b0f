// SPDX-License-Identifier: MIT
#include <apart/stage/records/profile_file.hpp>
#include <apart/stage/records/profile_reader.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace apart {

namespace {

constexpr std::size_t kLongestFile = std::size_t{1} << 20; // bytes

/// The first faults, in one sentence.
std::string textOf(const FileProblem& problem) {
    constexpr std::size_t kTold = 3;
    std::string text = problem.text();
    const std::size_t told = std::min(problem.more.size(), kTold - 1);
    for (std::size_t i = 0; i < told; ++i) {
        text +=
            printable(fmt::format("; line {}: {}", problem.more[i].first, problem.more[i].second));
    }
    const std::size_t left = problem.more.size() - told;
    return left > 0 ? text + fmt::format("; and {} more", left) : text;
}

/// Folder named by an environment variable, if it is an absolute path.
std::optional<std::filesystem::path> folderOf(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr || !std::filesystem::path(value).is_absolute()) {
        return std::nullopt;
    }
    return std::filesystem::path(value);
}

constexpr const char* kNotKept = "Settings and scores are neither read nor kept: ";

/// Adds to `saved` what was counted since `before`.
TotalsByTheme withCounts(TotalsByTheme saved, const TotalsByTheme& now,
                         const TotalsByTheme& before) {
    for (std::size_t i = 0; i < saved.size(); ++i) {
        PlayTotals counted = now[i];
        for (const TotalField& field : kTotalFields) {
            if (field.sum) {
                counted.*field.value -= before[i].*field.value;
            }
        }
        add(saved[i], counted);
    }
    return saved;
}

/// Replaces each setting that is as it was `before` by that of `saved`.
void takeSettings(Profile& profile, const Profile& saved, const Profile& before) {
    for (const Dial& dial : kDials) {
        int& value = profile.settings.*dial.value;
        value = value == before.settings.*dial.value ? saved.settings.*dial.value : value;
    }
    profile.mode = profile.mode == before.mode ? saved.mode : profile.mode;
    profile.muted = profile.muted == before.muted ? saved.muted : profile.muted;
    if (profile.bindings == before.bindings) { // a key of one act may be that of another
        profile.bindings = saved.bindings;
    }
}

/// The profile with the better of its scores and those of `saved`, which another game that ran
/// meanwhile may have saved. The totals are those of `saved` and what was counted since `before`,
/// the settings those of `saved` but for what has changed since `before`. Settings and totals of a
/// damaged file do not count.
Profile mergedWith(const LoadedProfile& saved, Profile profile,
                   const std::optional<Profile>& before) {
    if (saved.whole) {
        profile.totals = withCounts(saved.profile.totals, profile.totals,
                                    before ? before->totals : TotalsByTheme{});
    }
    if (saved.whole && before) {
        takeSettings(profile, saved.profile, *before);
    }
    profile.reached = profile.reached.empty() ? saved.profile.reached : profile.reached;
    for (std::size_t mode = 0; mode < saved.profile.best.size(); ++mode) {
        for (const auto& [level, best] : saved.profile.best[mode]) {
            profile.adopt(static_cast<Mode>(mode), level, best);
        }
    }
    return profile;
}

/// A text within the quotation marks of TOML.
std::string escaped(const std::string& text) {
    std::string inside;
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            inside += '\\';
            inside += c;
        } else if ((c >= 0 && c < ' ') || c == '\x7f') {
            inside += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            inside += c;
        }
    }
    return inside;
}

/// A level name as a TOML key.
std::string keyOf(const std::string& level) {
    const auto isBare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '-';
    };
    if (!level.empty() && std::all_of(level.begin(), level.end(), isBare)) {
        return level;
    }
    return '"' + escaped(level) + '"';
}

} // namespace

std::optional<std::filesystem::path> profileFile() {
    const std::filesystem::path inside = std::filesystem::path("apart") / "profile.toml";
    for (const char* variable : {"XDG_CONFIG_HOME", "APPDATA"}) {
        if (const auto folder = folderOf(variable)) {
            return *folder / inside;
        }
    }
    const auto home = folderOf("HOME");
    return home ? std::optional(*home / ".config" / inside) : std::nullopt;
}

std::filesystem::path freeAside(const std::filesystem::path& file, const std::string& ending) {
    for (int i = 1;; ++i) {
        std::filesystem::path aside = file;
        aside += i == 1 ? ending : ending + "-" + std::to_string(i);
        std::error_code error;
        if (!std::filesystem::exists(aside, error)) {
            return aside;
        }
    }
}

std::string toText(const Profile& profile) {
    std::string text = "# Settings and best scores of aPart. The game replaces the whole file.\n"
                       "format = ";
    text += profile.mapped ? "2" : "1"; // 1: of games without a map
    text += profile.reached.empty() ? "\n"
                                    : fmt::format("\nreached = \"{}\"\n", escaped(profile.reached));
    text += "\n[settings]\n";
    for (const Dial& dial : kDials) {
        text += fmt::format("{} = {}\n", dial.key, profile.settings.*dial.value);
    }
    text += fmt::format("pure = {}\nassisted = {}\nmuted = {}\n", profile.mode == Mode::Pure,
                        profile.mode == Mode::Assisted, profile.muted);
    text += "\n[keys] # two keys and a button of the gamepad\n";
    for (std::size_t i = 0; i < kActs; ++i) {
        const auto act = static_cast<Act>(i);
        text += fmt::format("{} = [\"{}\", \"{}\", {}]\n", kActNames[i],
                            profile.bindings.text(act, 0), profile.bindings.text(act, 1),
                            profile.bindings.at(act, Bindings::kPadColumn) + 1);
    }
    for (std::size_t i = 0; i < kBestTables.size(); ++i) {
        for (const auto& [level, best] : profile.best[i]) {
            text += fmt::format("\n[{}.{}]\nscore = {}\ncleared = {}\nunhurt = {}\nchain = {}\n",
                                kBestTables[i], keyOf(level), best.score, best.cleared, best.unhurt,
                                best.chain);
            if (best.unproved > 0) {
                text += fmt::format("unproved = {}\n", best.unproved);
            }
            text += best.fewHits ? "few-hits = true\n" : "";
            text += best.oneFall ? "one-fall = true\n" : "";
            text += best.kept ? "kept = true\n" : "";
            text += best.ways > 0 ? fmt::format("ways = {}\n", best.ways) : "";
        }
    }
    for (std::size_t i = 0; i < profile.totals.size(); ++i) {
        if (profile.totals[i] == PlayTotals{}) {
            continue;
        }
        text += fmt::format("\n[statistics.{}]\n", kThemeNames[i]);
        for (const TotalField& field : kTotalFields) {
            text += fmt::format("{} = {}\n", field.key, profile.totals[i].*field.value);
        }
    }
    return text;
}

Read<Profile> profileFrom(std::string_view text, const std::string& file) {
    SalvagedProfile salvage = salvageProfile(text, file);
    return salvage.problem ? Read<Profile>(*salvage.problem)
                           : Read<Profile>(std::move(salvage.profile));
}

LoadedProfile loadProfile(const std::filesystem::path& file) {
    std::error_code error;
    const bool exists = std::filesystem::exists(file, error);
    if (!exists && !error) {
        return {};
    }
    const Read<std::string> text = readTextFile(file, kLongestFile);
    if (const auto* unread = std::get_if<FileProblem>(&text)) {
        return {{}, kNotKept + unread->text() + ".", true};
    }
    SalvagedProfile salvage = salvageProfile(std::get<std::string>(text), file.string());
    if (salvage.newer) {
        return {{}, kNotKept + file.string() + ": was written by a newer game.", true};
    }
    if (!salvage.problem) {
        return {std::move(salvage.profile), {}, false, true};
    }
    const std::filesystem::path aside = freeAside(file, ".broken");
    if (std::filesystem::is_symlink(file, error)) { // the link stays
        std::filesystem::copy_file(file, aside, error);
    } else {
        std::filesystem::rename(file, aside, error);
    }
    const std::string kept = error ? "The file cannot be renamed."
                                   : "The file is kept as " + aside.filename().string() + ".";
    if (!error) {
        writeTextFile(file, toText(salvage.profile)); // on failure, the next save says so
    }
    return {std::move(salvage.profile),
            fmt::format("The profile is damaged, and only what is right in it is used: {}. {}",
                        textOf(*salvage.problem), kept)};
}

std::optional<Profile> savedProfile(const std::filesystem::path& file) {
    const Read<std::string> text = readTextFile(file, kLongestFile);
    if (std::holds_alternative<FileProblem>(text)) {
        return std::nullopt;
    }
    SalvagedProfile saved = salvageProfile(std::get<std::string>(text), file.string());
    return saved.newer ? std::nullopt : std::optional(std::move(saved.profile));
}

std::optional<FileProblem> saveProfile(const std::filesystem::path& file, const Profile& profile,
                                       const std::optional<Profile>& before) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) {
        return FileProblem{file.string(), 0, "its folder cannot be made: " + error.message()};
    }
    const FolderLock lock(file.parent_path()); // another game may save at once
    if (!lock.held()) {
        return FileProblem{file.string(), 0, "another game is writing it, and does not end"};
    }
    const LoadedProfile saved = loadProfile(file);
    if (saved.keepFile) {
        return FileProblem{file.string(), 0,
                           "it was written by a newer game, or cannot be read, and stays as it is"};
    }
    return writeTextFile(file, toText(mergedWith(saved, profile, before)));
}

std::function<std::string(const Profile&)> profileSaver(const std::filesystem::path& file,
                                                        const Profile& loaded) {
    return [file, before = std::optional(loaded)](const Profile& profile) mutable -> std::string {
        if (const std::optional<FileProblem> problem = saveProfile(file, profile, before)) {
            return "Settings and scores are not kept: " + problem->text() + ".";
        }
        before = profile;
        return "";
    };
}

} // namespace apart
