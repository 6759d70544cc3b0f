// SPDX-License-Identifier: MIT
// Optional words of a level: holds, obstructions, hills, wells and paddles that are not rigid.
#include "level_texts.hpp"

namespace {

using namespace apart;

const std::string kRich = R"(format = 1
title = "Test"
idea = "An idea."
ball = "egg"
paddle = "loose"
wind = -3000
boss = { drift = 2000, speed = 1500 }
grid = '''
h....x.c.x....X
.o...........g.
'''
[legend.h]
stuff = "brick"
hold = "hanging"
arm = 1200
pattern = "radial"
[legend.x]
stuff = "steel"
hold = "boss"
[legend.c]
stuff = "stone"
hold = "boss"
core = true
[legend.X]
obstruction = "motor"
speed = -2500
[legend.o]
obstruction = "bumper"
size = 650
[legend.g]
obstruction = "gate"
facing = "left"
[[ground]]
x = -12000
y = 100
spacing = 2000
heights = [900, 300, 0]
[[ground]]
points = [[-4000, 4000], [-1000, 3000], [-2000, 5000]]
turf = "sand"
mirror = true
[[well]]
x = 100
y = 9000
strength = -60000
)";

std::string with(const std::string& before, const std::string& after) {
    return changed(kRich, before, after);
}

TEST(LevelWords, AreParsedIntoALevel) {
    ASSERT_EQ(problemOf(kRich), "none");
    const Level level = std::get<Level>(parseLevel(kRich, "test", "test.toml"));
    EXPECT_EQ(level.ball, BallKind::Egg);
    EXPECT_EQ(level.paddle, PaddleKind::Loose);
    EXPECT_EQ(level.wind, -3000);
    EXPECT_EQ(level.bossDrift, 2000);
    EXPECT_EQ(level.bossSpeed, 1500);
    const BlockKind& hanging = level.kinds[level.cells[0].kind];
    EXPECT_EQ(hanging.support, Support::Hanging);
    EXPECT_EQ(hanging.arm, 1200);
    EXPECT_EQ(hanging.pattern, Pattern::Radial);
    EXPECT_TRUE(level.kinds[level.cells[2].kind].core);
    ASSERT_EQ(level.obstructions.size(), 6u); // those of the grid first, row by row
    EXPECT_EQ(level.obstructions[0].kind, ObstructionKind::Motor);
    EXPECT_EQ(level.obstructions[0].speed, -2500);
    EXPECT_EQ(level.obstructions[0].x, 11200); // centre of column 14
    EXPECT_EQ(level.obstructions[0].y, 17600); // centre of row 0
    EXPECT_EQ(level.obstructions[1].size, 650);
    EXPECT_EQ(level.obstructions[2].facing, Facing::Left);
    EXPECT_EQ(level.obstructions[2].size, 800); // height of its cell
    EXPECT_EQ(level.obstructions[3].kind, ObstructionKind::Ground);
    EXPECT_EQ(level.obstructions[3].heights, (std::vector<std::int32_t>{900, 300, 0}));
    const std::vector<GroundPoint> left{{-4000, 4000}, {-1000, 3000}, {-2000, 5000}};
    const std::vector<GroundPoint> right{{2000, 5000}, {1000, 3000}, {4000, 4000}};
    EXPECT_EQ(level.obstructions[4].points, left);
    EXPECT_EQ(level.obstructions[4].turf, Turf::Sand);
    EXPECT_EQ(level.obstructions[5].points, right);
    ASSERT_EQ(level.wells.size(), 1u);
    EXPECT_EQ(level.wells[0].strength, -60000);
}

TEST(LevelWords, AreRefusedByLineIfInvalid) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {with("\"egg\"", "\"eg\""), "test.toml:4: ball must be one of round, heavy"},
        {with("\"loose\"", "1"), "test.toml:5: paddle must be one of steady"},
        {with("-3000", "-30001"), "test.toml:6: wind must be a whole number from -30000"},
        {with("speed = 1500 }", "seed = 1500 }"), "test.toml:7: unknown key boss.seed"},
        {with("drift = 2000, ", ""), "test.toml:7: the key drift is missing"},
        {with("core = true\n", ""), "test.toml:1: the boss needs a block with core = true"},
        {with("core = true", "core = 1"), "test.toml:23: core must be true or false"},
        {with("hold = \"hanging\"\n", ""), "test.toml:12: legend.h.arm is for a block with hold"},
        {with("arm = 1200", "arm = 100"), "test.toml:15: arm must be a whole number from 400"},
        {with("stuff = \"stone\"", "stuff = \"steel\""), "test.toml:20: legend.c.core is for"},
        {with("\"motor\"", "\"ground\""), "test.toml:25: obstruction must be one of bumper, pin"},
        {with("size = 650", "stuff = \"brick\""), "test.toml:29: unknown key legend.o.stuff"},
        {with("\"left\"", "\"west\""), "test.toml:32: facing must be one of up, down"},
        {with("heights = [900, 300, 0]", "heights = [900]"),
         "test.toml:37: heights must be a list"},
        {with("[900, 300, 0]", "[900, -1, 0]"), "test.toml:37: each of heights must be"},
        {with("[-2000, 5000]]", "]"), "test.toml:39: points must be a list of 3 to 64 corners"},
        {with("[-2000, 5000]", "[-2000, 2999]"), "test.toml:39: each of points must be two whole"},
        {with("[-2000, 5000]", "[13001, 5000]"), "test.toml:39: each of points must be two whole"},
        {with("[-2000, 5000]", "[-2000, 5000, 0]"), "test.toml:39: each of points must be two"},
        {with("[-2000, 5000]]", "[-2000, 5000], [-3000, 3000]]"),
         "test.toml:39: the outline of points crosses or touches itself"},
        {with("\"sand\"", "\"mud\""), "test.toml:40: turf must be one of grass, rock, sand"},
        {with("turf = \"sand\"", "x = 0"), "test.toml:40: unknown key ground.x"},
        {with("[[well]]", "[well]"), "test.toml:42: well must be tables [[well]]"},
        {with("strength = -60000", ""), "test.toml:42: the key strength is missing"},
    };
    for (const auto& [text, start] : cases) {
        const std::string problem = problemOf(text);
        EXPECT_EQ(problem.substr(0, start.size()), start) << problem;
    }
}

TEST(LevelWords, AreAllInTheDigest) {
    const Level level = std::get<Level>(parseLevel(kRich, "test", "test.toml"));
    const std::vector<std::pair<std::string, std::string>> changes = {
        {"\"egg\"", "\"round\""},
        {"\"loose\"", "\"steady\""},
        {"-3000", "-3001"},
        {"drift = 2000", "drift = 1"},
        {"speed = 1500", "speed = 1"},
        {"arm = 1200", "arm = 1201"},
        {"\"radial\"", "\"slats\""},
        {"size = 650", "size = 651"},
        {"\"left\"", "\"right\""},
        {"spacing = 2000", "spacing = 2001"},
        {"[900, 300, 0]", "[900, 300, 1]"},
        {"-60000", "-60001"}};
    for (const auto& [before, after] : changes) {
        const std::string text = with(before, after);
        ASSERT_EQ(problemOf(text), "none");
        EXPECT_NE(digestOf(std::get<Level>(parseLevel(text, "test", "test.toml"))), digestOf(level))
            << before;
    }
}

} // namespace
