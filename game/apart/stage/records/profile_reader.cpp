// SPDX-License-Identifier: MIT
#include <apart/core/toml_keys.hpp>
#include <apart/core/way_watch.hpp>
#include <apart/stage/records/profile_reader.hpp>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace apart {

namespace {

constexpr int kMostLeftOut = 20; // lines that are well-formed but contradict others

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
        profile_.mapped = number(root, "format", {1, 2, 1}) == 2;
        for (const auto& [key, node] : root) {
            if (key == "settings") {
                readSettings(node);
            } else if (key == "keys") {
                readKeys(node);
            } else if (key == "statistics") {
                readTotals(node);
            } else if (const auto table =
                           std::find(kBestTables.begin(), kBestTables.end(), key.str());
                       table != kBestTables.end()) {
                readBests(node,
                          profile_.best[static_cast<std::size_t>(table - kBestTables.begin())]);
            } else if (key == "reached" && node.is_string()) {
                profile_.reached = node.as_string()->get();
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
            if (key == "pure" || key == "assisted") { // false is the default of both
                const Mode mode = key == "pure" ? Mode::Pure : Mode::Assisted;
                profile_.mode = truth(*table, key.str()) ? mode : profile_.mode;
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
                best->contains("kept") && truth(*best, "kept"),
                best->contains("ways")
                    ? static_cast<std::uint32_t>(number(*best, "ways", {0, kAllWays, 0}))
                    : 0};
            const auto score = (*best)["score"].value_exact<std::int64_t>();
            if (!score || *score < kScores.least || *score > kScores.most) {
                bests[std::string(level.str())].score = kUnreadScore;
            }
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

} // namespace

SalvagedProfile salvageProfile(std::string_view text, const std::string& file) {
    Faults faults;
    const toml::table root = wellFormed(text, file, faults);
    SalvagedProfile salvage;
    salvage.newer = root["format"].value_or(std::int64_t{0}) > 2;
    salvage.profile = ProfileReader(faults).read(root);
    salvage.problem = faults.problem(file);
    return salvage;
}

} // namespace apart
