// SPDX-License-Identifier: MIT
#include <apart/core/endless.hpp>
#include <apart/core/endless_building.hpp>
#include <apart/core/generator.hpp>
#include <apart/core/text_file.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace apart {

namespace {

constexpr int kHalf = kColumns / 2;      // levels are symmetric: columns 0..7 from the middle
constexpr std::uint32_t kCandidates = 6; // to make a building that stands and can be won
constexpr int kFewest = 24;              // least number of breakable blocks
constexpr std::uint32_t kHardest = 24;   // largest hardness; level n has n - 1

/// Grid under construction: for each cell kEmpty or an index into Level::kinds.
constexpr std::uint8_t kEmpty = 255;
using Grid = std::array<std::uint8_t, static_cast<std::size_t>(kColumns* kMostRows)>;

std::size_t indexOf(int row, int column) {
    return static_cast<std::size_t>(row * kColumns + column);
}

/// A family of levels. fills() selects cells; `from` is the distance from the middle column.
struct Family {
    std::string_view noun;
    std::string_view idea; // true of all levels of the family
    bool (*fills)(int row, int from, int period);
};

int distance(int a, int b) {
    return a < b ? b - a : a - b;
}

constexpr std::array<Family, 8> kFamilies = {{
    {"terraces", "Bands with gaps between them: above a band the ball works from both sides.",
     [](int row, int, int period) { return row % period != period - 1; }},
    {"chessboard", "Blocks that meet at corners only, and corners turn the ball aside.",
     [](int row, int from, int) { return (row + from) % 2 == 0; }},
    {"arcade", "Pillars carry a roof, and between them the ball rattles up and down.",
     [](int row, int from, int period) { return row < 3 || from % period == 0; }},
    {"pyramid", "From below it is a wall, from beside it is a stair.",
     [](int row, int from, int) { return from <= row; }},
    {"funnel", "Stairs that open downwards lead the ball to the middle of the roof.",
     [](int row, int from, int) { return from >= row || row < 2; }},
    {"waves", "Slanted bands: the gaps between them lead the ball aside before they let it up.",
     [](int row, int from, int period) { return (row + from) % (period + 1) < period - 1; }},
    {"shells", "Shells around a core: one has to be opened before the next is in reach.",
     [](int row, int from, int) { return std::max(distance(row, 4) * 2, from) % 4 < 2; }},
    {"shafts", "Shafts one block wide: a ball in one breaks what bars it, or comes straight back.",
     [](int row, int from, int) { return from % 2 == 0 || row % 5 == 4; }},
}};

constexpr std::array<std::string_view, 8> kAdjectives = {
    "Quiet", "Crooked", "Brittle", "Drowned", "Winter", "Hollow", "Sunken", "Forgotten"};

// The first 3 from hardness 0, the first 9 from hardness 2, all from hardness 5.
constexpr std::array<Power, 12> kPowers = {
    Power::Weld,  Power::Launch, Power::Split, Power::Heavy,    Power::Magnet, Power::Spring,
    Power::Wings, Power::Rough,  Power::Well,  Power::Lopsided, Power::Egg,    Power::Wind};

constexpr std::int32_t kHangingArm = 800; // 1/1000 m
constexpr std::int32_t kBreeze = 4000;    // 1/1000 m/s
constexpr std::int32_t kCellThousandthsWide = 1600;
constexpr std::int32_t kCellThousandthsHigh = 800;
constexpr std::int32_t kFieldThousandthsHigh = 18000;

class Builder {
public:
    explicit Builder(const EndlessName& name)
        : chance_(mixKeys(name.seed, name.number, 5)),
          hardness_(std::min(name.number - 1, kHardest)) {
        grid_.fill(kEmpty);
        level_.name = name.text();
        level_.ballSpeed = 10500 + 125 * static_cast<std::int32_t>(hardness_);
    }

    Level build() {
        const Family& family = kFamilies[chance_.below(kFamilies.size())];
        addKinds();
        fill(family);
        placeSteel();
        openWhatIsShut();
        placePowers();
        placeAnnex();
        name(family);
        for (int row = 0; row < kMostRows; ++row) {
            for (int column = 0; column < kColumns; ++column) {
                if (const std::uint8_t kind = grid_[indexOf(row, column)]; kind != kEmpty) {
                    level_.cells.push_back(
                        {static_cast<std::uint8_t>(row), static_cast<std::uint8_t>(column), kind});
                }
            }
        }
        return std::move(level_);
    }

private:
    std::uint8_t addKind(char letter, Stuff stuff, Power power) {
        return addUsualKind(level_, letter, stuff, power, Support::Mounted);
    }

    void addKinds() {
        for (const auto& [letter, stuff] : {std::pair('g', Stuff::Glass),
                                            {'o', Stuff::Wood},
                                            {'b', Stuff::Brick},
                                            {'s', Stuff::Stone},
                                            {'X', Stuff::Steel}}) {
            addKind(letter, stuff, Power::None);
        }
    }

    static std::uint8_t kindOf(Stuff stuff) { return static_cast<std::uint8_t>(stuff); }

    /// Sets the cells at distance `from` on both sides.
    void set(int row, int from, std::uint8_t kind) {
        grid_[indexOf(row, kHalf - from)] = kind;
        grid_[indexOf(row, kHalf + from)] = kind;
    }
    std::uint8_t& at(int row, int from) { return grid_[indexOf(row, kHalf + from)]; }

    Stuff someStuff() {
        const std::uint32_t hard = chance_.below(100);
        if (hard < hardness_) {
            return Stuff::Stone;
        }
        if (hard < 30 + 2 * hardness_) {
            return Stuff::Brick;
        }
        return hard < 70 + hardness_ ? Stuff::Wood : Stuff::Glass;
    }

    void fill(const Family& family) {
        top_ = 1 + static_cast<int>(chance_.below(2));
        rows_ = 6 + static_cast<int>(chance_.below(3) + hardness_ / 8);
        const int period = 3 + static_cast<int>(chance_.below(2));
        const bool byRow = chance_.below(2) == 0; // otherwise by distance from the middle
        std::array<Stuff, kMostRows> stuffs{};
        for (Stuff& stuff : stuffs) {
            stuff = someStuff();
        }
        int count = 0;
        for (int row = 0; row < rows_; ++row) {
            for (int from = 0; from <= kHalf; ++from) {
                if (family.fills(row, from, period)) {
                    const int band = byRow ? row : from;
                    set(top_ + row, from, kindOf(stuffs[static_cast<std::size_t>(band)]));
                    count += from == 0 ? 1 : 2;
                }
            }
        }
        for (int row = top_; count < kFewest; ++row) {
            for (int from = 0; from <= kHalf; ++from) {
                count += at(row, from) == kEmpty ? 1 : 0;
                set(row, from, kindOf(Stuff::Wood));
            }
        }
    }

    /// A random breakable cell without power, in the right half; nullptr after 20 attempts.
    std::uint8_t* someCell(int& row, int& from) {
        for (int attempt = 0; attempt < 20; ++attempt) {
            row = top_ + static_cast<int>(chance_.below(static_cast<std::uint32_t>(rows_)));
            from = static_cast<int>(chance_.below(kHalf + 1));
            std::uint8_t& cell = at(row, from);
            if (cell != kEmpty && level_.kinds[cell].breakable() &&
                level_.kinds[cell].power == Power::None) {
                return &cell;
            }
        }
        return nullptr;
    }

    void placeSteel() {
        for (std::uint32_t i = 0; i < hardness_ / 4; ++i) {
            int row = 0;
            int from = 0;
            if (someCell(row, from) != nullptr) {
                set(row, from, kindOf(Stuff::Steel));
            }
        }
    }

    /// Replaces all steel by stone if a block cannot be reached. A ball is smaller than a cell, so
    /// it reaches every cell that is connected to the bottom row by cells without steel.
    void openWhatIsShut() {
        std::array<bool, static_cast<std::size_t>(kColumns * kMostRows)> reached{};
        std::vector<std::pair<int, int>> open;
        const auto visit = [&](int row, int column) {
            if (row < 0 || row >= kMostRows || column < 0 || column >= kColumns) {
                return;
            }
            const std::size_t index = indexOf(row, column);
            if (!reached[index] && grid_[index] != kindOf(Stuff::Steel)) {
                reached[index] = true;
                open.emplace_back(row, column);
            }
        };
        for (int column = 0; column < kColumns; ++column) {
            visit(kMostRows - 1, column);
        }
        while (!open.empty()) {
            const auto [row, column] = open.back();
            open.pop_back();
            visit(row - 1, column);
            visit(row + 1, column);
            visit(row, column - 1);
            visit(row, column + 1);
        }
        const bool shut = std::find(reached.begin(), reached.end(), false) != reached.end();
        for (std::size_t i = 0; i < grid_.size() && shut; ++i) {
            if (grid_[i] != kEmpty && grid_[i] != kindOf(Stuff::Steel) && !reached[i]) {
                std::replace(grid_.begin(), grid_.end(), kindOf(Stuff::Steel),
                             kindOf(Stuff::Stone));
                return;
            }
        }
    }

    void placePowers() {
        const std::size_t known = hardness_ < 2 ? 3 : hardness_ < 5 ? 9 : kPowers.size();
        const std::uint32_t pairs = 2 + chance_.below(3);
        for (std::uint32_t i = 0; i < pairs; ++i) {
            const std::size_t which = chance_.below(static_cast<std::uint32_t>(known));
            int row = 0;
            int from = 0;
            if (someCell(row, from) != nullptr) {
                const Power power = kPowers[which];
                set(row, from,
                    addKind(static_cast<char>('A' + i),
                            power == Power::Split ? Stuff::Glass : Stuff::Brick, power));
            }
        }
    }

    /// Adds hanging blocks, obstructions or wind. Bodies lie below the pattern and an empty row.
    void placeAnnex() {
        const int row = top_ + rows_ + 1;
        const std::uint32_t choices = hardness_ < 3 ? 1 : hardness_ < 7 ? 4 : 6;
        switch (chance_.below(choices)) {
        case 1: {
            BlockKind& kind = level_.kinds[addKind('h', someStuff(), Power::None)];
            kind.support = Support::Hanging;
            kind.arm = kHangingArm;
            set(row, 2, static_cast<std::uint8_t>(level_.kinds.size() - 1));
            set(row, 5, static_cast<std::uint8_t>(level_.kinds.size() - 1));
            level_.theme = Theme::Harbour;
            break;
        }
        case 2:
            addObstructions(ObstructionKind::Bumper, row, {500, 6000});
            level_.theme = Theme::Fairground;
            break;
        case 3:
            addObstructions(ObstructionKind::Pin, row, {250, 0});
            level_.theme = Theme::Fairground;
            break;
        case 4:
            addObstructions(ObstructionKind::Motor, row, {2400, 2000});
            level_.theme = Theme::Clockwork;
            break;
        case 5:
            level_.wind = chance_.below(2) == 0 ? kBreeze : -kBreeze;
            level_.theme = Theme::Harbour;
            break;
        default:
            level_.theme = hardness_ < 4 ? Theme::Daybreak : Theme::Quarry;
            break;
        }
    }

    struct Make {
        std::int32_t size = 0;
        std::int32_t speed = 0;
    };
    void addObstructions(ObstructionKind kind, int row, Make make) {
        for (const int from : {-4, 0, 4}) {
            level_.obstructions.push_back(
                {.kind = kind,
                 .x = from * kCellThousandthsWide,
                 .y = kFieldThousandthsHigh - (2 * row + 1) * kCellThousandthsHigh / 2,
                 .size = make.size,
                 .speed = from < 0 ? -make.speed : make.speed,
                 .facing = Facing::Up,
                 .spacing = 0,
                 .heights = {}});
        }
    }

    void name(const Family& family) {
        const std::string_view adjective = kAdjectives[chance_.below(kAdjectives.size())];
        level_.title = std::string(adjective) + " " + std::string(family.noun);
        level_.idea = family.idea;
    }

    Generator chance_;
    std::uint32_t hardness_; // 0..kHardest
    Level level_;
    Grid grid_{};
    int top_ = 0;
    int rows_ = 0;
};

/// Parses an integer from `least` to `most`.
std::optional<std::uint32_t> numberIn(std::string_view word, std::uint32_t least,
                                      std::uint32_t most) {
    const std::optional<std::int64_t> value = toNumber(word);
    if (!value || *value < least || *value > most) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(*value);
}

} // namespace

std::string EndlessName::text() const {
    return "endless:" + std::to_string(seed) + ":" + std::to_string(number);
}

std::optional<EndlessName> parseEndless(std::string_view name) {
    constexpr std::string_view kHead = "endless";
    if (name.substr(0, kHead.size()) != kHead) {
        return std::nullopt;
    }
    name.remove_prefix(kHead.size());
    std::array<std::optional<std::uint32_t>, 2> values = {1u, 1u};
    const std::array<std::uint32_t, 2> least = {0, 1};
    const std::array<std::uint32_t, 2> most = {std::numeric_limits<std::uint32_t>::max(),
                                               kMostEndless};
    for (std::size_t i = 0; i < values.size() && !name.empty(); ++i) {
        if (name.front() != ':') {
            return std::nullopt;
        }
        name.remove_prefix(1);
        const std::string_view word = name.substr(0, name.find(':'));
        values[i] = numberIn(word, least[i], most[i]);
        name.remove_prefix(word.size());
    }
    if (!name.empty() || !values[0] || !values[1]) {
        return std::nullopt;
    }
    return EndlessName{*values[0], *values[1]};
}

Level endlessBuilding(const EndlessName& name, std::uint32_t attempt) {
    const std::uint32_t hardness = std::min(name.number - 1, kHardest);
    Generator chance(mixKeys(mixKeys(name.seed, name.number), attempt, 17));
    Level level;
    level.name = name.text();
    level.ballSpeed = 11000 + 150 * static_cast<std::int32_t>(hardness);
    level.theme = static_cast<Theme>(chance.below(static_cast<std::uint32_t>(kThemeNames.size())));
    level.title = std::string(kAdjectives[chance.below(kAdjectives.size())]) + " towers";
    addBuildings(level, chance, hardness);
    return level;
}

Level endlessLevel(const EndlessName& name) {
    for (std::uint32_t attempt = 0; name.number % 2 == 1 && attempt < kCandidates; ++attempt) {
        Level level = endlessBuilding(name, attempt);
        if (servesHit(level) && stands(level) && isSolvable(level)) {
            return level;
        }
    }
    return Builder(name).build();
}

std::uint8_t addUsualKind(Level& level, char letter, Stuff stuff, Power power, Support support) {
    const auto index = static_cast<std::size_t>(stuff);
    level.kinds.push_back({.letter = letter,
                           .stuff = stuff,
                           .power = power,
                           .pattern = kUsualPattern[index],
                           .strength = kStrength[index],
                           .support = support});
    return static_cast<std::uint8_t>(level.kinds.size() - 1);
}

} // namespace apart
