// SPDX-License-Identifier: MIT
#include <apart/core/editor/size_edit.hpp>
#include <apart/core/field.hpp>

#include <algorithm>

namespace apart {

namespace {

/// The ways of two opposite edges outwards (1/1000 m).
struct Edges {
    std::int32_t low = 0;
    std::int32_t high = 0;

    std::int32_t sum() const { return low + high; }
};

/// The ways of the edges for so much more size.
Edges edgesFor(std::int32_t more, Edges room) {
    if (more < 0 && (room.low == 0) != (room.high == 0)) {
        return room.low == 0 ? Edges{0, more} : Edges{more, 0};
    }
    if (more <= 0) {
        return {more / 2, more / 2};
    }
    Edges edges;
    edges.low = std::min(more / 2, room.low);
    edges.high = std::min(more - edges.low, room.high);
    edges.low = std::min(more - edges.high, room.low);
    (edges.low > edges.high ? edges.low : edges.high) -= edges.sum() % 2; // the middle is a place
    return edges;
}

bool isUpright(const Level& level, LevelPart part) {
    constexpr std::int32_t kHalf = 180000; // 1/1000 degree
    return part.of == LevelPart::Of::Block ? level.freeBlocks[part.index].turn % kHalf == 0
                                           : part.of == LevelPart::Of::Obstruction &&
                                                 level.obstructions[part.index].turn % kHalf == 0;
}

EditStep sizeOf(const Level& level, LevelPart part) {
    if (part.of == LevelPart::Of::Block) {
        return {level.freeBlocks[part.index].width, level.freeBlocks[part.index].height};
    }
    return {level.obstructions[part.index].size, level.obstructions[part.index].height};
}

} // namespace

FreeBlock resized(FreeBlock block, EditStep by) {
    const auto grown = [](std::int32_t size, std::int32_t more) {
        constexpr std::int32_t kLeast = 100; // 1/1000 m
        return std::max(size + more, kLeast);
    };
    if (isRound(block.form)) {
        block.width = block.height = grown(block.width, by.x + by.y);
    } else if (block.form != Form::Voussoir) {
        block.width = grown(block.width, by.x);
        block.height = grown(block.height, by.y);
    }
    return block;
}

Level resized(Level level, std::span<const LevelPart> parts, EditStep by) {
    for (const LevelPart part : parts) {
        if (part.of == LevelPart::Of::Block) {
            level.freeBlocks[part.index] = resized(level.freeBlocks[part.index], by);
        } else if (part.of == LevelPart::Of::Obstruction &&
                   level.obstructions[part.index].kind == ObstructionKind::Ledge) {
            ObstructionDef& ledge = level.obstructions[part.index];
            ledge.size = std::max(ledge.size + by.x, 100);
            ledge.height = std::max(ledge.height + by.y, 100);
        }
    }
    return level;
}

Level resizedToContact(const Level& level, LevelPart part, EditStep by) {
    Level after = resized(level, {&part, 1}, by);
    if (after == level || !isUpright(level, part)) {
        return after;
    }
    const EditStep before = sizeOf(level, part);
    const EditStep plain = sizeOf(after, part);
    const Gaps gaps = gapsBeside(level, part);
    Edges x = edgesFor(plain.x - before.x, {gaps.left, gaps.right});
    Edges y = edgesFor(plain.y - before.y, {gaps.below, gaps.above});
    if (part.of == LevelPart::Of::Block && isRound(level.freeBlocks[part.index].form)) {
        const std::int32_t both = std::min(x.sum(), y.sum());
        x = edgesFor(both, {gaps.left, gaps.right});
        y = edgesFor(both, {gaps.below, gaps.above});
        after = resized(level, {&part, 1}, {both, 0});
    } else {
        after = resized(level, {&part, 1}, {x.sum(), y.sum()});
    }
    const auto shift = [&](auto& thing) {
        thing.x += (x.high - x.low) / 2;
        thing.y += (y.high - y.low) / 2;
    };
    if (part.of == LevelPart::Of::Block) {
        shift(after.freeBlocks[part.index]); // ends of joints stay where they are
    } else {
        shift(after.obstructions[part.index]);
    }
    return after;
}

} // namespace apart
