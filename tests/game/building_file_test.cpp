// SPDX-License-Identifier: MIT
// Free blocks, ledges and joints in level files.
#include <apart/core/field.hpp>

#include <game/game_access.hpp>
#include <game/level_texts.hpp>
#include <gtest/gtest.h>

namespace {

using namespace apart;

const std::string kHead = R"(format = 1
title = "t"
idea = "i"
[legend.b]
stuff = "brick"
hold = "standing"
[legend.m]
stuff = "glass"
[legend.c]
stuff = "brick"
hold = "boss"
core = true
[legend.W]
stuff = "wood"
power = "weld"
)";

const std::string kBlock = R"([[block]]
kind = "b"
shape = "beam"
x = 1000
y = 7000
name = "beam"
count = 2
step = [0, 400]
mirror = true
)";

TEST(BuildingFile, CopiesBlocksInRowsAndMirrorsThem) {
    const Level level = levelFrom(kHead + kBlock + "rows = 2\nrow-step = [100, 0]\nturn = 5000\n");
    ASSERT_EQ(level.freeBlocks.size(), 8u);
    EXPECT_EQ(level.freeBlocks[0].width, 3200); // default of a beam
    EXPECT_EQ(level.freeBlocks[0].height, 400);
    EXPECT_EQ(level.freeBlocks[1].y, 7400);
    EXPECT_EQ(level.freeBlocks[3].x, 1100);
    EXPECT_EQ(level.freeBlocks[7].x, -1100);
    EXPECT_EQ(level.freeBlocks[7].turn, -5000);
    EXPECT_TRUE(level.freeBlocks[7].mirrored);
    EXPECT_TRUE(level.cells.empty()); // a level of free blocks needs no grid
}

TEST(BuildingFile, VoussoirsShareTheirRadialSides) {
    const Level level = levelFrom(kHead + R"([[block]]
kind = "b"
shape = "voussoir"
x = 0
y = 7000
radius = 3000
height = 800
span = 30000
turn = 15000
count = 2
step-turn = -30000
)");
    const PlacedShape left = placedShapeOf(level.freeBlocks[0]);
    const PlacedShape right = placedShapeOf(level.freeBlocks[1]);
    const auto& corners = std::get<kodo::Polygon>(left.shape).corners;
    const auto& others = std::get<kodo::Polygon>(right.shape).corners;
    EXPECT_LT(length(left.frame * corners[1] - right.frame * others[0]), 1e-5);
    EXPECT_LT(length(left.frame * corners[2] - right.frame * others[3]), 1e-5);
    EXPECT_NEAR((left.frame * corners[1]).y, 10, 1e-5);
}

TEST(BuildingFile, JointsNameBlocksAndTheirCopies) {
    const Level level = levelFrom(kHead + kBlock + R"([[joint]]
kind = "pin"
a = "beam1"
b = "beam2"
at = [1000, 7200]
break = 5000
count = 3
step = [10, 0]
[[joint]]
kind = "rope"
b = "beam4"
from = [0, 12000]
to = [-1000, 7400]
slack = 300
)");
    ASSERT_EQ(level.links.size(), 4u);
    EXPECT_EQ(level.links[2].a, 2);
    EXPECT_EQ(level.links[2].b, 3);
    EXPECT_EQ(level.links[2].fromX, 1020);
    EXPECT_EQ(level.links[3].a, -1); // the field
    EXPECT_EQ(level.links[3].slack, 300);
}

TEST(BuildingFile, TheDigestCoversBlocksAndJoints) {
    const std::string joint = "[[joint]]\nkind = \"pin\"\nb = \"beam1\"\nat = [0, 7000]\n";
    const std::uint64_t before = digestOf(levelFrom(kHead + kBlock + joint));
    EXPECT_NE(digestOf(levelFrom(kHead + kBlock)), before);
    EXPECT_NE(digestOf(levelFrom(kHead + kBlock + joint + "break = 1\n")), before);
    EXPECT_NE(digestOf(levelFrom(kHead + kBlock + "turn = 1\n" + joint)), before);
}

TEST(BuildingFile, TellsLineAndReasonOfAProblem) {
    const std::string two = kBlock + "[[block]]\nkind = \"b\"\nx = 0\ny = 9000\nname = \"beam1\"\n";
    const std::string joint = "[[joint]]\nkind = \"pin\"\nat = [0, 7000]\n";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {changed(kBlock, "kind = \"b\"", "kind = \"z\""),
         "test.toml:16: kind must be the letter of a block in the legend"},
        {changed(kBlock, "kind = \"b\"", "kind = \"c\""),
         "test.toml:16: a free block has hold = \"mounted\", \"standing\" or \"moving\""},
        {changed(kBlock, "beam\"", "slab\""),
         "test.toml:18: shape must be one of brick, beam, plank, square, wedge, gable, round, "
         "wheel, voussoir, L, T"},
        {changed(kBlock, "step = [0, 400]", "step = [0]"),
         "test.toml:23: step must be two whole numbers from -24000 to 24000"},
        {changed(kBlock, "x = 1000\n", ""), "test.toml:16: the key x is missing"},
        {changed(changed(kBlock, "kind = \"b\"", "kind = \"W\""), "beam\"", "gable\""),
         "test.toml:16: a block with a power is a brick, beam, plank or square"},
        {changed(kBlock, "count = 2", "count = 60") + "rows = 60\n",
         "test.toml:16: there are more than 240 blocks of [[block]]"},
        {two, "test.toml:25: there are two blocks named beam1"},
        {kBlock + joint + "b = \"roof\"\n", "test.toml:28: there is no block named roof"},
        {kBlock + joint + "a = \"beam1\"\nb = \"beam1\"\n",
         "test.toml:25: joint.b is a block that moves, and another one than a"},
        {kBlock + joint + "b = \"beam1\"\nlimits = [3, 2]\n",
         "test.toml:25: limits must be the lower and the upper one"},
        {kBlock + "[[joint]]\nb = \"beam1\"\n", "test.toml:25: joint.kind is missing"},
        {kBlock + "[[ledge]]\nx = 0\ny = 0\n", "test.toml:25: the key width is missing"}};
    for (const auto& [tables, problem] : cases) {
        EXPECT_EQ(problemOf(kHead + tables), problem);
    }
    EXPECT_EQ(problemOf(kHead + kBlock), "none");
}

} // namespace
