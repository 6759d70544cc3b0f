// SPDX-License-Identifier: MIT
#include <apart/core/legend_reader.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace apart {

namespace {

// Defaults by ObstructionKind: 1/1000 m, and 1/1000 m/s or rad/s. A gate of size 0 fills its cell.
constexpr std::array<std::int32_t, 4> kUsualSize = {500, 200, 3000, 0};
constexpr std::array<std::int32_t, 4> kUsualSpeed = {6000, 0, 2000, 0};

constexpr std::int32_t toThousandths(Real value) {
    return static_cast<std::int32_t>(value * 1000 + Real(0.5));
}

class LegendReader {
public:
    LegendReader(TomlKeys& keys, Level& level) : keys_(keys), level_(level) {}

    Legend read(const toml::table& root) {
        const toml::node* node = root.get("legend");
        const toml::table* table = node == nullptr ? nullptr : node->as_table();
        legend_.complete = table != nullptr && !keys_.isMisspelled(root, "legend");
        if (table != nullptr) {
            for (const auto& [key, entry] : *table) {
                readEntry(std::string(key.str()), static_cast<int>(key.source().begin.line), entry);
            }
        } else if (node != nullptr) {
            keys_.fail(TomlKeys::lineOf(*node), "legend must be tables [legend.X]");
        } else if (!keys_.isMisspelled(root, "legend")) {
            keys_.fail(TomlKeys::lineOf(root),
                       "the tables [legend.X] are missing: one for each letter of the grid");
        }
        return std::move(legend_);
    }

private:
    /// True for an obstruction, also with a misspelling of this key.
    static bool isSign(const toml::table& table) {
        return std::any_of(table.begin(), table.end(), [](const auto& entry) {
            return TomlKeys::isSimilar(entry.first.str(), "obstruction");
        });
    }

    void readEntry(const std::string& letter, int line, const toml::node& entry) {
        const std::string prefix = "legend." + letter + ".";
        if (letter.size() != 1 || letter == "." || letter[0] <= ' ' || letter[0] > '~') {
            keys_.fail(line,
                       "legend." + letter + ": a letter of the grid is one visible character");
            legend_.unread += letter;
        } else if (!entry.is_table()) {
            keys_.fail(line, "legend." + letter + " must be a table");
            legend_.unread += letter;
        } else if (isSign(*entry.as_table())) {
            readSign(letter[0], prefix, *entry.as_table());
        } else {
            readKind(letter[0], prefix, *entry.as_table());
        }
    }

    void readKind(char letter, const std::string& prefix, const toml::table& table) {
        keys_.onlyKeys(table, {"stuff", "strength", "pattern", "power", "hold", "arm", "core"},
                       prefix);
        const std::optional<std::size_t> stuff = keys_.choice(table, "stuff", kStuffNames);
        if (!table.contains("stuff")) {
            keys_.missing(table, "stuff", prefix);
        }
        BlockKind kind;
        Legend::Doubt doubt{.stuff = !stuff};
        kind.letter = letter;
        kind.stuff = static_cast<Stuff>(stuff.value_or(0));
        kind.pattern =
            keys_.choice(table, "pattern", kPatternNames, kUsualPattern[stuff.value_or(0)]);
        kind.power = keys_.choice(table, "power", kPowerNames, Power::None);
        const std::optional<std::size_t> hold = keys_.choice(table, "hold", kSupportNames);
        doubt.support = (!hold && table.contains("hold")) || keys_.isMisspelled(table, "hold");
        kind.support = static_cast<Support>(hold.value_or(0));
        const std::size_t before = keys_.faults();
        kind.core = keys_.flag(table, "core");
        doubt.core = keys_.faults() > before || keys_.isMisspelled(table, "core");
        readUses(table, prefix, kind, doubt);
        level_.kinds.push_back(kind);
        legend_.doubts.push_back(doubt);
    }

    /// Keys that are for some kinds alone.
    void readUses(const toml::table& table, const std::string& prefix, BlockKind& kind,
                  const Legend::Doubt& doubt) {
        const int line = TomlKeys::lineOf(table);
        if (kind.support == Support::Hanging || doubt.support) {
            kind.arm = keys_.number(table, "arm", {toThousandths(kCellHeight / 2), 6000, 800});
        } else if (table.contains("arm")) {
            keys_.fail(line, prefix + "arm is for a block with hold = \"hanging\"");
        }
        const bool ofBoss = kind.support == Support::Boss || doubt.support;
        const bool breaks = kind.breakable() || doubt.stuff;
        if (kind.core && (!ofBoss || !breaks)) {
            keys_.fail(line, prefix + "core is for a block with hold = \"boss\" that can break");
        }
        if (breaks) {
            kind.strength = keys_.number(
                table, "strength", {1, 1000000, kStrength[static_cast<std::size_t>(kind.stuff)]});
        } else if (table.contains("strength") || kind.power != Power::None) {
            keys_.fail(line, prefix + "steel never breaks: it has no strength and no power");
        }
    }

    void readSign(char letter, const std::string& prefix, const toml::table& table) {
        keys_.onlyKeys(table, {"obstruction", "size", "speed", "facing"}, prefix);
        const auto inGrid = std::span(kObstructionNames).first(kUsualSize.size());
        const std::optional<std::size_t> kind = keys_.choice(table, "obstruction", inGrid);
        Legend::Sign sign{letter, {}};
        sign.def.kind = static_cast<ObstructionKind>(kind.value_or(0));
        sign.def.size = keys_.number(table, "size", {50, 12000, kUsualSize[kind.value_or(0)]});
        sign.def.speed =
            keys_.number(table, "speed", {-20000, 20000, kUsualSpeed[kind.value_or(0)]});
        sign.def.facing = keys_.choice(table, "facing", kFacingNames, Facing::Up);
        if (!kind) {
            legend_.unread += letter;
            return;
        }
        if (sign.def.kind == ObstructionKind::Gate && sign.def.size == 0) {
            const bool lies = sign.def.facing == Facing::Up || sign.def.facing == Facing::Down;
            sign.def.size = toThousandths(lies ? kCellWidth : kCellHeight);
        }
        legend_.signs.push_back(sign);
    }

    TomlKeys& keys_;
    Level& level_;
    Legend legend_;
};

} // namespace

Legend readLegend(TomlKeys& keys, const toml::table& root, Level& level) {
    return LegendReader(keys, level).read(root);
}

} // namespace apart
