// SPDX-License-Identifier: MIT
#include <apart/core/level_file.hpp>
#include <apart/core/tuning.hpp>

#include <toml++/toml.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>

namespace apart {

namespace {

constexpr std::size_t kLongestText = 160; // bytes of title or idea

/// Reads one level and keeps the first problem that it meets.
class LevelReader {
public:
    LevelReader(const std::string& name, const std::string& file) : file_(file) {
        level_.name = name;
    }

    Read<Level> read(const toml::table& root) {
        onlyKeys(root,
                 {"format", "place", "title", "idea", "theme", "ball-speed", "lives", "grid", "legend"}, "");
        if (number(root, "format", {1, 1, std::nullopt}) == 1) {
            level_.place = number(root, "place", {1, 9999, 9999});
            level_.title = text(root, "title");
            level_.idea = text(root, "idea");
            level_.theme = static_cast<Theme>(choice(root, "theme", kThemeNames).value_or(0));
            level_.ballSpeed = number(root, "ball-speed", {2000, 40000, level_.ballSpeed});
            level_.lives = number(root, "lives", {1, 9, level_.lives});
            readLegend(root);
            readGrid(root);
        }
        return problem_ ? Read<Level>(*problem_) : Read<Level>(level_);
    }

private:
    struct Range {
        std::int32_t low = 0;
        std::int32_t high = 0;
        std::optional<std::int32_t> otherwise{}; // without it the key must be there
    };

    static int lineOf(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

    void fail(int line, std::string reason) {
        if (!problem_) {
            problem_ = FileProblem{file_, line, std::move(reason)};
        }
    }

    void onlyKeys(const toml::table& table, std::initializer_list<std::string_view> known,
                  const std::string& prefix) {
        for (const auto& [key, node] : table) {
            if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
                fail(static_cast<int>(key.source().begin.line),
                     "unknown key " + prefix + std::string(key.str()));
            }
        }
    }

    std::int32_t number(const toml::table& table, const std::string& key, const Range& range) {
        const toml::node* node = table.get(key);
        if (node == nullptr) {
            if (!range.otherwise) {
                fail(lineOf(table), "the key " + key + " is missing");
            }
            return range.otherwise.value_or(range.low);
        }
        const auto* value = node->as_integer();
        if (value == nullptr || value->get() < range.low || value->get() > range.high) {
            fail(lineOf(*node), key + " must be a whole number from " + std::to_string(range.low) +
                                    " to " + std::to_string(range.high));
            return range.low;
        }
        return static_cast<std::int32_t>(value->get());
    }

    std::string text(const toml::table& table, const std::string& key) {
        const toml::node* node = table.get(key);
        if (node == nullptr) {
            fail(lineOf(table), "the key " + key + " is missing");
            return {};
        }
        const auto* value = node->as_string();
        if (value == nullptr || value->get().empty() || value->get().size() > kLongestText) {
            fail(lineOf(*node),
                 key + " must be a text of 1 to " + std::to_string(kLongestText) + " bytes");
            return {};
        }
        for (const char c : value->get()) {
            if (c >= 0 && c < ' ') {
                fail(lineOf(*node), key + " must be one line without control characters");
            }
        }
        return value->get();
    }

    /// Index of the text among the names.
    std::optional<std::size_t> choice(const toml::table& table, const std::string& key,
                                      std::span<const std::string_view> names) {
        const toml::node* node = table.get(key);
        if (node == nullptr) {
            return std::nullopt;
        }
        const std::string value = node->value_or(std::string());
        const auto found = std::find(names.begin(), names.end(), value);
        if (found != names.end()) {
            return static_cast<std::size_t>(found - names.begin());
        }
        std::string list;
        for (const std::string_view name : names) {
            list += (list.empty() ? "" : ", ") + std::string(name);
        }
        fail(lineOf(*node), key + " must be one of " + list);
        return std::nullopt;
    }

    void readLegend(const toml::table& root) {
        const toml::node* node = root.get("legend");
        const toml::table* legend = node == nullptr ? nullptr : node->as_table();
        if (legend == nullptr) {
            fail(node == nullptr ? lineOf(root) : lineOf(*node),
                 "the tables [legend.X] are missing: one for each letter of the grid");
            return;
        }
        for (const auto& [key, entry] : *legend) {
            const std::string letter(key.str());
            const int line = static_cast<int>(key.source().begin.line);
            if (letter.size() != 1 || letter == "." || letter[0] <= ' ' || letter[0] > '~') {
                fail(line, "legend." + letter + ": a letter of the grid is one visible character");
            } else if (!entry.is_table()) {
                fail(line, "legend." + letter + " must be a table");
            } else {
                readKind(letter[0], *entry.as_table());
            }
        }
    }

    void readKind(char letter, const toml::table& table) {
        const std::string prefix = std::string("legend.") + letter + ".";
        onlyKeys(table, {"stuff", "strength", "pattern", "power"}, prefix);
        const std::optional<std::size_t> stuff = choice(table, "stuff", kStuffNames);
        if (!stuff) {
            fail(lineOf(table), prefix + "stuff is missing");
            return;
        }
        BlockKind kind;
        kind.letter = letter;
        kind.stuff = static_cast<Stuff>(*stuff);
        kind.pattern =
            static_cast<Pattern>(choice(table, "pattern", kPatternNames)
                                     .value_or(static_cast<std::size_t>(kUsualPattern[*stuff])));
        kind.power = static_cast<Power>(choice(table, "power", kPowerNames).value_or(0));
        if (kind.breakable()) {
            kind.strength = number(table, "strength", {1, 1000000, kStrength[*stuff]});
        } else if (table.get("strength") != nullptr || kind.power != Power::None) {
            fail(lineOf(table), prefix + "steel never breaks: it has no strength and no power");
        }
        level_.kinds.push_back(kind);
    }

    void readGrid(const toml::table& root) {
        const toml::node* node = root.get("grid");
        const auto* grid = node == nullptr ? nullptr : node->as_string();
        if (grid == nullptr) {
            fail(node == nullptr ? lineOf(root) : lineOf(*node),
                 "the text grid = '''...''' is missing");
            return;
        }
        std::string_view rest = grid->get();
        int row = 0;
        for (; !rest.empty() && !problem_; ++row) {
            const std::string_view line = rest.substr(0, rest.find('\n'));
            rest.remove_prefix(std::min(line.size() + 1, rest.size()));
            readRow(line, row, lineOf(*grid) + 1 + row);
        }
        const bool some = std::any_of(level_.cells.begin(), level_.cells.end(), [&](const Cell& c) {
            return level_.kinds[c.kind].breakable();
        });
        if (!some) {
            fail(lineOf(*grid), "the grid holds no block that can break");
        }
    }

    void readRow(std::string_view letters, int row, int line) {
        if (row >= kMostRows) {
            fail(line, "the grid has more than " + std::to_string(kMostRows) + " rows");
            return;
        }
        if (letters.size() != kColumns) {
            fail(line, "a row of the grid has " + std::to_string(kColumns) + " letters, not " +
                           std::to_string(letters.size()));
            return;
        }
        for (int column = 0; column < kColumns; ++column) {
            const char letter = letters[static_cast<std::size_t>(column)];
            if (letter == '.') {
                continue;
            }
            const auto kind = std::find_if(level_.kinds.begin(), level_.kinds.end(),
                                           [&](const BlockKind& k) { return k.letter == letter; });
            if (kind == level_.kinds.end()) {
                fail(line, std::string("the letter ") + letter + " is not in the legend");
                return;
            }
            level_.cells.push_back({static_cast<std::uint8_t>(row),
                                    static_cast<std::uint8_t>(column),
                                    static_cast<std::uint8_t>(kind - level_.kinds.begin())});
        }
    }

    std::string file_;
    Level level_;
    std::optional<FileProblem> problem_;
};

} // namespace

Read<Level> parseLevel(std::string_view text, const std::string& name, const std::string& file) {
    if (text.size() > kLargestLevel) {
        return FileProblem{file, 0, "is longer than " + std::to_string(kLargestLevel) + " bytes"};
    }
    try {
        const toml::table root = toml::parse(text, file);
        return LevelReader(name, file).read(root);
    } catch (const toml::parse_error& error) {
        return FileProblem{file, static_cast<int>(error.source().begin.line),
                           std::string(error.description())};
    }
}

Read<Level> readLevelFile(const std::filesystem::path& path) {
    const Read<std::string> text = readTextFile(path, kLargestLevel);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        return *problem;
    }
    return parseLevel(std::get<std::string>(text), path.stem().string(), path.string());
}

} // namespace apart
