// SPDX-License-Identifier: MIT
#include <apart/core/editor/ground_edit.hpp>
#include <apart/core/editor/level_edit.hpp>
#include <apart/core/tuning.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace apart {

using kodo::Real;
using kodo::Vec2;

namespace {

constexpr std::int32_t kCellAcross = static_cast<std::int32_t>(kCellWidth * 1000);
constexpr std::int32_t kCellUp = static_cast<std::int32_t>(kCellHeight * 1000 + Real(0.5));
constexpr std::int32_t kHalfField = static_cast<std::int32_t>(kFieldWidth * 500);
constexpr std::int32_t kFieldTop = static_cast<std::int32_t>(kFieldHeight * 1000);

std::int32_t toThousandth(Real metres) {
    return static_cast<std::int32_t>(std::lround(metres * 1000));
}

bool isInGrid(const ObstructionDef& def) {
    return def.kind != ObstructionKind::Ledge && def.kind != ObstructionKind::Ground;
}

/// The multiple of `cell` nearest to a way, so that an index from 0 to `count` - 1 stays one.
int cellsOf(std::int32_t way, std::int32_t cell, int index, int count) {
    const auto cells =
        static_cast<int>(std::lround(static_cast<Real>(way) / static_cast<Real>(cell)));
    return std::clamp(index + cells, 0, count - 1) - index;
}

bool moves(const Level& level, std::int32_t block) {
    const std::uint8_t kind = level.freeBlocks[static_cast<std::size_t>(block)].kind;
    return level.kinds[kind].support != Support::Mounted;
}

/// Removes entries by index; returns the new index of each, -1 for a removed one.
template <typename T>
std::vector<std::int32_t> removeAll(std::vector<T>& all, const LevelParts& parts,
                                    LevelPart::Of of) {
    std::vector<std::int32_t> places;
    std::vector<T> left;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool gone = std::find(parts.begin(), parts.end(), LevelPart{of, i}) != parts.end();
        places.push_back(gone ? -1 : static_cast<std::int32_t>(left.size()));
        if (!gone) {
            left.push_back(all[i]);
        }
    }
    all = std::move(left);
    return places;
}

bool has(std::span<const LevelPart> parts, LevelPart::Of of, std::int32_t index) {
    return index >= 0 && std::find(parts.begin(), parts.end(),
                                   LevelPart{of, static_cast<std::size_t>(index)}) != parts.end();
}

void moveLinks(Level& level, std::span<const LevelPart> parts, EditStep step) {
    for (std::size_t i = 0; i < level.links.size(); ++i) {
        LinkDef& link = level.links[i];
        const bool line = link.kind == LinkKind::Rope || link.kind == LinkKind::Spring;
        const bool taken = has(parts, LevelPart::Of::Link, static_cast<std::int32_t>(i));
        const bool end = taken || has(parts, LevelPart::Of::Block, link.b);
        const bool start = line ? taken || has(parts, LevelPart::Of::Block, link.a) : end;
        link.fromX += start ? step.x : 0;
        link.fromY += start ? step.y : 0;
        link.toX += end ? step.x : 0;
        link.toY += end ? step.y : 0;
    }
}

/// A place for the end of a joint: the middle of the block there if it is near, else on the grid.
Vec2 anchorAt(const Level& level, Vec2 place) {
    constexpr Real kNear = Real(0.2); // m
    if (const std::optional<std::size_t> block = blockAt(level, place)) {
        const Vec2 middle = placedShapeOf(level.freeBlocks[*block]).frame.position;
        if (length(middle - place) < kNear) {
            return middle;
        }
    }
    const auto toGrid = [](Real at) {
        return std::round(at * 1000 / Real(kSnapGrid)) * Real(kSnapGrid) / 1000;
    };
    return {toGrid(place.x), toGrid(place.y)};
}

} // namespace

Level moved(Level level, std::span<const LevelPart> parts, EditStep step) {
    const auto shift = [&](auto& thing) {
        thing.x += step.x;
        thing.y += step.y;
    };
    for (const LevelPart part : parts) {
        switch (part.of) {
        case LevelPart::Of::Block:
            shift(level.freeBlocks[part.index]);
            break;
        case LevelPart::Of::Water:
            shift(level.waters[part.index]);
            break;
        case LevelPart::Of::Well:
            shift(level.wells[part.index]);
            break;
        case LevelPart::Of::Cell: {
            Cell& cell = level.cells[part.index];
            const int right = cellsOf(step.x, kCellAcross, cell.column, kColumns);
            const int down = cellsOf(-step.y, kCellUp, cell.row, kMostRows);
            cell.column = static_cast<std::uint8_t>(cell.column + right);
            cell.row = static_cast<std::uint8_t>(cell.row + down);
            break;
        }
        case LevelPart::Of::Obstruction: {
            ObstructionDef& def = level.obstructions[part.index];
            if (!def.points.empty()) {
                std::for_each(def.points.begin(), def.points.end(), shift);
                break;
            }
            if (!isInGrid(def)) {
                shift(def);
                break;
            }
            const int column = (def.x + kHalfField) / kCellAcross;
            const int row = (kFieldTop - def.y) / kCellUp;
            def.x += kCellAcross * cellsOf(step.x, kCellAcross, column, kColumns);
            def.y -= kCellUp * cellsOf(-step.y, kCellUp, row, kMostRows);
            break;
        }
        case LevelPart::Of::Link:
            break; // below
        }
    }
    moveLinks(level, parts, step);
    return level;
}

Level without(Level level, LevelParts parts) {
    for (std::size_t i = 0; i < level.links.size(); ++i) {
        const LinkDef& link = level.links[i];
        if (has(parts, LevelPart::Of::Block, link.a) || has(parts, LevelPart::Of::Block, link.b)) {
            parts.push_back({LevelPart::Of::Link, i});
        }
    }
    removeAll(level.links, parts, LevelPart::Of::Link);
    const std::vector<std::int32_t> places =
        removeAll(level.freeBlocks, parts, LevelPart::Of::Block);
    for (LinkDef& link : level.links) {
        link.a = link.a < 0 ? -1 : places[static_cast<std::size_t>(link.a)];
        link.b = places[static_cast<std::size_t>(link.b)];
    }
    if (level.keep >= 0) {
        level.keep = places[static_cast<std::size_t>(level.keep)];
        level.keepName = level.keep < 0 ? "" : level.keepName;
    }
    removeAll(level.cells, parts, LevelPart::Of::Cell);
    removeAll(level.obstructions, parts, LevelPart::Of::Obstruction);
    removeAll(level.waters, parts, LevelPart::Of::Water);
    removeAll(level.wells, parts, LevelPart::Of::Well);
    return level;
}

Level withMirrorImages(Level level, std::span<const LevelPart> parts) {
    std::vector<std::int32_t> images(level.freeBlocks.size(), -1); // index by index
    const Level before = level;
    for (const LevelPart part : parts) {
        if (part.of == LevelPart::Of::Block) {
            FreeBlock image = before.freeBlocks[part.index];
            image.x = -image.x;
            image.turn = -image.turn;
            const bool sides = image.form == Form::Wedge || image.form == Form::L;
            image.mirrored = sides != image.mirrored;
            images[part.index] = static_cast<std::int32_t>(level.freeBlocks.size());
            level.freeBlocks.push_back(image);
        } else if (part.of == LevelPart::Of::Obstruction &&
                   !isInGrid(before.obstructions[part.index])) {
            level.obstructions.push_back(mirrorImage(before.obstructions[part.index]));
        }
    }
    for (const LinkDef& link : before.links) {
        const std::int32_t a = link.a < 0 ? -1 : images[static_cast<std::size_t>(link.a)];
        const std::int32_t b = images[static_cast<std::size_t>(link.b)];
        if (b < 0 || (link.a >= 0 && a < 0)) {
            continue;
        }
        LinkDef image = link;
        image.a = a;
        image.b = b;
        image.fromX = -link.fromX;
        image.toX = -link.toX;
        image.axis = -link.axis;
        image.speed = -link.speed;
        if (link.kind != LinkKind::Slider) {
            image.low = -link.high;
            image.high = -link.low;
        } else { // its axis points the other way
            image.axis = (link.axis > 0 ? 180000 : -180000) - link.axis;
        }
        level.links.push_back(image);
    }
    return level;
}

Level turned(Level level, std::span<const LevelPart> parts, std::int32_t by) {
    constexpr std::int32_t kFull = 360000; // 1/1000 degree
    for (const LevelPart part : parts) {
        if (part.of == LevelPart::Of::Block) {
            std::int32_t& turn = level.freeBlocks[part.index].turn;
            turn = (turn + by) % kFull;
        } else if (part.of == LevelPart::Of::Obstruction &&
                   level.obstructions[part.index].kind == ObstructionKind::Ledge) {
            std::int32_t& turn = level.obstructions[part.index].turn;
            turn = (turn + by) % kFull;
        }
    }
    return level;
}

Level flipped(Level level, std::span<const LevelPart> parts) {
    for (const LevelPart part : parts) {
        if (part.of == LevelPart::Of::Block) {
            level.freeBlocks[part.index].mirrored = !level.freeBlocks[part.index].mirrored;
        } else if (hasOutline(level, part)) {
            ObstructionDef& ground = level.obstructions[part.index];
            ground = flippedGround(ground);
        }
    }
    return level;
}

BlockKind standingKind(Stuff stuff, Support support) {
    const auto index = static_cast<std::size_t>(stuff);
    BlockKind kind{.stuff = stuff, .pattern = kUsualPattern[index], .support = support};
    kind.strength = kind.breakable() ? kStrength[index] : 0;
    return kind;
}

Level withBlock(Level level, const BlockKind& kind, FreeBlock block) {
    for (std::size_t i = 0; i < level.kinds.size(); ++i) {
        BlockKind other = level.kinds[i];
        other.letter = kind.letter;
        if (other == kind) {
            block.kind = static_cast<std::uint8_t>(i);
            level.freeBlocks.push_back(block);
            return level;
        }
    }
    constexpr std::string_view kLetters = "gwbstGWBSTacdefhijklmnopqruvxyzACDEFHIJKLMNOPQRUVXYZ";
    const auto isFree = [&](char letter) {
        return std::none_of(level.kinds.begin(), level.kinds.end(),
                            [&](const BlockKind& other) { return other.letter == letter; });
    };
    BlockKind added = kind;
    const std::string_view first =
        kind.support == Support::Standing ? kLetters.substr(0, 5) : kLetters.substr(5, 5);
    added.letter = first[static_cast<std::size_t>(kind.stuff)];
    if (!isFree(added.letter)) {
        const auto found = std::find_if(kLetters.begin(), kLetters.end(), isFree);
        added.letter = found == kLetters.end() ? '?' : *found;
    }
    // The reader finds kinds by the order of their letters.
    const auto place =
        std::find_if(level.kinds.begin(), level.kinds.end(),
                     [&](const BlockKind& other) { return other.letter > added.letter; });
    const auto index = static_cast<std::uint8_t>(place - level.kinds.begin());
    level.kinds.insert(place, added);
    for (Cell& cell : level.cells) {
        cell.kind = static_cast<std::uint8_t>(cell.kind + (cell.kind >= index ? 1 : 0));
    }
    for (FreeBlock& other : level.freeBlocks) {
        other.kind = static_cast<std::uint8_t>(other.kind + (other.kind >= index ? 1 : 0));
    }
    for (WaterDef& water : level.waters) {
        water.dam += water.dam >= static_cast<std::int32_t>(index) ? 1 : 0;
    }
    block.kind = index;
    level.freeBlocks.push_back(block);
    return level;
}

Level withLedge(Level level, Vec2 place, std::int32_t width) {
    ObstructionDef ledge;
    ledge.kind = ObstructionKind::Ledge;
    ledge.x = toThousandth(place.x);
    ledge.y = toThousandth(place.y);
    ledge.size = width;
    ledge.height = 400;
    level.obstructions.push_back(ledge);
    return level;
}

std::optional<Level> withRope(Level level, Vec2 from, Vec2 to, bool free) {
    constexpr Real kUpright = Real(0.2); // m; a rope that is nearly upright is upright
    from = free ? from : anchorAt(level, from);
    to = free ? to : anchorAt(level, to);
    if (!free && std::abs(from.x - to.x) < kUpright) {
        (blockAt(level, to) ? from.x : to.x) = blockAt(level, to) ? to.x : from.x;
    }
    std::vector<std::int32_t> first = blocksAt(level, from);
    std::vector<std::int32_t> second = blocksAt(level, to);
    if (second.empty() || !moves(level, second.front())) {
        std::swap(first, second);
        std::swap(from, to);
    }
    if (second.empty() || !moves(level, second.front()) ||
        (!first.empty() && first.front() == second.front())) {
        return std::nullopt;
    }
    LinkDef rope{.kind = LinkKind::Rope};
    rope.a = first.empty() ? -1 : first.front();
    rope.b = second.front();
    rope.fromX = toThousandth(from.x);
    rope.fromY = toThousandth(from.y);
    rope.toX = toThousandth(to.x);
    rope.toY = toThousandth(to.y);
    level.links.push_back(rope);
    return level;
}

std::optional<Level> withPin(Level level, Vec2 place, std::span<const LevelPart> chosen,
                             bool free) {
    place = free ? place : anchorAt(level, place);
    std::vector<std::int32_t> found;
    for (const LevelPart part : chosen) {
        if (part.of == LevelPart::Of::Block) {
            found.push_back(static_cast<std::int32_t>(part.index));
        }
    }
    // The latest first; total order: indices differ.
    std::sort(found.begin(), found.end(), std::greater<>());
    if (chosen.size() != 2 || found.size() != 2) {
        found = blocksAt(level, place);
    }
    const auto last = std::find_if(found.begin(), found.end(),
                                   [&](std::int32_t block) { return moves(level, block); });
    if (last == found.end()) {
        return std::nullopt;
    }
    LinkDef pin{.kind = LinkKind::Pin, .b = *last};
    found.erase(last);
    pin.a = found.empty() ? -1 : found.front();
    pin.fromX = pin.toX = toThousandth(place.x);
    pin.fromY = pin.toY = toThousandth(place.y);
    level.links.push_back(pin);
    return level;
}

} // namespace apart
