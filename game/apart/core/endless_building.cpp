// SPDX-License-Identifier: MIT
#include <apart/core/bot.hpp>
#include <apart/core/endless.hpp>
#include <apart/core/endless_building.hpp>
#include <apart/core/game.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <array>

namespace apart {

namespace {

// 1/1000 m.
constexpr std::int32_t kLedge = 400; // height of a ledge
constexpr std::int32_t kBrickWide = 1600;
constexpr std::int32_t kBrickHigh = 800;
constexpr std::int32_t kBeamHigh = 400;
constexpr std::int32_t kPostWide = 600;
constexpr std::int32_t kHighest = 15400; // top of the highest row
constexpr std::int32_t kSpread = 7600;   // of the towers at the sides, from the middle
constexpr std::int32_t kGap = 2400;      // between the ledges of the tower in the middle: serves
                                         // pass it

constexpr std::uint32_t kServeGames = 16; // of the check of serves, each with its own seed

class BuildingMaker {
public:
    BuildingMaker(Level& level, Generator& chance, std::uint32_t hardness)
        : level_(level), chance_(chance), hardness_(hardness) {
        for (std::size_t i = 0; i < kindOf_.size(); ++i) {
            kindOf_[i] = addUsualKind(level_, static_cast<char>('1' + i), static_cast<Stuff>(i),
                                      Power::None, Support::Standing);
        }
    }

    void build() {
        const bool middle = chance_.below(3) != 0;
        const bool sides = !middle || chance_.below(4) != 0;
        level_.idea =
            !middle ? "Two towers, and a way between them: over the roofs is the longer one."
            : sides ? "Three towers: the one in the middle stands astride the first serve."
                    : "One tower astride a gap: what spans the gap carries all above.";
        if (middle) {
            addTower(0, 3 * kBrickWide);
        }
        if (sides) {
            const std::size_t first = level_.freeBlocks.size();
            const std::size_t ledge = level_.obstructions.size();
            addTower(middle ? kSpread : kSpread - 1600, 2 * kBrickWide);
            mirror(first, ledge);
        }
        addPower();
    }

private:
    /// Glass and wood at first; brick and stone with the hardness.
    std::uint8_t someKind() {
        const std::uint32_t hard = chance_.below(40) + hardness_;
        const Stuff stuff = hard < 12   ? Stuff::Glass
                            : hard < 28 ? Stuff::Wood
                            : hard < 52 ? Stuff::Brick
                                        : Stuff::Stone;
        return kindOf_[static_cast<std::size_t>(stuff)];
    }

    void add(Form form, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height) {
        level_.freeBlocks.push_back(
            {.kind = kind_, .form = form, .x = x, .y = y, .width = width, .height = height});
    }

    /// Bricks side by side. Returns the height of the row.
    std::int32_t addBricks(std::int32_t x, std::int32_t y, std::int32_t width) {
        const std::int32_t count = width / kBrickWide;
        for (std::int32_t i = 0; i < count; ++i) {
            add(Form::Brick, x + (2 * i - count + 1) * kBrickWide / 2, y + kBrickHigh / 2,
                kBrickWide, kBrickHigh);
        }
        return kBrickHigh;
    }

    /// Pillars at the ends, a third one in the middle of a wide row that is not open, and a beam on
    /// them.
    std::int32_t addStorey(std::int32_t x, std::int32_t y, std::int32_t width, bool open) {
        const std::int32_t high = 800 + 200 * static_cast<std::int32_t>(chance_.below(5));
        const std::int32_t arm = (width - kPostWide) / 2;
        for (const std::int32_t from : {-arm, 0, arm}) {
            if (from != 0 || (width > 2 * kBrickWide && !open)) {
                add(Form::Brick, x + from, y + high / 2, kPostWide, high);
            }
        }
        kind_ = someKind();
        add(Form::Beam, x, y + high + kBeamHigh / 2, width, kBeamHigh);
        return high + kBeamHigh;
    }

    void addLedge(std::int32_t x, std::int32_t y, std::int32_t size) {
        level_.obstructions.push_back({.kind = ObstructionKind::Ledge,
                                       .x = x,
                                       .y = y,
                                       .size = size,
                                       .heights = {},
                                       .height = kLedge});
    }

    void addTower(std::int32_t x, std::int32_t width) {
        const std::int32_t low = 5400 + 400 * static_cast<std::int32_t>(chance_.below(5));
        const bool open = width > 2 * kBrickWide; // a narrow tower stands beside the serves
        const std::int32_t size = width + 400;
        if (open) {
            addLedge(x - (size + kGap) / 4, low, (size - kGap) / 2);
            addLedge(x + (size + kGap) / 4, low, (size - kGap) / 2);
        } else {
            addLedge(x, low, size);
        }
        const std::uint32_t rows = 3 + chance_.below(2 + hardness_ / 8);
        std::int32_t y = low + kLedge / 2;
        for (std::uint32_t row = 0; row < rows && y + 2000 < kHighest; ++row) {
            kind_ = someKind();
            const bool solid = row > 0 && chance_.below(3) == 0;
            y += solid ? addBricks(x, y, width) : addStorey(x, y, width, open && row == 0);
            if (row > 0 && width > 2 * kBrickWide && chance_.below(2) == 0) {
                width -= kBrickWide;
            }
        }
        kind_ = someKind();
        add(Form::Gable, x, y + 500, width * 3 / 4, 1000);
    }

    /// The blocks and ledges from these indices on again, on the other side.
    void mirror(std::size_t block, std::size_t ledge) {
        for (std::size_t i = block, end = level_.freeBlocks.size(); i < end; ++i) {
            FreeBlock copy = level_.freeBlocks[i];
            copy.x = -copy.x;
            copy.mirrored = true;
            level_.freeBlocks.push_back(copy);
        }
        for (std::size_t i = ledge, end = level_.obstructions.size(); i < end; ++i) {
            ObstructionDef copy = level_.obstructions[i];
            copy.x = -copy.x;
            level_.obstructions.push_back(copy);
        }
    }

    /// One rectangle releases a power.
    void addPower() {
        constexpr std::array<Power, 5> kUseful = {Power::Weld, Power::Split, Power::Heavy,
                                                  Power::Wings, Power::Magnet};
        const Power power = kUseful[chance_.below(kUseful.size())];
        const std::size_t index =
            chance_.below(static_cast<std::uint32_t>(level_.freeBlocks.size()));
        FreeBlock& block = level_.freeBlocks[index];
        if (isRectangle(block.form)) {
            block.kind =
                addUsualKind(level_, 'p', level_.kinds[block.kind].stuff, power, Support::Standing);
        }
    }

    Level& level_;
    Generator& chance_;
    std::uint32_t hardness_;
    std::array<std::uint8_t, 4> kindOf_{}; // by Stuff
    std::uint8_t kind_ = 0;                // of the next blocks
};

} // namespace

void addBuildings(Level& level, Generator& chance, std::uint32_t hardness) {
    BuildingMaker(level, chance, hardness).build();
}

bool stands(const Level& level) {
    constexpr kodo::Real kMost = kodo::Real(0.01); // m
    Game game(level, 1);
    const std::vector<Block> blocks(game.blocks().begin(), game.blocks().end());
    while (game.ticks() < kSettleTicks) {
        game.tick({});
        bool asleep = true;
        for (const Block& block : blocks) {
            if (!game.world().contains(block.body)) {
                return false;
            }
            const kodo::BodyView body = game.world()[block.body];
            asleep = asleep && (block.support != Support::Standing || body.isAsleep());
            if (lengthSquared(body.position() - block.home.position) > kMost * kMost &&
                block.support == Support::Standing) {
                return false;
            }
        }
        if (asleep) {
            return true;
        }
    }
    return false;
}

bool servesHit(const Level& level) {
    std::uint32_t hits = 0;
    for (std::uint32_t seed = 1; seed <= kServeGames; ++seed) {
        Game game(level, seed);
        const kodo::Vec2 from = game.world()[game.balls()[0].body].position();
        hits += game.state().meetsBlock(from, kFarSight * game.balls()[0].heading) ? 1 : 0;
    }
    return 4 * hits >= 3 * kServeGames;
}

bool isSolvable(const Level& level) {
    Game game(level, 1);
    while (game.result() == Result::Playing && game.ticks() < kSolveTicks) {
        game.tick(bot(game));
    }
    return game.result() == Result::Won && game.collapse().largest >= kLeastFall;
}

} // namespace apart
