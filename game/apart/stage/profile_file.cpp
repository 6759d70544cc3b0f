// SPDX-License-Identifier: MIT
#include <apart/core/toml_keys.hpp>
#include <apart/stage/profile_file.hpp>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace apart {

namespace {

constexpr std::size_t kLongestFile = std::size_t{1} << 20; // bytes
constexpr std::array<const char*, 2> kTables = {"best", "best-pure"};

/// Reads a profile and keeps the first problem.
class ProfileReader {
public:
    explicit ProfileReader(const std::string& file) : file_(file) {}

    Read<Profile> read(const toml::table& root) {
        if (number(root, "format", 1, 1) != 1) {
            return FileProblem{file_, 1, "format must be 1"};
        }
        for (const auto& [key, node] : root) {
            if (key == "settings") {
                readSettings(node);
            } else if (key == "keys") {
                readKeys(node);
            } else if (key == "statistics") {
                readTotals(node);
            } else if (key == kTables[0] || key == kTables[1]) {
                readBests(node, profile_.best[key == kTables[1] ? 1 : 0]);
            } else if (key != "format") {
                fail(node, "unknown key " + std::string(key.str()));
            }
        }
        return problem_ ? Read<Profile>(*problem_) : Read<Profile>(profile_);
    }

private:
    void fail(const toml::node& node, std::string reason) {
        if (!problem_) {
            problem_ =
                FileProblem{file_, static_cast<int>(node.source().begin.line), std::move(reason)};
        }
    }

    std::int32_t number(const toml::table& table, std::string_view key, std::int32_t least,
                        std::int32_t most) {
        const auto* value = table.get_as<std::int64_t>(key);
        if (value == nullptr || value->get() < least || value->get() > most) {
            const toml::node* node = table.get(key);
            fail(node == nullptr ? table : *node,
                 fmt::format("{} must be a whole number from {} to {}", key, least, most));
            return least;
        }
        return static_cast<std::int32_t>(value->get());
    }

    bool truth(const toml::table& table, std::string_view key) {
        const auto* value = table.get_as<bool>(key);
        if (value == nullptr) {
            const toml::node* node = table.get(key);
            fail(node == nullptr ? table : *node, fmt::format("{} must be true or false", key));
        }
        return value != nullptr && value->get();
    }

    void readSettings(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            return fail(node, "settings must be a table");
        }
        for (const auto& [key, value] : *table) {
            const auto dial =
                std::find_if(kDials.begin(), kDials.end(),
                             [name = key.str()](const Dial& d) { return d.key == name; });
            if (key == "pure") {
                profile_.mode = truth(*table, "pure") ? Mode::Pure : Mode::Standard;
            } else if (key == "muted") {
                profile_.muted = truth(*table, "muted");
            } else if (dial != kDials.end()) {
                profile_.settings.*dial->value = number(*table, dial->key, dial->least, dial->most);
            } else {
                fail(value, "unknown key settings." + std::string(key.str()));
            }
        }
    }

    void readBests(const toml::node& node, std::map<std::string, Best>& bests) {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            return fail(node, "best scores must be a table");
        }
        for (const auto& [level, value] : *table) {
            const toml::table* best = value.as_table();
            if (best == nullptr) {
                fail(value, "a best score must be a table");
                continue;
            }
            constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
            bests[std::string(level.str())] = {
                number(*best, "score", 0, kMost),
                truth(*best, "cleared"),
                truth(*best, "unhurt"),
                truth(*best, "chain"),
                best->contains("unproved") ? number(*best, "unproved", 0, kMost) : 0,
                best->contains("few-hits") && truth(*best, "few-hits"),
                best->contains("one-fall") && truth(*best, "one-fall"),
                best->contains("kept") && truth(*best, "kept")};
        }
    }

    /// The keys and the button of each act: texts and a number, 0 and "-" for none.
    void readKeys(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            return fail(node, "keys must be a table");
        }
        Bindings read;
        for (Bindings::Row& row : read.rows) {
            row.fill(kNoKey);
        }
        for (const auto& [name, value] : *table) {
            const auto act = std::find(kActNames.begin(), kActNames.end(), name.str());
            const toml::array* row = value.as_array();
            if (act == kActNames.end() || row == nullptr || row->size() != Bindings::kColumns) {
                return fail(value, "keys has, for each act, two names of keys and a button");
            }
            for (std::size_t column = 0; column < Bindings::kColumns; ++column) {
                const std::optional<int> code = codeOf(*row->get(column), column);
                const std::string reason =
                    code ? read.bind(static_cast<Act>(act - kActNames.begin()), column, *code)
                         : "there is no such key or button";
                if (!reason.empty()) {
                    return fail(value, reason);
                }
            }
        }
        profile_.bindings = read;
    }

    static std::optional<int> codeOf(const toml::node& node, std::size_t column) {
        if (column == Bindings::kPadColumn) {
            const auto button = node.value_exact<std::int64_t>();
            return button && *button >= 0 && *button <= kMostButtons
                       ? std::optional(static_cast<int>(*button) - 1)
                       : std::nullopt;
        }
        const auto name = node.value_exact<std::string_view>();
        return name == "-" ? std::optional(kNoKey) : name ? keyNamed(*name) : std::nullopt;
    }

    void readTotals(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            return fail(node, "statistics must be a table");
        }
        for (const auto& [theme, value] : *table) {
            const auto known = std::find(kThemeNames.begin(), kThemeNames.end(), theme.str());
            const toml::table* totals = value.as_table();
            if (known == kThemeNames.end() || totals == nullptr) {
                fail(value, "statistics have a table for each theme");
                continue;
            }
            PlayTotals& sums =
                profile_.totals[static_cast<std::size_t>(known - kThemeNames.begin())];
            for (const TotalField& field : kTotalFields) {
                sums.*field.value = number(*totals, field.key, 0, kMostTotal);
            }
        }
    }

    const std::string& file_;
    Profile profile_;
    std::optional<FileProblem> problem_;
};

/// Folder named by an environment variable, if it is an absolute path.
std::optional<std::filesystem::path> folderOf(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr || !std::filesystem::path(value).is_absolute()) {
        return std::nullopt;
    }
    return std::filesystem::path(value);
}

constexpr const char* kNotKept = "Settings and scores are neither read nor kept: ";

/// True for a profile whose format this game does not know yet.
bool isNewer(std::string_view text, const std::string& file) {
    const Read<toml::table> root = parseToml(text, file);
    const auto* table = std::get_if<toml::table>(&root);
    return table != nullptr && (*table)["format"].value_or(std::int64_t{0}) > 1;
}

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

/// The profile with the better of its scores and those of `saved`, which another game that ran
/// meanwhile may have saved. The totals are those of `saved` and what was counted since `before`.
Profile mergedWith(const Profile& saved, Profile profile, const TotalsByTheme& before) {
    profile.totals = withCounts(saved.totals, profile.totals, before);
    for (std::size_t mode = 0; mode < saved.best.size(); ++mode) {
        for (const auto& [level, best] : saved.best[mode]) {
            profile.adopt(static_cast<Mode>(mode), level, best);
        }
    }
    return profile;
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
    std::string key = "\"";
    for (const char c : level) {
        if (c == '"' || c == '\\') {
            key += '\\';
            key += c;
        } else if ((c >= 0 && c < ' ') || c == '\x7f') {
            key += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            key += c;
        }
    }
    return key += '"';
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
                       "format = 1\n\n[settings]\n";
    for (const Dial& dial : kDials) {
        text += fmt::format("{} = {}\n", dial.key, profile.settings.*dial.value);
    }
    text += fmt::format("pure = {}\nmuted = {}\n", profile.mode == Mode::Pure, profile.muted);
    text += "\n[keys] # two keys and a button of the gamepad\n";
    for (std::size_t i = 0; i < kActs; ++i) {
        const auto act = static_cast<Act>(i);
        text += fmt::format("{} = [\"{}\", \"{}\", {}]\n", kActNames[i],
                            profile.bindings.text(act, 0), profile.bindings.text(act, 1),
                            profile.bindings.at(act, Bindings::kPadColumn) + 1);
    }
    for (std::size_t i = 0; i < kTables.size(); ++i) {
        for (const auto& [level, best] : profile.best[i]) {
            text += fmt::format("\n[{}.{}]\nscore = {}\ncleared = {}\nunhurt = {}\nchain = {}\n",
                                kTables[i], keyOf(level), best.score, best.cleared, best.unhurt,
                                best.chain);
            if (best.unproved > 0) {
                text += fmt::format("unproved = {}\n", best.unproved);
            }
            text += best.fewHits ? "few-hits = true\n" : "";
            text += best.oneFall ? "one-fall = true\n" : "";
            text += best.kept ? "kept = true\n" : "";
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
    const Read<toml::table> root = parseToml(text, file);
    if (const auto* problem = std::get_if<FileProblem>(&root)) {
        return *problem;
    }
    return ProfileReader(file).read(std::get<toml::table>(root));
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
    Read<Profile> profile = profileFrom(std::get<std::string>(text), file.string());
    if (auto* good = std::get_if<Profile>(&profile)) {
        return {std::move(*good), {}};
    }
    const FileProblem problem = std::get<FileProblem>(profile);
    if (isNewer(std::get<std::string>(text), file.string())) {
        return {{}, kNotKept + file.string() + ": was written by a newer game.", true};
    }
    const std::filesystem::path aside = freeAside(file, ".broken");
    std::filesystem::rename(file, aside, error);
    const std::string kept =
        error ? "It cannot be renamed." : "It is kept as " + aside.filename().string() + ".";
    return {{}, fmt::format("Settings and scores are reset: {}. {}", problem.text(), kept)};
}

std::optional<Profile> savedProfile(const std::filesystem::path& file) {
    const Read<std::string> text = readTextFile(file, kLongestFile);
    if (std::holds_alternative<FileProblem>(text)) {
        return std::nullopt;
    }
    Read<Profile> saved = profileFrom(std::get<std::string>(text), file.string());
    auto* good = std::get_if<Profile>(&saved);
    return good != nullptr ? std::optional(std::move(*good)) : std::nullopt;
}

std::optional<FileProblem> saveProfile(const std::filesystem::path& file, const Profile& profile,
                                       const TotalsByTheme& before) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) {
        return FileProblem{file.string(), 0, "its folder cannot be made: " + error.message()};
    }
    const std::optional<Profile> saved = savedProfile(file);
    if (!saved && loadProfile(file).keepFile) { // which renames a damaged file
        return FileProblem{file.string(), 0,
                           "it was written by a newer game, or cannot be read, and stays as it is"};
    }
    return writeTextFile(file, toText(saved ? mergedWith(*saved, profile, before) : profile));
}

std::function<std::string(const Profile&)> profileSaver(const std::filesystem::path& file,
                                                        const TotalsByTheme& loaded) {
    return [file, before = loaded](const Profile& profile) mutable -> std::string {
        if (const std::optional<FileProblem> problem = saveProfile(file, profile, before)) {
            return "Settings and scores are not kept: " + problem->text() + ".";
        }
        before = profile.totals;
        return "";
    };
}

} // namespace apart
