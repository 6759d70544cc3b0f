// SPDX-License-Identifier: MIT
#include <apart/core/editor/level_writer.hpp>
#include <apart/core/toml_keys.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cctype>

namespace apart {
namespace {

template <typename T, std::size_t kCount>
std::string nameIn(const std::array<std::string_view, kCount>& names, T value) {
    return std::string(names[static_cast<std::size_t>(value)]);
}

class LevelWriter {
public:
    explicit LevelWriter(const Level& level) : level_(level), names_(level.freeBlocks.size()) {
        if (level.keep >= 0) {
            names_[static_cast<std::size_t>(level.keep)] = level.keepName;
        }
    }

    std::string write() {
        writeHead();
        writeSigns(); // before the grid, which needs their letters
        writeGrid();
        text_ += legend_;
        for (const BlockKind& kind : level_.kinds) {
            writeKind(kind);
        }
        for (const ObstructionDef& def : level_.obstructions) {
            if (def.kind == ObstructionKind::Ledge) {
                writeLedge(def);
            }
        }
        writeBlocks();
        for (const LinkDef& link : level_.links) {
            writeLink(link);
        }
        for (const ObstructionDef& def : level_.obstructions) {
            if (def.kind == ObstructionKind::Ground) {
                writeGround(def);
            }
        }
        for (const WayDef& way : level_.ways) {
            table("way");
            line("name", basicString(way.name));
            if (!way.strikes.empty()) {
                line("strikes", basicString(way.strikes));
            }
            if (way.bank) {
                line("bank", *way.bank ? "true" : "false");
            }
        }
        for (const WellDef& well : level_.wells) {
            table("well");
            number("x", well.x);
            number("y", well.y);
            number("strength", well.strength);
        }
        for (const WaterDef& water : level_.waters) {
            writeWater(water);
        }
        return std::move(text_);
    }

private:
    void line(std::string_view key, std::string_view value) {
        text_.append(key).append(" = ").append(value).append("\n");
    }
    void number(std::string_view key, std::int32_t value) { line(key, std::to_string(value)); }
    void pair(std::string_view key, std::int32_t x, std::int32_t y) {
        text_.append(key).append(" = [").append(std::to_string(x)).append(", ");
        text_.append(std::to_string(y)).append("]\n");
    }
    /// A line, unless the value is the default.
    void unless(std::int32_t usual, std::string_view key, std::int32_t value) {
        if (value != usual) {
            number(key, value);
        }
    }
    void table(std::string_view name) { text_.append("\n[[").append(name).append("]]\n"); }

    void writeHead() {
        const Level usual;
        number("format", 1);
        unless(usual.place, "place", level_.place);
        line("title", basicString(level_.title));
        line("idea", basicString(level_.idea));
        line("theme", basicString(nameIn(kThemeNames, level_.theme)));
        number("ball-speed", level_.ballSpeed);
        unless(usual.lives, "lives", level_.lives);
        if (level_.ball != usual.ball) {
            line("ball", basicString(nameIn(kBallKindNames, level_.ball)));
        }
        if (level_.paddle != usual.paddle) {
            line("paddle", basicString(nameIn(kPaddleKindNames, level_.paddle)));
        }
        unless(usual.wind, "wind", level_.wind);
        if (level_.keep >= 0) {
            line("keep", basicString(level_.keepName));
        }
        if (level_.bossDrift != 0 || level_.bossSpeed != 0) {
            line("boss", "{ drift = " + std::to_string(level_.bossDrift) +
                             ", speed = " + std::to_string(level_.bossSpeed) + " }");
        }
    }

    /// A letter that no kind and no obstruction of the grid has.
    char freeLetter() const {
        for (char letter = '~'; letter > ' '; --letter) {
            const auto taken = [&](const BlockKind& kind) { return kind.letter == letter; };
            if (letter != '.' && letter != '"' && letter != '\\' && letter != '\'' &&
                signs_.find(letter) == std::string::npos &&
                std::none_of(level_.kinds.begin(), level_.kinds.end(), taken)) {
                return letter;
            }
        }
        return '.'; // never: a grid has fewer cells of obstructions than there are kinds of them
    }

    void head(char letter) {
        const bool bare =
            std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' || letter == '_';
        const std::string key(1, letter);
        text_ += "\n[legend." + (bare ? key : basicString(key)) + "]\n";
    }

    /// The legend of the obstructions in the grid, and their letters, by index.
    void writeSigns() {
        std::swap(text_, legend_);
        std::vector<ObstructionDef> known;
        for (const ObstructionDef& def : level_.obstructions) {
            if (def.kind == ObstructionKind::Ground || def.kind == ObstructionKind::Ledge) {
                continue;
            }
            ObstructionDef kind = def;
            kind.x = kind.y = 0;
            const auto found = std::find(known.begin(), known.end(), kind);
            const auto index = static_cast<std::size_t>(found - known.begin());
            if (found == known.end()) {
                known.push_back(kind);
                signs_ += freeLetter();
                head(signs_.back());
                line("obstruction", basicString(nameIn(kObstructionNames, kind.kind)));
                number("size", kind.size);
                number("speed", kind.speed);
                if (kind.kind == ObstructionKind::Gate) {
                    line("facing", basicString(nameIn(kFacingNames, kind.facing)));
                }
            }
            put(columnOf(def.x), rowOf(def.y), signs_[index]);
        }
        std::swap(text_, legend_);
    }

    static std::size_t columnOf(std::int32_t x) {
        return static_cast<std::size_t>((x + static_cast<std::int32_t>(kFieldWidth * 500)) /
                                        static_cast<std::int32_t>(kCellWidth * 1000));
    }
    static std::size_t rowOf(std::int32_t y) {
        return static_cast<std::size_t>((static_cast<std::int32_t>(kFieldHeight * 1000) - y) /
                                        static_cast<std::int32_t>(kCellHeight * 1000));
    }

    void put(std::size_t column, std::size_t row, char letter) {
        if (rows_.size() <= row) {
            rows_.resize(row + 1, std::string(kColumns, '.'));
        }
        rows_[row][column] = letter;
    }

    void writeGrid() {
        for (const Cell& cell : level_.cells) {
            put(cell.column, cell.row, level_.kinds[cell.kind].letter);
        }
        if (rows_.empty() && !level_.freeBlocks.empty()) {
            return;
        }
        text_ += "grid = '''\n";
        for (const std::string& row : rows_) {
            text_ += row + "\n";
        }
        text_ += "'''\n";
    }

    void writeKind(const BlockKind& kind) {
        head(kind.letter);
        line("stuff", basicString(nameIn(kStuffNames, kind.stuff)));
        if (kind.support != Support::Mounted) {
            line("hold", basicString(nameIn(kSupportNames, kind.support)));
        }
        if (kind.power != Power::None) {
            line("power", basicString(nameIn(kPowerNames, kind.power)));
        }
        if (kind.pattern != kUsualPattern[static_cast<std::size_t>(kind.stuff)]) {
            line("pattern", basicString(nameIn(kPatternNames, kind.pattern)));
        }
        if (kind.breakable()) {
            unless(kStrength[static_cast<std::size_t>(kind.stuff)], "strength", kind.strength);
        }
        if (kind.support == Support::Hanging) {
            number("arm", kind.arm);
        }
        if (kind.core) {
            line("core", "true");
        }
    }

    void writeLedge(const ObstructionDef& def) {
        table("ledge");
        number("x", def.x);
        number("y", def.y);
        number("width", def.size);
        number("height", def.height);
        unless(0, "turn", def.turn);
    }

    void writeGround(const ObstructionDef& def) {
        table("ground");
        std::string list;
        if (!def.points.empty()) {
            for (const GroundPoint& point : def.points) {
                list += (list.empty() ? "[" : ", [") + std::to_string(point.x) + ", " +
                        std::to_string(point.y) + "]";
            }
            line("points", "[" + list + "]");
            if (def.turf != Turf::Grass) {
                line("turf", basicString(nameIn(kTurfNames, def.turf)));
            }
            return;
        }
        number("x", def.x);
        number("y", def.y);
        number("spacing", def.spacing);
        for (const std::int32_t height : def.heights) {
            list += (list.empty() ? "" : ", ") + std::to_string(height);
        }
        line("heights", "[" + list + "]");
    }

    bool isNamed(std::size_t index) const {
        const auto block = static_cast<std::int32_t>(index);
        return std::any_of(level_.links.begin(), level_.links.end(),
                           [&](const LinkDef& link) { return link.a == block || link.b == block; });
    }

    /// What one block differs in from the next one of a row: x, y, turn. The rest is equal.
    static std::optional<std::array<std::int32_t, 3>> stepOf(const FreeBlock& a, FreeBlock b) {
        const std::array<std::int32_t, 3> step = {b.x - a.x, b.y - a.y, b.turn - a.turn};
        b.x = a.x;
        b.y = a.y;
        b.turn = a.turn;
        return a == b ? std::optional(step) : std::nullopt;
    }

    /// Number of blocks from `first` on that one table can hold.
    std::size_t rowFrom(std::size_t first) const {
        constexpr std::size_t kMost = 60; // copies of a table
        const auto& blocks = level_.freeBlocks;
        const auto kept = static_cast<std::size_t>(level_.keep); // none: beyond all
        std::size_t end = first + 1;
        if (first == kept || end == blocks.size()) {
            return 1;
        }
        const auto step = stepOf(blocks[first], blocks[end]);
        while (step && end < blocks.size() && end != kept && end - first < kMost &&
               stepOf(blocks[end - 1], blocks[end]) == step) {
            ++end;
        }
        return end - first;
    }

    void writeBlocks() {
        const std::string start = level_.keepName.starts_with("block") ? "part" : "block";
        for (std::size_t i = 0; i < level_.freeBlocks.size();) {
            const std::size_t count = rowFrom(i);
            std::string name = names_[i];
            bool named = !name.empty();
            for (std::size_t k = i; k < i + count; ++k) {
                named = named || isNamed(k);
            }
            if (named && name.empty()) {
                name = start + std::to_string(i + 1) + (count > 1 ? "_" : "");
            }
            for (std::size_t k = i; named && k < i + count; ++k) {
                names_[k] = count == 1 ? name : name + std::to_string(k - i + 1);
            }
            writeBlock(level_.freeBlocks[i], name);
            if (count > 1) {
                const FreeBlock& next = level_.freeBlocks[i + 1];
                const FreeBlock& block = level_.freeBlocks[i];
                number("count", static_cast<std::int32_t>(count));
                pair("step", next.x - block.x, next.y - block.y);
                unless(0, "step-turn", next.turn - block.turn);
            }
            i += count;
        }
    }

    void writeBlock(const FreeBlock& block, const std::string& name) {
        table("block");
        line("kind", basicString(std::string(1, level_.kinds[block.kind].letter)));
        if (block.form != Form::Brick) {
            line("shape", basicString(nameIn(kFormNames, block.form)));
        }
        if (!name.empty()) {
            line("name", basicString(name));
        }
        number("x", block.x);
        number("y", block.y);
        const bool arch = block.form == Form::Voussoir;
        number(arch ? "radius" : "width", block.width);
        if (!isRound(block.form)) {
            number("height", block.height);
        }
        if (arch) {
            number("span", block.extra);
        } else if (block.form == Form::L || block.form == Form::T) {
            number("thick", block.extra);
        }
        unless(0, "turn", block.turn);
        if (block.mirrored) {
            line("flip", "true");
        }
    }

    void writeLink(const LinkDef& link) {
        const auto name = [&](std::int32_t index) {
            return basicString(names_[static_cast<std::size_t>(index)]);
        };
        table("joint");
        line("kind", basicString(nameIn(kLinkNames, link.kind)));
        if (link.a >= 0) {
            line("a", name(link.a));
        }
        line("b", name(link.b));
        const bool ends = link.kind == LinkKind::Rope || link.kind == LinkKind::Spring;
        pair(ends ? "from" : "at", link.fromX, link.fromY);
        if (ends) {
            pair("to", link.toX, link.toY);
            unless(0, "slack", link.slack);
        }
        if (link.kind == LinkKind::Spring) {
            number("hertz", link.hertz);
        }
        if (link.kind == LinkKind::Slider) {
            unless(0, "axis", link.axis);
        }
        if (link.kind == LinkKind::Motor) {
            number("speed", link.speed);
        }
        if (link.kind == LinkKind::Motor || link.kind == LinkKind::Pin) {
            number("torque", link.torque);
        }
        if (link.limited) {
            pair("limits", link.low, link.high);
        }
        unless(0, "break", link.strength);
    }

    void writeWater(const WaterDef& water) {
        table("water");
        number("x", water.x);
        number("y", water.y);
        number("width", water.width);
        number("depth", water.depth);
        number("density", water.density);
        if (water.dam >= 0) {
            const BlockKind& dam = level_.kinds[static_cast<std::size_t>(water.dam)];
            line("dam", basicString(std::string(1, dam.letter)));
        }
    }

    const Level& level_;
    std::vector<std::string> names_; // of blocks, by index; empty: none
    std::vector<std::string> rows_;  // of the grid
    std::string signs_;              // letters of obstructions in the grid
    std::string legend_;             // of these
    std::string text_;
};

} // namespace

std::string toToml(const Level& level) {
    return LevelWriter(level).write();
}

} // namespace apart
