// SPDX-License-Identifier: MIT
#include <apart/core/toml_keys.hpp>
#include <apart/stage/profile_file.hpp>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

namespace apart {

namespace {

constexpr std::size_t kLongestFile = std::size_t{1} << 20; // bytes
constexpr std::array<const char*, 2> kTables = {"best", "best-pure"};

constexpr int kMostLeftOut = 20; // lines that are well-formed but contradict others

/// What can be read of a profile. A wrong value is replaced by its default, and named.
struct Salvage {
    Profile profile{};
    std::optional<FileProblem> problem{}; // all faults by line; nullopt: none
    bool newer = false;                   // of a format that this game does not know
};

/// Collects the faults of a file.
class Faults {
public:
    void add(int line, std::string reason) { all_.emplace_back(line, std::move(reason)); }
    void add(const toml::node& node, std::string reason) {
        add(static_cast<int>(node.source().begin.line), std::move(reason));
    }
    std::optional<FileProblem> problem(const std::string& file) {
        if (all_.empty()) {
            return std::nullopt;
        }
        std::stable_sort(all_.begin(), all_.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        return FileProblem{file, all_[0].first, all_[0].second, {all_.begin() + 1, all_.end()}};
    }

private:
    std::vector<std::pair<int, std::string>> all_; // line and reason
};

/// Reads the table of a profile, item by item.
class ProfileReader {
public:
    explicit ProfileReader(Faults& faults) : faults_(faults) {}

    Profile read(const toml::table& root) {
        number(root, "format", {1, 1, 1});
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
                faults_.add(node, "unknown key " + std::string(key.str()));
            }
        }
        return profile_;
    }

private:
    struct Range {
        std::int32_t least;
        std::int32_t most;
        std::int32_t usual;
    };

    std::int32_t number(const toml::table& table, std::string_view key, const Range& range) {
        const auto* value = table.get_as<std::int64_t>(key);
        if (value == nullptr || value->get() < range.least || value->get() > range.most) {
            const toml::node* node = table.get(key);
            faults_.add(node == nullptr ? table : *node,
                        fmt::format("{} must be a whole number from {} to {}, and is {} now", key,
                                    range.least, range.most, range.usual));
            return range.usual;
        }
        return static_cast<std::int32_t>(value->get());
    }

    bool truth(const toml::table& table, std::string_view key) {
        const auto* value = table.get_as<bool>(key);
        if (value == nullptr) {
            const toml::node* node = table.get(key);
            faults_.add(node == nullptr ? table : *node,
                        fmt::format("{} must be true or false, and is false now", key));
        }
        return value != nullptr && value->get();
    }

    void readSettings(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            return faults_.add(node, "settings must be a table");
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
                profile_.settings.*dial->value =
                    number(*table, dial->key, {dial->least, dial->most, Settings{}.*dial->value});
            } else {
                faults_.add(value, "unknown key settings." + std::string(key.str()));
            }
        }
    }

    void readBests(const toml::node& node, std::map<std::string, Best>& bests) {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            return faults_.add(node, "best scores must be a table");
        }
        for (const auto& [level, value] : *table) {
            const toml::table* best = value.as_table();
            if (best == nullptr) {
                faults_.add(value, "a best score must be a table");
                continue;
            }
            constexpr Range kScores{0, std::numeric_limits<std::int32_t>::max(), 0};
            bests[std::string(level.str())] = {
                number(*best, "score", kScores),
                truth(*best, "cleared"),
                truth(*best, "unhurt"),
                truth(*best, "chain"),
                best->contains("unproved") ? number(*best, "unproved", kScores) : 0,
                best->contains("few-hits") && truth(*best, "few-hits"),
                best->contains("one-fall") && truth(*best, "one-fall"),
                best->contains("kept") && truth(*best, "kept")};
        }
    }

    /// The keys and the button of each act: texts and a number, 0 and "-" for none. An act that is
    /// wrong or missing has its usual keys, except those that are in use.
    void readKeys(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            return faults_.add(node, "keys must be a table");
        }
        Bindings read;
        for (Bindings::Row& row : read.rows) {
            row.fill(kNoKey);
        }
        std::array<bool, kActs> bound{};
        for (const auto& [name, value] : *table) {
            const auto found = std::find(kActNames.begin(), kActNames.end(), name.str());
            if (found == kActNames.end()) {
                faults_.add(value, "unknown key keys." + std::string(name.str()));
                continue;
            }
            const auto act = static_cast<Act>(found - kActNames.begin());
            const std::string reason = readRow(value, act, read);
            bound[static_cast<std::size_t>(act)] = reason.empty();
            if (!reason.empty()) {
                faults_.add(value, fmt::format("keys of {}: {}, and they are the usual ones now",
                                               *found, reason));
                read.rows[static_cast<std::size_t>(act)].fill(kNoKey);
            }
        }
        for (std::size_t act = 0; act < kActs; ++act) {
            for (std::size_t column = 0; !bound[act] && column < Bindings::kColumns; ++column) {
                read.bind(static_cast<Act>(act), column, Bindings{}.rows[act][column]);
            }
        }
        profile_.bindings = read;
    }

    /// Returns the reason if an act cannot have these keys, else "".
    static std::string readRow(const toml::node& node, Act act, Bindings& read) {
        const toml::array* row = node.as_array();
        if (row == nullptr || row->size() != Bindings::kColumns) {
            return "each act has two names of keys and a button";
        }
        std::string reason;
        for (std::size_t column = 0; column < Bindings::kColumns && reason.empty(); ++column) {
            const std::optional<int> code = codeOf(*row->get(column), column);
            reason = code ? read.bind(act, column, *code) : "there is no such key or button";
        }
        return reason;
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
            return faults_.add(node, "statistics must be a table");
        }
        for (const auto& [theme, value] : *table) {
            const auto known = std::find(kThemeNames.begin(), kThemeNames.end(), theme.str());
            const toml::table* totals = value.as_table();
            if (known == kThemeNames.end() || totals == nullptr) {
                faults_.add(value, "statistics have a table for each theme");
                continue;
            }
            PlayTotals& sums =
                profile_.totals[static_cast<std::size_t>(known - kThemeNames.begin())];
            for (const TotalField& field : kTotalFields) {
                sums.*field.value = number(*totals, field.key, {0, kMostTotal, 0});
            }
        }
    }

    Faults& faults_;
    Profile profile_;
};

/// Empties a line, from 1, and behind the head of a table those up to the next head.
void leaveOut(std::vector<std::string>& lines, std::size_t number) {
    const auto isHead = [](const std::string& line) {
        const std::size_t first = line.find_first_not_of(" \t");
        return first != std::string::npos && line[first] == '[';
    };
    const bool head = isHead(lines[number - 1]);
    do {
        lines[number - 1].clear();
        ++number;
    } while (head && number <= lines.size() && !isHead(lines[number - 1]));
}

/// The well-formed lines of a file, as a table: the game writes an item a line. The others, and
/// those that repeat an item, are faults.
toml::table wellFormed(std::string_view text, const std::string& file, Faults& faults) {
    Read<toml::table> root = parseToml(text, file);
    if (auto* whole = std::get_if<toml::table>(&root)) {
        return std::move(*whole);
    }
    std::vector<std::string> lines(1);
    for (const char c : text) {
        if (c == '\n') {
            lines.emplace_back();
        } else {
            lines.back() += c;
        }
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Read<toml::table> alone = parseToml(lines[i], file);
        if (const auto* problem = std::get_if<FileProblem>(&alone)) {
            faults.add(static_cast<int>(i) + 1, problem->reason);
            leaveOut(lines, i + 1);
        }
    }
    for (int i = 0; i < kMostLeftOut; ++i) {
        std::string rest;
        for (const std::string& line : lines) {
            rest += line + '\n';
        }
        root = parseToml(rest, file);
        if (auto* table = std::get_if<toml::table>(&root)) {
            return std::move(*table);
        }
        const auto& problem = std::get<FileProblem>(root);
        if (problem.line < 1 || static_cast<std::size_t>(problem.line) > lines.size()) {
            break;
        }
        faults.add(problem.line, problem.reason);
        leaveOut(lines, static_cast<std::size_t>(problem.line));
    }
    return {};
}

Salvage salvageOf(std::string_view text, const std::string& file) {
    Faults faults;
    const toml::table root = wellFormed(text, file, faults);
    Salvage salvage;
    salvage.newer = root["format"].value_or(std::int64_t{0}) > 1;
    salvage.profile = ProfileReader(faults).read(root);
    salvage.problem = faults.problem(file);
    return salvage;
}

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

/// The profile with the better of its scores and those of `saved`, which another game that ran
/// meanwhile may have saved. The totals are those of `saved` and what was counted since `before`;
/// those of a damaged file do not count.
Profile mergedWith(const LoadedProfile& saved, Profile profile, const TotalsByTheme& before) {
    if (saved.whole) {
        profile.totals = withCounts(saved.profile.totals, profile.totals, before);
    }
    for (std::size_t mode = 0; mode < saved.profile.best.size(); ++mode) {
        for (const auto& [level, best] : saved.profile.best[mode]) {
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
    Salvage salvage = salvageOf(text, file);
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
    Salvage salvage = salvageOf(std::get<std::string>(text), file.string());
    if (salvage.newer) {
        return {{}, kNotKept + file.string() + ": was written by a newer game.", true};
    }
    if (!salvage.problem) {
        return {std::move(salvage.profile), {}, false, true};
    }
    const std::filesystem::path aside = freeAside(file, ".broken");
    std::filesystem::rename(file, aside, error);
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
    Salvage saved = salvageOf(std::get<std::string>(text), file.string());
    return saved.newer ? std::nullopt : std::optional(std::move(saved.profile));
}

std::optional<FileProblem> saveProfile(const std::filesystem::path& file, const Profile& profile,
                                       const TotalsByTheme& before) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) {
        return FileProblem{file.string(), 0, "its folder cannot be made: " + error.message()};
    }
    const LoadedProfile saved = loadProfile(file);
    if (saved.keepFile) {
        return FileProblem{file.string(), 0,
                           "it was written by a newer game, or cannot be read, and stays as it is"};
    }
    return writeTextFile(file, toText(mergedWith(saved, profile, before)));
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
