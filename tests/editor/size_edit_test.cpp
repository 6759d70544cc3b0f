// SPDX-License-Identifier: MIT
// Sizes of parts whose edges touch something.
#include <apart/core/editor/edit_document.hpp>
#include <apart/core/editor/level_edit.hpp>
#include <apart/core/editor/size_edit.hpp>

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <utility>

namespace apart {
namespace {

using Of = LevelPart::Of;

/// A ledge with its top at 6.2 m, and bricks.
Level onLedge(std::initializer_list<FreeBlock> blocks) {
    Level level = withLedge({}, {0, 6}, 12000);
    for (const FreeBlock& block : blocks) {
        level = withBlock(std::move(level), standingKind(Stuff::Brick), block);
    }
    return level;
}

constexpr FreeBlock oneBrick(std::int32_t x, std::int32_t y) {
    return {.x = x, .y = y, .width = 1600, .height = 800};
}

/// Edges of the first block (1/1000 m): left, right, below, above.
std::array<std::int32_t, 4> edgesOf(const Level& level) {
    const FreeBlock& block = level.freeBlocks[0];
    return {block.x - block.width / 2, block.x + block.width / 2, block.y - block.height / 2,
            block.y + block.height / 2};
}
using Edges = std::array<std::int32_t, 4>;

// Regression: half of the growth went into what the block stands on.
TEST(Sizes, AnEdgeInContactStays) {
    const Level level = onLedge({oneBrick(0, 6600)});
    const LevelPart block{Of::Block, 0};
    EXPECT_EQ(edgesOf(resizedToContact(level, block, {0, 100})), (Edges{-800, 800, 6200, 7100}));
    EXPECT_EQ(edgesOf(resizedToContact(level, block, {0, -100})), (Edges{-800, 800, 6200, 6900}));
    EXPECT_EQ(edgesOf(resizedToContact(level, block, {100, 0})), (Edges{-850, 850, 6200, 7000}));
    const Level pair = onLedge({oneBrick(0, 6600), oneBrick(1600, 6600)});
    EXPECT_EQ(edgesOf(resizedToContact(pair, block, {100, 0})), (Edges{-900, 800, 6200, 7000}));
    EXPECT_EQ(edgesOf(resizedToContact(pair, block, {-100, 0})), (Edges{-700, 800, 6200, 7000}));
}

TEST(Sizes, AGrowingEdgeStopsAtContact) {
    Level level =
        onLedge({oneBrick(0, 6600), oneBrick(1730, 6600), oneBrick(-1900, 6600)}); // 130, 300 mm
    const LevelPart block{Of::Block, 0};
    for (int i = 0; i < 10; ++i) {
        level = resizedToContact(level, block, {100, 0});
    }
    EXPECT_EQ(edgesOf(level), (Edges{-1100, 930, 6200, 7000}));
    EXPECT_EQ(resizedToContact(level, block, {100, 0}), level) << "no room on both sides";
    EXPECT_EQ(edgesOf(resizedToContact(level, block, {-100, 0})), (Edges{-1050, 880, 6200, 7000}));
}

TEST(Sizes, ARoundOneStaysRoundAndOnItsGround) {
    Level level = onLedge({{.form = Form::Round, .x = 0, .y = 6700, .width = 1000, .height = 1000},
                           oneBrick(1500, 6600)}); // 200 mm
    const LevelPart block{Of::Block, 0};
    for (int i = 0; i < 5; ++i) {
        level = resizedToContact(level, block, {0, 100});
        EXPECT_EQ(level.freeBlocks[0].width, level.freeBlocks[0].height);
        EXPECT_EQ(edgesOf(level)[2], 6200);
        EXPECT_LE(edgesOf(level)[1], 700);
    }
    EXPECT_EQ(level.freeBlocks[0].width, 1500);
}

TEST(Sizes, ALedgeGrowsToContactAndATurnedPartAboutItsMiddle) {
    Level level = onLedge({oneBrick(0, 6600)});
    const LevelPart ledge{Of::Obstruction, 0};
    const Level thicker = resizedToContact(level, ledge, {0, 100});
    EXPECT_EQ(thicker.obstructions[0].height, 500);
    EXPECT_EQ(thicker.obstructions[0].y, 5950) << "its top stays below the brick";
    level.freeBlocks[0].turn = 15000;
    EXPECT_EQ(edgesOf(resizedToContact(level, {Of::Block, 0}, {0, 100})),
              (Edges{-800, 800, 6150, 7050}));
    level.freeBlocks[0] = {
        .form = Form::Voussoir, .x = 0, .y = 6600, .width = 2000, .height = 800, .extra = 30000};
    EXPECT_EQ(resizedToContact(level, {Of::Block, 0}, {100, 100}), level);
}

} // namespace
} // namespace apart
