// SPDX-License-Identifier: MIT
#include <apart/core/building_reader.hpp>
#include <apart/core/level_file.hpp>
#include <apart/core/toml_keys.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace apart {

namespace {

// Defaults by ObstructionKind: 1/1000 m, and 1/1000 m/s or rad/s. A gate of size 0 fills its cell.
constexpr std::array<std::int32_t, 4> kUsualSize = {500, 200, 3000, 0};
constexpr std::array<std::int32_t, 4> kUsualSpeed = {6000, 0, 2000, 0};

constexpr std::size_t kMostObstructions = 64; // tables [[ground]]
constexpr std::size_t kMostWells = 8;
constexpr std::size_t kMostWaters = 4;
constexpr std::size_t kMostTables = 200; // each of [[ledge]], [[block]] and [[joint]]

constexpr std::int32_t thousandths(Real value) {
    return static_cast<std::int32_t>(value * 1000 + (value < 0 ? Real(-0.5) : Real(0.5)));
}
constexpr std::int32_t kEdge = thousandths(kFieldWidth / 2);
constexpr std::int32_t kTop = thousandths(kFieldHeight);

class LevelReader {
public:
    LevelReader(const std::string& name, const std::string& file) : keys_(file) {
        level_.name = name;
    }

    Read<Level> read(const toml::table& root) {
        keys_.onlyKeys(root, {"format", "place",  "title", "idea",  "theme", "ball-speed", "lives",
                              "ball",   "paddle", "wind",  "boss",  "grid",  "legend",     "ground",
                              "well",   "water",  "ledge", "block", "joint", "keep"},
                       "");
        if (keys_.number(root, "format", {1, 1, std::nullopt}) == 1) {
            level_.place = keys_.number(root, "place", {1, 9999, 9999});
            level_.title = keys_.text(root, "title");
            level_.idea = keys_.text(root, "idea");
            level_.theme = keys_.choice(root, "theme", kThemeNames, level_.theme);
            level_.ballSpeed = keys_.number(root, "ball-speed", {2000, 40000, level_.ballSpeed});
            level_.lives = keys_.number(root, "lives", {1, 9, level_.lives});
            level_.ball = keys_.choice(root, "ball", kBallKindNames, level_.ball);
            level_.paddle = keys_.choice(root, "paddle", kPaddleKindNames, level_.paddle);
            level_.wind = keys_.number(root, "wind", {-30000, 30000, 0});
            readLegend(root);
            readGrid(root);
            readBoss(root);
            readBuilding(root);
            forTables(root, "ground", kMostObstructions, [&](const auto& t) { readGround(t); });
            forTables(root, "well", kMostWells, [&](const auto& t) { readWell(t); });
            forTables(root, "water", kMostWaters, [&](const auto& t) { readWater(t); });
        }
        return keys_.problem() ? Read<Level>(*keys_.problem()) : Read<Level>(level_);
    }

private:
    /// Letter of the grid for an obstruction.
    struct Sign {
        char letter = '?';
        ObstructionDef def;
    };

    template <typename Use>
    void forTables(const toml::table& root, const std::string& key, std::size_t most, Use use) {
        const toml::node* node = root.get(key);
        if (node == nullptr) {
            return;
        }
        const toml::array* list = node->as_array();
        if (list == nullptr || !list->is_homogeneous(toml::node_type::table)) {
            keys_.fail(TomlKeys::lineOf(*node), key + " must be tables [[" + key + "]]");
            return;
        }
        if (list->size() > most) {
            keys_.fail(TomlKeys::lineOf(*node),
                       "there are more than " + std::to_string(most) + " tables [[" + key + "]]");
            return;
        }
        for (const toml::node& entry : *list) {
            use(*entry.as_table());
        }
    }

    void readBuilding(const toml::table& root) {
        BuildingReader reader(keys_, level_);
        forTables(root, "ledge", kMostTables, [&](const auto& t) { reader.readLedge(t); });
        forTables(root, "block", kMostTables, [&](const auto& t) { reader.readBlock(t); });
        forTables(root, "joint", kMostTables, [&](const auto& t) { reader.readJoint(t); });
        if (root.contains("keep")) {
            reader.readKeep(root);
        }
        const auto breaks = [&](const auto& b) { return level_.kinds[b.kind].breakable(); };
        if (!keys_.problem() && std::none_of(level_.cells.begin(), level_.cells.end(), breaks) &&
            std::none_of(level_.freeBlocks.begin(), level_.freeBlocks.end(), breaks)) {
            const toml::node* grid = root.get("grid");
            keys_.fail(TomlKeys::lineOf(grid == nullptr ? root : *grid),
                       "the level holds no block that can break");
        }
    }

    void readLegend(const toml::table& root) {
        const toml::node* node = root.get("legend");
        const toml::table* legend = node == nullptr ? nullptr : node->as_table();
        if (legend == nullptr) {
            keys_.fail(TomlKeys::lineOf(node == nullptr ? root : *node),
                       "the tables [legend.X] are missing: one for each letter of the grid");
            return;
        }
        for (const auto& [key, entry] : *legend) {
            const std::string letter(key.str());
            const int line = static_cast<int>(key.source().begin.line);
            const std::string prefix = "legend." + letter + ".";
            if (letter.size() != 1 || letter == "." || letter[0] <= ' ' || letter[0] > '~') {
                keys_.fail(line,
                           "legend." + letter + ": a letter of the grid is one visible character");
            } else if (!entry.is_table()) {
                keys_.fail(line, "legend." + letter + " must be a table");
            } else if (entry.as_table()->contains("obstruction")) {
                readSign(letter[0], prefix, *entry.as_table());
            } else {
                readKind(letter[0], prefix, *entry.as_table());
            }
        }
    }

    void readKind(char letter, const std::string& prefix, const toml::table& table) {
        keys_.onlyKeys(table, {"stuff", "strength", "pattern", "power", "hold", "arm", "core"},
                       prefix);
        const std::optional<std::size_t> stuff = keys_.choice(table, "stuff", kStuffNames);
        const int line = TomlKeys::lineOf(table);
        if (!stuff) {
            keys_.fail(line, prefix + "stuff is missing");
            return;
        }
        BlockKind kind;
        kind.letter = letter;
        kind.stuff = static_cast<Stuff>(*stuff);
        kind.pattern = keys_.choice(table, "pattern", kPatternNames, kUsualPattern[*stuff]);
        kind.power = keys_.choice(table, "power", kPowerNames, Power::None);
        kind.support = keys_.choice(table, "hold", kSupportNames, Support::Mounted);
        if (kind.support == Support::Hanging) {
            kind.arm = keys_.number(table, "arm", {thousandths(kCellHeight / 2), 6000, 800});
        } else if (table.contains("arm")) {
            keys_.fail(line, prefix + "arm is for a block with hold = \"hanging\"");
        }
        kind.core = keys_.flag(table, "core");
        if (kind.core && (kind.support != Support::Boss || !kind.breakable())) {
            keys_.fail(line, prefix + "core is for a block with hold = \"boss\" that can break");
        }
        if (kind.breakable()) {
            kind.strength = keys_.number(table, "strength", {1, 1000000, kStrength[*stuff]});
        } else if (table.contains("strength") || kind.power != Power::None) {
            keys_.fail(line, prefix + "steel never breaks: it has no strength and no power");
        }
        level_.kinds.push_back(kind);
    }

    void readSign(char letter, const std::string& prefix, const toml::table& table) {
        keys_.onlyKeys(table, {"obstruction", "size", "speed", "facing"}, prefix);
        const auto inGrid = std::span(kObstructionNames).first(kUsualSize.size());
        const std::optional<std::size_t> kind = keys_.choice(table, "obstruction", inGrid);
        if (!kind) {
            return;
        }
        Sign sign{letter, {}};
        sign.def.kind = static_cast<ObstructionKind>(*kind);
        sign.def.size = keys_.number(table, "size", {50, 12000, kUsualSize[*kind]});
        sign.def.speed = keys_.number(table, "speed", {-20000, 20000, kUsualSpeed[*kind]});
        sign.def.facing = keys_.choice(table, "facing", kFacingNames, Facing::Up);
        if (sign.def.kind == ObstructionKind::Gate && sign.def.size == 0) {
            const bool lies = sign.def.facing == Facing::Up || sign.def.facing == Facing::Down;
            sign.def.size = thousandths(lies ? kCellWidth : kCellHeight);
        }
        signs_.push_back(sign);
    }

    void readGrid(const toml::table& root) {
        const toml::node* node = root.get("grid");
        const auto* grid = node == nullptr ? nullptr : node->as_string();
        if (node == nullptr && root.contains("block")) {
            return; // a level of free blocks alone
        }
        if (grid == nullptr) {
            keys_.fail(TomlKeys::lineOf(node == nullptr ? root : *node),
                       "the text grid = '''...''' is missing");
            return;
        }
        std::string_view rest = grid->get();
        int row = 0;
        for (; !rest.empty() && !keys_.problem(); ++row) {
            const std::string_view line = rest.substr(0, rest.find('\n'));
            rest.remove_prefix(std::min(line.size() + 1, rest.size()));
            readRow(line, row, TomlKeys::lineOf(*grid) + 1 + row);
        }
    }

    void readRow(std::string_view letters, int row, int line) {
        if (row >= kMostRows) {
            keys_.fail(line, "the grid has more than " + std::to_string(kMostRows) + " rows");
            return;
        }
        if (letters.size() != kColumns) {
            keys_.fail(line, "a row of the grid has " + std::to_string(kColumns) +
                                 " letters, not " + std::to_string(letters.size()));
            return;
        }
        for (int column = 0; column < kColumns; ++column) {
            const char letter = letters[static_cast<std::size_t>(column)];
            if (letter != '.' && !place(letter, row, column)) {
                keys_.fail(line, std::string("the letter ") + letter + " is not in the legend");
                return;
            }
        }
    }

    bool place(char letter, int row, int column) {
        const auto isIt = [&](const auto& entry) { return entry.letter == letter; };
        const auto kind = std::find_if(level_.kinds.begin(), level_.kinds.end(), isIt);
        if (kind != level_.kinds.end()) {
            level_.cells.push_back({static_cast<std::uint8_t>(row),
                                    static_cast<std::uint8_t>(column),
                                    static_cast<std::uint8_t>(kind - level_.kinds.begin())});
            return true;
        }
        const auto sign = std::find_if(signs_.begin(), signs_.end(), isIt);
        if (sign == signs_.end()) {
            return false;
        }
        ObstructionDef def = sign->def;
        def.x = (2 * column + 1) * thousandths(kCellWidth) / 2 - kEdge;
        def.y = kTop - (2 * row + 1) * thousandths(kCellHeight) / 2;
        level_.obstructions.push_back(def);
        return true;
    }

    void readBoss(const toml::table& root) {
        const auto has = [&](auto condition) {
            return std::any_of(level_.cells.begin(), level_.cells.end(), [&](const Cell& cell) {
                return condition(level_.kinds[cell.kind]);
            });
        };
        const bool boss = has([](const BlockKind& kind) { return kind.support == Support::Boss; });
        if (boss && !has([](const BlockKind& kind) { return kind.core; })) {
            keys_.fail(TomlKeys::lineOf(root), "the boss needs a block with core = true");
        }
        const toml::node* node = root.get("boss");
        if (node == nullptr) {
            return;
        }
        const toml::table* table = node->as_table();
        if (table == nullptr || !boss) {
            keys_.fail(TomlKeys::lineOf(*node),
                       "boss must be a table { drift, speed } of a level with blocks of a boss");
            return;
        }
        keys_.onlyKeys(*table, {"drift", "speed"}, "boss.");
        level_.bossDrift = keys_.number(*table, "drift", {0, kEdge, std::nullopt});
        level_.bossSpeed = keys_.number(*table, "speed", {0, 10000, std::nullopt});
    }

    void readGround(const toml::table& table) {
        keys_.onlyKeys(table, {"x", "y", "spacing", "heights"}, "ground.");
        ObstructionDef def;
        def.kind = ObstructionKind::Ground;
        def.x = keys_.number(table, "x", {-kEdge, kEdge, std::nullopt});
        def.y = keys_.number(table, "y", {0, kTop, std::nullopt});
        def.spacing = keys_.number(table, "spacing", {100, kEdge, std::nullopt});
        const toml::node* node = table.get("heights");
        const toml::array* list = node == nullptr ? nullptr : node->as_array();
        const int line = TomlKeys::lineOf(node == nullptr ? table : *node);
        if (list == nullptr || list->size() < 2 || list->size() > 64) {
            keys_.fail(line, "heights must be a list of 2 to 64 whole numbers");
            return;
        }
        for (const toml::node& entry : *list) {
            const auto* value = entry.as_integer();
            if (value == nullptr || value->get() < 0 || value->get() > kTop) {
                keys_.fail(line, "each of heights must be a whole number from 0 to " +
                                     std::to_string(kTop));
                return;
            }
            def.heights.push_back(static_cast<std::int32_t>(value->get()));
        }
        level_.obstructions.push_back(std::move(def));
    }

    void readWell(const toml::table& table) {
        keys_.onlyKeys(table, {"x", "y", "strength"}, "well.");
        level_.wells.push_back({keys_.number(table, "x", {-kEdge, kEdge, std::nullopt}),
                                keys_.number(table, "y", {0, kTop, std::nullopt}),
                                keys_.number(table, "strength", {-500000, 500000, std::nullopt})});
    }

    void readWater(const toml::table& table) {
        keys_.onlyKeys(table, {"x", "y", "width", "depth", "density", "dam"}, "water.");
        WaterDef water;
        water.x = keys_.number(table, "x", {-kEdge, kEdge, std::nullopt});
        water.y = keys_.number(table, "y", {0, kTop, std::nullopt});
        water.width = keys_.number(table, "width", {100, 2 * kEdge, std::nullopt});
        water.depth = keys_.number(table, "depth", {100, kTop, std::nullopt});
        water.density = keys_.number(table, "density", {1, 10000, kUsualWaterDensity});
        if (const toml::node* dam = table.get("dam")) {
            const std::string letter = keys_.text(table, "dam");
            const auto found =
                std::find_if(level_.kinds.begin(), level_.kinds.end(), [&](const BlockKind& kind) {
                    return letter.size() == 1 && kind.letter == letter[0] && kind.breakable();
                });
            if (found == level_.kinds.end()) {
                keys_.fail(TomlKeys::lineOf(*dam),
                           "water.dam must be the letter of a block in the legend that can break");
            }
            water.dam = static_cast<std::int32_t>(found - level_.kinds.begin());
        }
        level_.waters.push_back(water);
    }

    TomlKeys keys_;
    Level level_;
    std::vector<Sign> signs_;
};

} // namespace

Read<Level> parseLevel(std::string_view text, const std::string& name, const std::string& file) {
    if (text.size() > kLargestLevel) {
        return FileProblem{file, 0, "is longer than " + std::to_string(kLargestLevel) + " bytes"};
    }
    const Read<toml::table> root = parseToml(text, file);
    if (const auto* problem = std::get_if<FileProblem>(&root)) {
        return *problem;
    }
    return LevelReader(name, file).read(std::get<toml::table>(root));
}

Read<Level> readLevelFile(const std::filesystem::path& path) {
    const Read<std::string> text = readTextFile(path, kLargestLevel);
    if (const auto* problem = std::get_if<FileProblem>(&text)) {
        return *problem;
    }
    return parseLevel(std::get<std::string>(text), path.stem().string(), path.string());
}

} // namespace apart
