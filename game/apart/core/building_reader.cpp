// SPDX-License-Identifier: MIT
#include <apart/core/building_reader.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <array>
#include <span>

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
constexpr char kNoLetter = '\0';           // of the kind of blocks with an unknown kind

/// The text with the number at its end raised by `more`.
std::string raised(const std::string& text, std::int32_t more) {
    const std::size_t end = text.find_last_not_of("0123456789") + 1; // npos + 1 is 0
    if (more == 0 || end == text.size() || text.size() - end > 4) {
        return text;
    }
    return text.substr(0, end) + std::to_string(std::stoi(text.substr(end)) + more);
}

} // namespace

std::uint8_t BuildingReader::unknownKind() {
    if (level_.kinds.empty() || level_.kinds.back().letter != kNoLetter) {
        level_.kinds.push_back({.letter = kNoLetter});
        legend_.doubts.push_back({true, true, true});
    }
    return static_cast<std::uint8_t>(level_.kinds.size() - 1);
}

std::uint8_t BuildingReader::kindOf(const toml::table& table) {
    const std::string letter = keys_.text(table, "kind");
    const auto found =
        std::find_if(level_.kinds.begin(), level_.kinds.end(), [&](const BlockKind& kind) {
            return letter.size() == 1 && kind.letter == letter[0];
        });
    if (found == level_.kinds.end()) {
        if (!letter.empty() && !legend_.isUnread(letter)) {
            keys_.fail(TomlKeys::lineOf(table), "kind must be the letter of a block in the legend");
        }
        return unknownKind();
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
    copies.step = keys_.pair(table, "step", 2 * kEdge, Pair{});
    copies.stepTurn = keys_.number(table, "step-turn", {-kFullTurn, kFullTurn, 0});
    copies.rows = keys_.number(table, "rows", {1, kMostCopies, 1});
    copies.rowStep = keys_.pair(table, "row-step", 2 * kEdge, Pair{});
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
    const FreeBlock usual = usualBlock(block.form);
    if (block.form == Form::Voussoir) {
        block.width = keys_.number(table, "radius", {500, 2 * kEdge, std::nullopt});
        block.height = keys_.number(table, "height", {kThinnest, kTop, usual.height});
        block.extra = keys_.number(table, "span", {1000, 120000, std::nullopt});
        return;
    }
    const std::size_t before = keys_.faults();
    block.width = keys_.number(table, "width", {kThinnest, 2 * kEdge, usual.width});
    block.height = isRound(block.form)
                       ? block.width
                       : keys_.number(table, "height", {kThinnest, kTop, usual.height});
    if (block.form == Form::L || block.form == Form::T) {
        block.extra = keys_.number(table, "thick", {kThinnest, kTop - kThinnest, usual.extra});
        if (keys_.faults() == before) {
            checkThickness(table, block);
        }
    }
}

void BuildingReader::checkThickness(const toml::table& table, const FreeBlock& block) {
    const std::int32_t most = std::min(block.width, block.height) - kThinnest;
    if (most < kThinnest) {
        keys_.fail(TomlKeys::lineOf(table), "width and height of an L or T must be at least " +
                                                std::to_string(2 * kThinnest));
    } else if (block.extra > most) {
        const toml::node* node = table.get("thick");
        keys_.fail(TomlKeys::lineOf(node == nullptr ? table : *node),
                   "thick must be a whole number from " + std::to_string(kThinnest) + " to " +
                       std::to_string(most));
    }
}

bool BuildingReader::exceeds(const toml::table& table, std::size_t& total, std::int32_t more,
                             std::size_t most, const std::string& things) {
    const bool before = total > most;
    total += static_cast<std::size_t>(more);
    if (!before && total > most) {
        keys_.fail(TomlKeys::lineOf(table),
                   "there are more than " + std::to_string(most) + " " + things);
    }
    return total > most;
}

void BuildingReader::doubtBlocks(const std::string& prefix) {
    doubtful_.push_back(prefix);
    complete_ = false;
}

void BuildingReader::readBlock(const toml::table& table) {
    std::size_t before = keys_.faults();
    keys_.onlyKeys(table,
                   {"kind", "shape", "name", "x", "y", "width", "height", "thick", "radius", "span",
                    "turn", "flip", "count", "step", "step-turn", "rows", "row-step", "mirror"},
                   "block.");
    FreeBlock block;
    const std::optional<std::size_t> form = keys_.choice(table, "shape", kFormNames);
    block.form = static_cast<Form>(form.value_or(0));
    const bool formRead = form || !table.contains("shape");
    block.x = keys_.number(table, "x", {-kEdge, kEdge, std::nullopt});
    // The ring of a voussoir may have its centre below the field.
    const std::int32_t lowest = block.form == Form::Voussoir || !formRead ? -kTop : 0;
    block.y = keys_.number(table, "y", {lowest, kTop, std::nullopt});
    block.turn = keys_.number(table, "turn", {-kFullTurn, kFullTurn, 0});
    block.mirrored = keys_.flag(table, "flip");
    readSize(table, block);
    const std::size_t beforeCopies = keys_.faults();
    const Copies copies = copiesOf(table);
    const bool copiesRead = keys_.faults() == beforeCopies && !keys_.isMisspelled(table, "count") &&
                            !keys_.isMisspelled(table, "rows") &&
                            !keys_.isMisspelled(table, "mirror");
    const bool placed = keys_.faults() == before;
    before = keys_.faults();
    const std::string name = table.contains("name") ? keys_.text(table, "name") : std::string();
    if (keys_.faults() > before || keys_.isMisspelled(table, "name")) {
        doubtBlocks(""); // any name
    } else if (!copiesRead && !name.empty()) {
        doubtBlocks(name);
    }
    block.kind = kindOf(table);
    if (level_.kinds[block.kind].power != Power::None && !isRectangle(block.form)) {
        keys_.fail(TomlKeys::lineOf(table),
                   "a block with a power is a brick, beam, plank or square");
    }
    addCopies(table, block, copies, name, placed);
}

void BuildingReader::addCopies(const toml::table& table, const FreeBlock& block,
                               const Copies& copies, const std::string& name, bool placed) {
    if (exceeds(table, blocks_, copies.total(), kMostFreeBlocks, "blocks of [[block]]")) {
        if (name.empty()) {
            complete_ = false;
        } else {
            doubtBlocks(name);
        }
        return;
    }
    const std::size_t first = level_.freeBlocks.size();
    std::int32_t number = 0;
    bool unique = true;
    forCopies(copies, [&](Pair offset, std::int32_t turn, int side) {
        FreeBlock copy = block;
        copy.x = side * (block.x + offset.first);
        copy.y = block.y + offset.second;
        copy.turn = side * (block.turn + turn);
        copy.mirrored = block.mirrored != (side < 0);
        const std::string own = copies.total() == 1 ? name : name + std::to_string(++number);
        if (!name.empty() &&
            !named_.emplace(own, static_cast<std::int32_t>(level_.freeBlocks.size())).second &&
            unique) {
            keys_.fail(TomlKeys::lineOf(table), "there are two blocks named " + own);
            unique = false;
        }
        level_.freeBlocks.push_back(copy);
    });
    if (placed) {
        places_.add(table, std::span(level_.freeBlocks).subspan(first));
    }
}

void BuildingReader::readLedge(const toml::table& table) {
    const std::size_t before = keys_.faults();
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
    if (exceeds(table, ledges_, copies.total(), kMostLedges, "ledges")) {
        return;
    }
    bool goodX = keys_.faults() == before;
    bool goodY = goodX;
    std::int32_t number = 0;
    forCopies(copies, [&](Pair offset, std::int32_t turn, int side) {
        ObstructionDef copy = ledge;
        copy.x = side * (ledge.x + offset.first);
        copy.y = ledge.y + offset.second;
        copy.turn = side * (ledge.turn + turn);
        const std::string of = " of copy " + std::to_string(++number);
        goodX = goodX && places_.check(table, "x", copy.x, {-kEdge, kEdge}, "x" + of);
        goodY = goodY && places_.check(table, "y", copy.y, {0, kTop}, "y" + of);
        level_.obstructions.push_back(std::move(copy));
    });
}

std::optional<std::int32_t> BuildingReader::blockNamed(const toml::table& table,
                                                       const std::string& key, std::int32_t copy) {
    const std::string given = keys_.text(table, key);
    const std::string name = raised(given, copy);
    const auto found = named_.find(name);
    if (found != named_.end()) {
        return found->second;
    }
    const bool doubtful =
        given.empty() || std::any_of(doubtful_.begin(), doubtful_.end(),
                                     [&](const auto& start) { return name.starts_with(start); });
    if (!doubtful) {
        nameless_[name].insert(TomlKeys::lineOf(*table.get(key)));
    }
    return std::nullopt;
}

void BuildingReader::finish() {
    places_.checkCrowds();
    for (const auto& [name, lines] : nameless_) {
        keys_.failAt({lines.begin(), lines.end()}, "there is no block named " + name);
    }
}

void BuildingReader::readKeep(const toml::table& root) {
    const std::optional<std::int32_t> index = blockNamed(root, "keep", 0);
    if (!index) {
        return;
    }
    const std::uint8_t of = level_.freeBlocks[static_cast<std::size_t>(*index)].kind;
    const BlockKind& kind = level_.kinds[of];
    const Legend::Doubt& doubt = legend_.doubts[of];
    const bool stands = kind.support == Support::Standing || kind.support == Support::Moving;
    if ((kind.breakable() && !doubt.stuff) || (!stands && !doubt.support)) {
        keys_.fail(TomlKeys::lineOf(*root.get("keep")),
                   "keep must name a block of steel with hold = \"standing\" or \"moving\"");
        return;
    }
    level_.keep = *index;
    level_.keepName = keys_.text(root, "keep");
}

void BuildingReader::readNumbers(const toml::table& table, LinkDef& link) {
    const bool line = link.kind == LinkKind::Rope || link.kind == LinkKind::Spring;
    const Pair from = keys_.pair(table, line ? "from" : "at", kTop, std::nullopt);
    const Pair to = line ? keys_.pair(table, "to", kTop, std::nullopt) : from;
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
        const Pair limits = keys_.pair(table, "limits", 170000, std::nullopt);
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
    const std::size_t before = keys_.faults();
    keys_.onlyKeys(table,
                   {"kind", "a", "b", "at", "from", "to", "slack", "hertz", "axis", "limits",
                    "speed", "torque", "break", "count", "step"},
                   "joint.");
    LinkDef link;
    const std::optional<std::size_t> kind = keys_.choice(table, "kind", kLinkNames);
    if (kind) {
        link.kind = static_cast<LinkKind>(*kind);
        readNumbers(table, link);
    } else if (!table.contains("kind")) {
        keys_.missing(table, "kind", "joint.");
    }
    addLinks(table, link, kind && keys_.faults() == before);
}

void BuildingReader::addLinks(const toml::table& table, const LinkDef& link, bool placed) {
    const std::size_t before = keys_.faults();
    const std::int32_t count = keys_.number(table, "count", {1, kMostCopies, 1});
    const Pair step = keys_.pair(table, "step", 2 * kEdge, Pair{});
    placed = placed && keys_.faults() == before;
    if (exceeds(table, joints_, count, kMostLinks, "joints")) {
        return;
    }
    const auto isMounted = [&](std::int32_t index) {
        const std::uint8_t of = level_.freeBlocks[static_cast<std::size_t>(index)].kind;
        return level_.kinds[of].support == Support::Mounted && !legend_.doubts[of].support;
    };
    const bool line = link.kind == LinkKind::Rope || link.kind == LinkKind::Spring;
    const auto check = [&](const char* key, std::int32_t copy, Pair place) {
        const std::string of = std::string(key) + " of copy " + std::to_string(copy + 1);
        return places_.check(table, key, place.first, {-kTop, kTop}, "x in " + of) &&
               places_.check(table, key, place.second, {-kTop, kTop}, "y in " + of);
    };
    bool good = true; // faults are named once, not for each copy
    for (std::int32_t i = 0; i < count && good; ++i) {
        LinkDef copy = link;
        const bool ofField = !table.contains("a");
        const std::optional<std::int32_t> a = ofField ? -1 : blockNamed(table, "a", i);
        const std::optional<std::int32_t> b = blockNamed(table, "b", i);
        copy.a = a.value_or(-1);
        copy.b = b.value_or(0);
        copy.fromX += i * step.first;
        copy.fromY += i * step.second;
        copy.toX += i * step.first;
        copy.toY += i * step.second;
        good = a && b;
        if (b && ((a && *a == *b) || isMounted(*b))) {
            keys_.fail(TomlKeys::lineOf(table),
                       "joint.b is a block that moves, and another one than a");
            good = false;
        }
        if (placed) {
            placed = check(line ? "from" : "at", i, {copy.fromX, copy.fromY}) &&
                     (!line || check("to", i, {copy.toX, copy.toY}));
        }
        level_.links.push_back(copy);
    }
}

} // namespace apart
