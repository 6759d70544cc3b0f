// SPDX-License-Identifier: MIT
#include <apart/core/building_reader.hpp>
#include <apart/core/field.hpp>
#include <apart/core/legend_reader.hpp>
#include <apart/core/level_file.hpp>
#include <apart/core/toml_keys.hpp>
#include <apart/core/tuning.hpp>
#include <kodo/geometry.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace apart {

namespace {

constexpr std::size_t kMostObstructions = 64; // tables [[ground]]
constexpr std::size_t kMostWells = 8;
constexpr std::size_t kMostWaters = 4;
constexpr std::size_t kMostTables = 240; // each of [[ledge]], [[block]] and [[joint]]

constexpr std::int32_t thousandths(Real value) {
    return static_cast<std::int32_t>(value * 1000 + (value < 0 ? Real(-0.5) : Real(0.5)));
}
constexpr std::int32_t kEdge = thousandths(kFieldWidth / 2);
constexpr std::int32_t kTop = thousandths(kFieldHeight);
constexpr std::int32_t kOuter = kEdge + 1000; // ground may end within a wall
constexpr std::int32_t kLowestGround = 3000;  // above the leap of the paddle

class LevelReader {
public:
    LevelReader(const std::string& name, const std::string& file) : keys_(file) {
        level_.name = name;
    }

    Read<Level> read(const toml::table& root) {
        keys_.onlyKeys(root, {"format", "place",  "title", "idea",  "theme", "ball-speed", "lives",
                              "ball",   "paddle", "wind",  "boss",  "grid",  "legend",     "ground",
                              "well",   "water",  "ledge", "block", "joint", "keep",       "way"},
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
            legend_ = readLegend(keys_, root, level_);
            readGrid(root);
            readBoss(root);
            readBuilding(root);
            forTables(root, "ground", kMostObstructions, [&](const auto& t) { readGround(t); });
            forTables(root, "well", kMostWells, [&](const auto& t) { readWell(t); });
            forTables(root, "water", kMostWaters, [&](const auto& t) { readWater(t); });
            forTables(root, "way", kMostWays, [&](const auto& t) { readWay(t); });
        }
        const std::optional<FileProblem> problem = keys_.problem();
        return problem ? Read<Level>(*problem) : Read<Level>(level_);
    }

private:
    /// Returns false if some of the tables could not be read.
    template <typename Use>
    bool forTables(const toml::table& root, const std::string& key, std::size_t most, Use use) {
        const toml::node* node = root.get(key);
        if (node == nullptr) {
            return !keys_.isMisspelled(root, key);
        }
        const toml::array* list = node->as_array();
        if (list == nullptr || !list->is_homogeneous(toml::node_type::table)) {
            keys_.fail(TomlKeys::lineOf(*node), key + " must be tables [[" + key + "]]");
            return false;
        }
        if (list->size() > most) {
            keys_.fail(TomlKeys::lineOf(*node),
                       "there are more than " + std::to_string(most) + " tables [[" + key + "]]");
        }
        for (std::size_t i = 0; i < std::min(list->size(), most); ++i) {
            use(*list->get(i)->as_table());
        }
        return list->size() <= most;
    }

    void readBuilding(const toml::table& root) {
        BuildingReader reader(keys_, level_, legend_);
        forTables(root, "ledge", kMostTables, [&](const auto& t) { reader.readLedge(t); });
        if (!forTables(root, "block", kMostTables, [&](const auto& t) { reader.readBlock(t); })) {
            reader.doubtBlocks("");
        }
        forTables(root, "joint", kMostTables, [&](const auto& t) { reader.readJoint(t); });
        if (root.contains("keep")) {
            reader.readKeep(root);
        }
        reader.finish();
        const auto breaks = [&](const auto& b) { return level_.kinds[b.kind].breakable(); };
        if (gridRead_ && reader.hasAllBlocks() &&
            std::none_of(level_.cells.begin(), level_.cells.end(), breaks) &&
            std::none_of(level_.freeBlocks.begin(), level_.freeBlocks.end(), breaks)) {
            const toml::node* grid = root.get("grid");
            keys_.fail(TomlKeys::lineOf(grid == nullptr ? root : *grid),
                       "the level holds no block that can break");
        }
    }

    void readGrid(const toml::table& root) {
        const toml::node* node = root.get("grid");
        if (const auto* grid = root["grid"].as_string()) {
            return readRows(*grid);
        }
        gridRead_ = node == nullptr && root.contains("block"); // a level of free blocks alone
        if (node != nullptr) {
            keys_.fail(TomlKeys::lineOf(*node), "grid must be a text '''...'''");
        } else if (!gridRead_ && !keys_.isMisspelled(root, "grid") &&
                   !keys_.isMisspelled(root, "block")) {
            keys_.fail(TomlKeys::lineOf(root),
                       "the level has no block: tables [[block]] or grid = '''...''' give some");
        }
    }

    void readRows(const toml::value<std::string>& grid) {
        std::string_view rest = grid.get();
        // A line break behind the opening quotes is not in the text.
        const auto breaks = static_cast<int>(std::count(rest.begin(), rest.end(), '\n'));
        const int line =
            std::max(static_cast<int>(grid.source().end.line) - breaks, TomlKeys::lineOf(grid));
        std::map<std::string, std::vector<int>> unknown; // lines by letter
        for (int row = 0; !rest.empty() && row <= kMostRows; ++row) {
            const std::string_view letters = rest.substr(0, rest.find('\n'));
            rest.remove_prefix(std::min(letters.size() + 1, rest.size()));
            if (row == kMostRows) {
                failRow(line + row,
                        "the grid has more than " + std::to_string(kMostRows) + " rows");
            } else {
                readRow(letters, row, line + row, unknown);
            }
        }
        for (const auto& [letter, lines] : unknown) {
            keys_.failAt(lines, "the letter " + letter + " is not in the legend");
        }
    }

    void failRow(int line, std::string reason) {
        keys_.fail(line, std::move(reason));
        gridRead_ = false;
    }

    void readRow(std::string_view letters, int row, int line,
                 std::map<std::string, std::vector<int>>& unknown) {
        std::set<std::string> own; // unknown letters
        int column = 0;
        for (; !letters.empty(); ++column) {
            const auto isInner = [](char c) { return (c & 0xc0) == 0x80; }; // of UTF-8
            const auto end = std::find_if_not(letters.begin() + 1, letters.end(), isInner);
            const std::string letter(letters.begin(), end);
            letters.remove_prefix(letter.size());
            if (letter == "." || place(letter, row, column)) {
                continue;
            }
            gridRead_ = false;
            if (!legend_.isUnread(letter)) {
                own.insert(letter);
            }
        }
        if (column != kColumns) {
            failRow(line, "a row of the grid has " + std::to_string(kColumns) + " letters, not " +
                              std::to_string(column));
        }
        constexpr std::size_t kMostUnknown = 3; // a line with more of them is none of the grid
        if (own.size() > kMostUnknown && column == kColumns) {
            failRow(line, "more than " + std::to_string(kMostUnknown) +
                              " letters of this row are not in the legend");
        } else if (own.size() <= kMostUnknown) {
            for (const std::string& letter : own) {
                unknown[letter].push_back(line);
            }
        }
    }

    /// False if the legend has no such letter. Columns behind the last one are left out.
    bool place(const std::string& letter, int row, int column) {
        const auto isIt = [&](const auto& entry) {
            return letter.size() == 1 && entry.letter == letter[0];
        };
        const auto kind = std::find_if(level_.kinds.begin(), level_.kinds.end(), isIt);
        if (kind != level_.kinds.end()) {
            if (column < kColumns) {
                level_.cells.push_back({static_cast<std::uint8_t>(row),
                                        static_cast<std::uint8_t>(column),
                                        static_cast<std::uint8_t>(kind - level_.kinds.begin())});
            }
            return true;
        }
        const auto sign = std::find_if(legend_.signs.begin(), legend_.signs.end(), isIt);
        if (sign == legend_.signs.end()) {
            return false;
        }
        if (column < kColumns) {
            ObstructionDef def = sign->def;
            def.x = (2 * column + 1) * thousandths(kCellWidth) / 2 - kEdge;
            def.y = kTop - (2 * row + 1) * thousandths(kCellHeight) / 2;
            level_.obstructions.push_back(def);
        }
        return true;
    }

    void readBoss(const toml::table& root) {
        const auto has = [&](auto condition) {
            return std::any_of(level_.cells.begin(), level_.cells.end(), [&](const Cell& cell) {
                return condition(level_.kinds[cell.kind]);
            });
        };
        const bool boss = has([](const BlockKind& kind) { return kind.support == Support::Boss; });
        const bool doubtful =
            !gridRead_ || std::any_of(level_.cells.begin(), level_.cells.end(), [&](Cell cell) {
                return legend_.doubts[cell.kind].support || legend_.doubts[cell.kind].core;
            });
        if (boss && !doubtful && !has([](const BlockKind& kind) { return kind.core; })) {
            keys_.fail(TomlKeys::lineOf(root), "the boss needs a block with core = true");
        }
        const toml::node* node = root.get("boss");
        if (node == nullptr) {
            return;
        }
        const toml::table* table = node->as_table();
        if (table == nullptr || (!boss && !doubtful)) {
            keys_.fail(TomlKeys::lineOf(*node),
                       "boss must be a table { drift, speed } of a level with blocks of a boss");
        }
        if (table != nullptr) {
            keys_.onlyKeys(*table, {"drift", "speed"}, "boss.");
            level_.bossDrift = keys_.number(*table, "drift", {0, kEdge, std::nullopt});
            level_.bossSpeed = keys_.number(*table, "speed", {0, 10000, std::nullopt});
        }
    }

    void readOutline(const toml::table& table) {
        keys_.onlyKeys(table, {"points", "turf", "mirror"}, "ground.");
        ObstructionDef def;
        def.kind = ObstructionKind::Ground;
        def.turf = keys_.choice(table, "turf", kTurfNames, def.turf);
        const bool mirror = keys_.flag(table, "mirror");
        const toml::node& node = *table.get("points");
        const toml::array* list = node.as_array();
        if (list == nullptr || list->size() < 3 || list->size() > 64) {
            keys_.fail(TomlKeys::lineOf(node),
                       "points must be a list of 3 to 64 corners [x, y] of an outline");
            return;
        }
        for (const toml::node& entry : *list) {
            const std::optional<GroundPoint> point = pointOf(entry);
            if (!point) {
                keys_.fail(TomlKeys::lineOf(entry),
                           "each of points must be two whole numbers: x from " +
                               std::to_string(-kOuter) + " to " + std::to_string(kOuter) +
                               ", y from " + std::to_string(kLowestGround) + " to " +
                               std::to_string(kTop));
                return;
            }
            def.points.push_back(*point);
        }
        if (!std::holds_alternative<kodo::Compound>(kodo::decompose(outlineOf(def)))) {
            keys_.fail(TomlKeys::lineOf(node), "the outline of points crosses or touches itself");
            return;
        }
        level_.obstructions.push_back(def);
        if (mirror) {
            std::reverse(def.points.begin(), def.points.end());
            for (GroundPoint& point : def.points) {
                point.x = -point.x;
            }
            level_.obstructions.push_back(std::move(def));
        }
    }

    static std::optional<GroundPoint> pointOf(const toml::node& node) {
        const toml::array* pair = node.as_array();
        const auto* x = pair == nullptr || pair->size() != 2 ? nullptr : pair->get_as<int64_t>(0);
        const auto* y = x == nullptr ? nullptr : pair->get_as<int64_t>(1);
        const bool good = y != nullptr && x->get() >= -kOuter && x->get() <= kOuter &&
                          y->get() >= kLowestGround && y->get() <= kTop;
        return good ? std::optional(GroundPoint{static_cast<std::int32_t>(x->get()),
                                                static_cast<std::int32_t>(y->get())})
                    : std::nullopt;
    }

    void readGround(const toml::table& table) {
        if (table.contains("points")) {
            return readOutline(table);
        }
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

    void readWay(const toml::table& table) {
        keys_.onlyKeys(table, {"name", "strikes", "bank"}, "way.");
        WayDef way;
        way.name = keys_.text(table, "name");
        way.strikes = table.contains("strikes") ? keys_.text(table, "strikes") : "";
        if (table.contains("bank")) {
            way.bank = keys_.flag(table, "bank");
        }
        const bool known = std::all_of(way.strikes.begin(), way.strikes.end(), [&](char letter) {
            return legend_.isUnread({&letter, 1}) ||
                   std::any_of(level_.kinds.begin(), level_.kinds.end(),
                               [&](const BlockKind& kind) { return kind.letter == letter; });
        });
        if (!known) {
            keys_.fail(TomlKeys::lineOf(*table.get("strikes")),
                       "way.strikes must be letters of blocks in the legend");
        }
        if (!table.contains("strikes") && !table.contains("bank")) {
            keys_.fail(TomlKeys::lineOf(table), "a way needs strikes or bank");
        }
        level_.ways.push_back(way);
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
            water.dam = static_cast<std::int32_t>(found - level_.kinds.begin());
            if (found == level_.kinds.end() && !letter.empty() && !legend_.isUnread(letter)) {
                keys_.fail(TomlKeys::lineOf(*dam),
                           "water.dam must be the letter of a block in the legend that can break");
            }
        }
        level_.waters.push_back(water);
    }

    TomlKeys keys_;
    Level level_;
    Legend legend_;
    bool gridRead_ = true; // all rows of the grid
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
