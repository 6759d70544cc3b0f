// SPDX-License-Identifier: MIT
#include <apart/core/building_reader.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

constexpr std::size_t kMostFreeBlocks = 240;
constexpr std::size_t kMostLinks = 120;
constexpr std::size_t kMostLedges = 64;
constexpr std::int32_t kMostCopies = 60;
constexpr std::int32_t kEdge = 12000; // 1/1000 m; half the width of the field
constexpr std::int32_t kTop = 18000;
constexpr std::int32_t kFullTurn = 360000; // 1/1000 degree
constexpr std::int32_t kThinnest = 100;    // 1/1000 m

struct Size {
    std::int32_t width;
    std::int32_t height;
    std::int32_t extra;
};
// By Form, 1/1000 m. A voussoir has none.
constexpr std::array<Size, 11> kUsualSizes = {{{1600, 800, 0},
                                               {3200, 400, 0},
                                               {2400, 200, 0},
                                               {800, 800, 0},
                                               {1600, 800, 0},
                                               {1600, 800, 0},
                                               {800, 800, 0},
                                               {1200, 1200, 0},
                                               {0, 800, 0},
                                               {1600, 1600, 400},
                                               {1600, 1600, 400}}};

/// The text with the number at its end raised by `more`.
std::string raised(const std::string& text, std::int32_t more) {
    const std::size_t end = text.find_last_not_of("0123456789") + 1; // npos + 1 is 0
    if (more == 0 || end == text.size() || text.size() - end > 4) {
        return text;
    }
    return text.substr(0, end) + std::to_string(std::stoi(text.substr(end)) + more);
}

} // namespace

BuildingReader::Pair BuildingReader::pair(const toml::table& table, const std::string& key,
                                          std::int32_t most, std::optional<Pair> otherwise) {
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        if (!otherwise) {
            keys_.fail(TomlKeys::lineOf(table), "the key " + key + " is missing");
        }
        return otherwise.value_or(Pair{});
    }
    const toml::array* list = node->as_array();
    std::array<std::int32_t, 2> numbers{};
    bool good = list != nullptr && list->size() == 2;
    for (std::size_t i = 0; good && i < 2; ++i) {
        const auto* value = list->get(i)->as_integer();
        good = value != nullptr && value->get() >= -most && value->get() <= most;
        numbers[i] = good ? static_cast<std::int32_t>(value->get()) : 0;
    }
    if (!good) {
        keys_.fail(TomlKeys::lineOf(*node), key + " must be two whole numbers from -" +
                                                std::to_string(most) + " to " +
                                                std::to_string(most));
    }
    return {numbers[0], numbers[1]};
}

std::optional<std::uint8_t> BuildingReader::kindOf(const toml::table& table) {
    const std::string letter = keys_.text(table, "kind");
    const auto found =
        std::find_if(level_.kinds.begin(), level_.kinds.end(), [&](const BlockKind& kind) {
            return letter.size() == 1 && kind.letter == letter[0];
        });
    if (found == level_.kinds.end()) {
        keys_.fail(TomlKeys::lineOf(table), "kind must be the letter of a block in the legend");
        return std::nullopt;
    }
    if (found->support == Support::Boss || found->support == Support::Hanging) {
        keys_.fail(TomlKeys::lineOf(table),
                   "a free block has hold = \"mounted\", \"standing\" or \"moving\"");
    }
    return static_cast<std::uint8_t>(found - level_.kinds.begin());
}

BuildingReader::Copies BuildingReader::copiesOf(const toml::table& table) {
    Copies copies;
    copies.count = keys_.number(table, "count", {1, kMostCopies, 1});
    copies.step = pair(table, "step", 2 * kEdge, Pair{});
    copies.stepTurn = keys_.number(table, "step-turn", {-kFullTurn, kFullTurn, 0});
    copies.rows = keys_.number(table, "rows", {1, kMostCopies, 1});
    copies.rowStep = pair(table, "row-step", 2 * kEdge, Pair{});
    copies.mirror = keys_.flag(table, "mirror");
    return copies;
}

void BuildingReader::forCopies(
    const Copies& copies,
    const std::function<void(Pair offset, std::int32_t turn, int side)>& use) {
    for (const int side : {1, -1}) {
        for (std::int32_t row = 0; (side == 1 || copies.mirror) && row < copies.rows; ++row) {
            for (std::int32_t i = 0; i < copies.count; ++i) {
                use({i * copies.step.first + row * copies.rowStep.first,
                     i * copies.step.second + row * copies.rowStep.second},
                    i * copies.stepTurn, side);
            }
        }
    }
}

void BuildingReader::readSize(const toml::table& table, FreeBlock& block) {
    const Size usual = kUsualSizes[static_cast<std::size_t>(block.form)];
    if (block.form == Form::Voussoir) {
        block.width = keys_.number(table, "radius", {500, 2 * kEdge, std::nullopt});
        block.height = keys_.number(table, "height", {kThinnest, kTop, usual.height});
        block.extra = keys_.number(table, "span", {1000, 120000, std::nullopt});
        return;
    }
    block.width = keys_.number(table, "width", {kThinnest, 2 * kEdge, usual.width});
    block.height = isRound(block.form)
                       ? block.width
                       : keys_.number(table, "height", {kThinnest, kTop, usual.height});
    if (block.form == Form::L || block.form == Form::T) {
        const std::int32_t most = std::min(block.width, block.height) - kThinnest;
        block.extra = keys_.number(table, "thick", {kThinnest, most, usual.extra});
    }
}

void BuildingReader::readBlock(const toml::table& table) {
    keys_.onlyKeys(table,
                   {"kind", "shape", "name", "x", "y", "width", "height", "thick", "radius", "span",
                    "turn", "count", "step", "step-turn", "rows", "row-step", "mirror"},
                   "block.");
    const int line = TomlKeys::lineOf(table);
    FreeBlock block;
    block.form = keys_.choice(table, "shape", kFormNames, Form::Brick);
    block.kind = kindOf(table).value_or(0);
    block.x = keys_.number(table, "x", {-kEdge, kEdge, std::nullopt});
    block.y = keys_.number(table, "y", {-kTop, kTop, std::nullopt});
    block.turn = keys_.number(table, "turn", {-kFullTurn, kFullTurn, 0});
    readSize(table, block);
    const Copies copies = copiesOf(table);
    const std::string name = table.contains("name") ? keys_.text(table, "name") : std::string();
    if (keys_.problem()) {
        return;
    }
    if (level_.kinds[block.kind].power != Power::None && !isRectangle(block.form)) {
        keys_.fail(line, "a block with a power is a brick, beam, plank or square");
    }
    if (level_.freeBlocks.size() + static_cast<std::size_t>(copies.total()) > kMostFreeBlocks) {
        keys_.fail(line, "there are more than " + std::to_string(kMostFreeBlocks) +
                             " blocks of [[block]]");
        return;
    }
    std::int32_t number = 0;
    forCopies(copies, [&](Pair offset, std::int32_t turn, int side) {
        FreeBlock copy = block;
        copy.x = side * (block.x + offset.first);
        copy.y = block.y + offset.second;
        copy.turn = side * (block.turn + turn);
        copy.mirrored = side < 0;
        const std::string own = copies.total() == 1 ? name : name + std::to_string(++number);
        if (!name.empty() &&
            !named_.emplace(own, static_cast<std::int32_t>(level_.freeBlocks.size())).second) {
            keys_.fail(line, "there are two blocks named " + own);
        }
        level_.freeBlocks.push_back(copy);
    });
}

void BuildingReader::readLedge(const toml::table& table) {
    keys_.onlyKeys(
        table, {"x", "y", "width", "height", "turn", "count", "step", "rows", "row-step", "mirror"},
        "ledge.");
    ObstructionDef ledge;
    ledge.kind = ObstructionKind::Ledge;
    ledge.x = keys_.number(table, "x", {-kEdge, kEdge, std::nullopt});
    ledge.y = keys_.number(table, "y", {0, kTop, std::nullopt});
    ledge.size = keys_.number(table, "width", {kThinnest, 2 * kEdge, std::nullopt});
    ledge.height = keys_.number(table, "height", {kThinnest, kTop, 400});
    ledge.turn = keys_.number(table, "turn", {-kFullTurn, kFullTurn, 0});
    const Copies copies = copiesOf(table);
    if (static_cast<std::size_t>(copies.total()) > kMostLedges) {
        keys_.fail(TomlKeys::lineOf(table),
                   "there are more than " + std::to_string(kMostLedges) + " ledges");
        return;
    }
    forCopies(copies, [&](Pair offset, std::int32_t turn, int side) {
        ObstructionDef copy = ledge;
        copy.x = side * (ledge.x + offset.first);
        copy.y = ledge.y + offset.second;
        copy.turn = side * (ledge.turn + turn);
        level_.obstructions.push_back(std::move(copy));
    });
}

std::int32_t BuildingReader::blockNamed(const toml::table& table, const std::string& key,
                                        std::int32_t copy) {
    const std::string name = raised(keys_.text(table, key), copy);
    const auto found = named_.find(name);
    if (found == named_.end()) {
        keys_.fail(TomlKeys::lineOf(*table.get(key)), "there is no block named " + name);
        return 0;
    }
    return found->second;
}

void BuildingReader::readKeep(const toml::table& root) {
    const std::int32_t index = blockNamed(root, "keep", 0);
    if (keys_.problem()) {
        return;
    }
    const BlockKind& kind = level_.kinds[level_.freeBlocks[static_cast<std::size_t>(index)].kind];
    const bool stands = kind.support == Support::Standing || kind.support == Support::Moving;
    if (kind.breakable() || !stands) {
        keys_.fail(TomlKeys::lineOf(*root.get("keep")),
                   "keep must name a block of steel with hold = \"standing\" or \"moving\"");
        return;
    }
    level_.keep = index;
    level_.keepName = keys_.text(root, "keep");
}

void BuildingReader::readNumbers(const toml::table& table, LinkDef& link) {
    const bool line = link.kind == LinkKind::Rope || link.kind == LinkKind::Spring;
    const Pair from = pair(table, line ? "from" : "at", kTop, std::nullopt);
    const Pair to = line ? pair(table, "to", kTop, std::nullopt) : from;
    link.fromX = from.first;
    link.fromY = from.second;
    link.toX = to.first;
    link.toY = to.second;
    if (link.kind == LinkKind::Rope) {
        link.slack = keys_.number(table, "slack", {0, kTop, 0});
    } else if (link.kind == LinkKind::Spring) {
        link.hertz = keys_.number(table, "hertz", {100, 20000, 2000});
        link.slack = keys_.number(table, "slack", {0, kTop, 0});
    } else if (link.kind == LinkKind::Slider) {
        link.axis = keys_.number(table, "axis", {-kFullTurn, kFullTurn, 0});
    } else {
        const bool motor = link.kind == LinkKind::Motor;
        link.speed = motor ? keys_.number(table, "speed", {-20000, 20000, 2000}) : 0;
        link.torque = keys_.number(table, "torque", {0, 1000000, motor ? 300000 : 0});
    }
    if (!line && table.contains("limits")) {
        const Pair limits = pair(table, "limits", 170000, std::nullopt);
        link.limited = true;
        link.low = limits.first;
        link.high = limits.second;
        if (link.low > link.high) {
            keys_.fail(TomlKeys::lineOf(table), "limits must be the lower and the upper one");
        }
    }
    link.strength = keys_.number(table, "break", {0, 1000000, 0});
}

void BuildingReader::readJoint(const toml::table& table) {
    keys_.onlyKeys(table,
                   {"kind", "a", "b", "at", "from", "to", "slack", "hertz", "axis", "limits",
                    "speed", "torque", "break", "count", "step"},
                   "joint.");
    const int line = TomlKeys::lineOf(table);
    LinkDef link;
    const std::optional<std::size_t> kind = keys_.choice(table, "kind", kLinkNames);
    if (!kind) {
        keys_.fail(line, "joint.kind is missing");
        return;
    }
    link.kind = static_cast<LinkKind>(*kind);
    readNumbers(table, link);
    const std::int32_t count = keys_.number(table, "count", {1, kMostCopies, 1});
    const Pair step = pair(table, "step", 2 * kEdge, Pair{});
    for (std::int32_t i = 0; i < count && !keys_.problem(); ++i) {
        LinkDef copy = link;
        copy.a = table.contains("a") ? blockNamed(table, "a", i) : -1;
        copy.b = blockNamed(table, "b", i);
        copy.fromX += i * step.first;
        copy.fromY += i * step.second;
        copy.toX += i * step.first;
        copy.toY += i * step.second;
        const auto isFixed = [&](std::int32_t index) {
            const std::uint8_t of = level_.freeBlocks[static_cast<std::size_t>(index)].kind;
            return level_.kinds[of].support == Support::Mounted;
        };
        if (!keys_.problem() && (copy.a == copy.b || isFixed(copy.b))) {
            keys_.fail(line, "joint.b is a block that moves, and another one than a");
        }
        level_.links.push_back(copy);
    }
    if (level_.links.size() > kMostLinks) {
        keys_.fail(line, "there are more than " + std::to_string(kMostLinks) + " joints");
    }
}

} // namespace apart
