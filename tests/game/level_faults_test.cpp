// SPDX-License-Identifier: MIT
// Every fault of a level file is named once, and none that follows from another one.
#include <game/level_texts.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace apart;
using Faults = std::vector<std::string>;

/// All faults of a text, without the name of the file.
Faults faultsOf(const std::string& text) {
    const Read<Level> level = parseLevel(text, "test", "t");
    const auto* problem = std::get_if<FileProblem>(&level);
    Faults faults = problem != nullptr ? problem->texts() : Faults{};
    for (std::string& fault : faults) {
        fault.erase(0, 2);
    }
    return faults;
}

const std::string kTitle = "format = 1\ntitle = \"t\"\nidea = \"i\"\n";                // 3 lines
const std::string kLegend = "[legend.b]\nstuff = \"brick\"\nhold = \"standing\"\n";    // 3 lines
const std::string kSound = "[[block]]\nkind = \"b\"\nname = \"q\"\nx = 0\ny = 7000\n"; // 5 lines

std::string jointTo(const std::string& name) {
    return "[[joint]]\nkind = \"pin\"\nat = [0, 7000]\nb = \"" + name + "\"\n";
}

TEST(LevelFile, NamesEachBadRowOfItsGrid) {
    const std::string grid =
        "grid = '''\n.........\n.....................\n...Q....\xc3\xbc...Q..\n"
        "..b............\n..Q............\n'''\n";
    EXPECT_EQ(faultsOf("format = 1\ntitle = 7\nidea = \"i\"\ngravity = 3\n" + grid +
                       "[legend.b]\nstuff = \"brick\"\n"),
              (Faults{"2: title must be a text of 1 to 160 bytes", "4: unknown key gravity",
                      "6: a row of the grid has 15 letters, not 9",
                      "7: a row of the grid has 15 letters, not 21",
                      "8: the letter Q is not in the legend; also in line 10",
                      "8: the letter \xc3\xbc is not in the legend"}));
    EXPECT_EQ(faultsOf(kTitle + "grid = '''......Q........'''\n" + kLegend + kSound),
              Faults{"4: the letter Q is not in the legend"})
        << "a grid that begins in the line of its key";
    EXPECT_EQ(faultsOf(kTitle + "grid = '''\nb..............\nlives = 3\n'''\n" + kLegend),
              Faults{"6: a row of the grid has 15 letters, not 9"})
        << "a line that is no row";
    EXPECT_EQ(faultsOf(kTitle + "grid = '''\nlives = 3333333\n'''\n" + kLegend + kSound),
              Faults{"5: more than 3 letters of this row are not in the legend"});
    EXPECT_EQ(faultsOf(kTitle + "grid = 5\n" + kLegend),
              Faults{"4: grid must be a text '''...'''"});
    EXPECT_EQ(faultsOf(kTitle + "legend = 5\n" + kSound),
              Faults{"4: legend must be tables [legend.X]"});
}

TEST(LevelFile, WithoutAnyBlockNamesBothWaysToGiveOne) {
    const Faults faults = faultsOf(kTitle + kLegend);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].find("the level has no block: tables [[block]] or "), std::string::npos)
        << faults[0];
    EXPECT_NE(faults[0].find("grid = '''...'''"), std::string::npos) << faults[0];
}

TEST(LevelFile, NamesEachFaultOfItsBuilding) {
    EXPECT_EQ(faultsOf(kTitle + kLegend + kSound + jointTo("n1") + jointTo("n2") + jointTo("n3") +
                       "count = 4\n" + jointTo("n1")),
              (Faults{"15: there is no block named n1; also in line 28",
                      "19: there is no block named n2", "23: there is no block named n3"}));
    const std::string power = "[legend.p]\nstuff = \"wood\"\npower = \"weld\"\n"; // lines 7 to 9
    EXPECT_EQ(faultsOf(kTitle + kLegend + power + kSound + kSound +
                       "turn = 999999\n[[block]]\nkind = \"p\"\nshape = \"gable\"\nx = 0\n"
                       "y = 7000\n[[block]]\nkind = \"b\"\nx = 0\ny = 7000\ncount = 60\n"
                       "rows = 60\n" +
                       jointTo("n1")),
              (Faults{"15: there are two blocks named q",
                      "20: turn must be a whole number from -360000 to 360000",
                      "21: a block with a power is a brick, beam, plank or square",
                      "26: there are more than 240 blocks of [[block]]",
                      "35: there is no block named n1"}));
}

TEST(LevelFile, NamesNoFaultThatFollowsFromAnother) {
    const std::string use = kSound + jointTo("q") +
                            "[[water]]\nx = 0\ny = 9000\nwidth = 900\n"
                            "depth = 900\ndam = \"b\"\n";
    const auto withLegend = [&](const std::string& keys) {
        return faultsOf(kTitle + "[legend.b]\n" + keys + use);
    };
    EXPECT_EQ(withLegend("stuff = \"brik\"\nhold = \"standing\"\n"),
              Faults{"5: stuff must be one of glass, wood, brick, stone, steel"});
    EXPECT_EQ(withLegend("stuf = \"brick\"\nhold = \"standing\"\n"),
              Faults{"5: unknown key legend.b.stuf"});
    EXPECT_EQ(withLegend("hold = \"standing\"\n"), Faults{"4: legend.b.stuff is missing"});
    EXPECT_EQ(withLegend("stuff = \"brick\"\nhold = \"floating\"\n"),
              Faults{"6: hold must be one of mounted, hanging, boss, standing, moving"});
    EXPECT_EQ(withLegend("obstruction = \"pit\"\n"),
              Faults{"5: obstruction must be one of bumper, pin, motor, gate"});
    EXPECT_EQ(faultsOf(kTitle + use),
              Faults{"1: the tables [legend.X] are missing: one for each letter of the grid"});
    EXPECT_EQ(withLegend("obstructon = \"pin\"\nsize = 300\n"),
              Faults{"5: unknown key legend.b.obstructon"});
    EXPECT_EQ(faultsOf(kTitle + "grid = '''\nb.....o........\n'''\n" + kLegend +
                       "[legnd.o]\nobstruction = \"pin\"\n"),
              Faults{"10: unknown key legnd"});
    const auto withBlock = [&](const std::string& before, const std::string& after) {
        return faultsOf(kTitle + kLegend + changed(use, before, after));
    };
    EXPECT_EQ(withBlock("name = \"q\"", "name = 5"),
              Faults{"9: name must be a text of 1 to 160 bytes"});
    EXPECT_EQ(withBlock("\"b\"", "\"z\""),
              Faults{"7: kind must be the letter of a block in the legend"});
    EXPECT_EQ(withBlock("x = 0", "x = 0\ncount = 99"),
              Faults{"11: count must be a whole number from 1 to 60"});
    EXPECT_EQ(withBlock("x = 0", "x = 99999"),
              Faults{"10: x must be a whole number from -12000 to 12000"});
    EXPECT_EQ(withBlock("name", "nme"), Faults{"9: unknown key block.nme"});
    EXPECT_EQ(faultsOf(kTitle + changed(kLegend, "hold", "hQld") + use),
              Faults{"6: unknown key legend.b.hQld"});
    EXPECT_EQ(withBlock("[[block]]", "[[blok]]"), Faults{"7: unknown key blok"});
    EXPECT_EQ(withBlock("\"pin\"", "\"pim\""),
              Faults{"13: kind must be one of pin, rope, spring, slider, motor"});
}

TEST(LevelFile, NamesTheFirst20FaultsAndTheNumberOfTheOthers) {
    std::string text = kTitle;
    for (int i = 0; i < 50; ++i) {
        text += "surplus" + std::to_string(i) + " = 1\n";
    }
    const Faults faults = faultsOf(text + kLegend + kSound);
    ASSERT_EQ(faults.size(), 21u);
    EXPECT_EQ(faults[0], "4: unknown key surplus0");
    EXPECT_EQ(faults[19], "23: unknown key surplus19");
    EXPECT_EQ(faults[20], " and 30 more");
}

TEST(BuildingFile, CountsLedgesBlocksAndJointsOfTheWholeLevel) {
    const std::string ledges = "[[ledge]]\nx = 200\ny = 5000\nwidth = 100\ncount = 17\n"
                               "step = [100, 0]\nmirror = true\n"; // 34
    EXPECT_EQ(faultsOf(kTitle + kLegend + kSound + ledges), Faults{});
    EXPECT_EQ(faultsOf(kTitle + kLegend + kSound + ledges + ledges + ledges),
              Faults{"19: there are more than 64 ledges"});
    const std::string blocks =
        "[[block]]\nkind = \"b\"\nx = -6000\ny = 9000\nwidth = 200\n"
        "count = 60\nstep = [200, 0]\nrows = 3\nrow-step = [0, 800]\n"; // 180
    EXPECT_EQ(faultsOf(kTitle + kLegend + blocks), Faults{});
    EXPECT_EQ(faultsOf(kTitle + kLegend + blocks + blocks + blocks),
              Faults{"16: there are more than 240 blocks of [[block]]"});
    const std::string joints = jointTo("q") + "count = 60\n";
    EXPECT_EQ(faultsOf(kTitle + kLegend + kSound + joints + joints + joints + joints),
              Faults{"22: there are more than 120 joints"});
}

TEST(BuildingFile, IsRefusedIfABlockIsNotWithinTheField) {
    const std::string also = ": the whole block lies within the field";
    const auto with = [&](const std::string& keys) {
        return faultsOf(kTitle + kLegend + "[[block]]\nkind = \"b\"\n" + keys);
    };
    EXPECT_EQ(with("x = 0\ny = -17000\n"), Faults{"10: y must be a whole number from 0 to 18000"});
    EXPECT_EQ(with("x = 11201\ny = 399\n"),
              (Faults{"9: x is 11201, but must be from -11200 to 11200" + also,
                      "10: y is 399, but must be from 400 to 17600" + also}));
    EXPECT_EQ(with("x = 11200\ny = 17600\n"), Faults{});
    EXPECT_EQ(with("x = 11600\ny = 800\nturn = 90000\nmirror = true\n"), Faults{});
    EXPECT_EQ(with("x = 11600\ny = 799\nturn = 90000\n"),
              Faults{"10: y is 799, but must be from 800 to 17200" + also});
    EXPECT_EQ(with("x = 10000\ny = 1000\ncount = 3\nstep = [-2000, 9000]\nmirror = true\n"),
              Faults{"10: y of copy 3 is 19000, but must be from 400 to 17600" + also});
    EXPECT_EQ(with("shape = \"round\"\nx = 0\ny = 17601\n"),
              Faults{"11: y is 17601, but must be from 400 to 17600" + also});
    EXPECT_EQ(with("shape = \"voussoir\"\nx = 0\ny = -2000\nradius = 3000\nspan = 30000\n"),
              Faults{});
    EXPECT_EQ(with("shape = \"voussoir\"\nx = 0\ny = -3000\nradius = 3000\nspan = 30000\n"),
              Faults{"11: y is -3000, but must be from -2898 to 14329" + also});
    EXPECT_EQ(with("x = 0\ny = 9000\nwidth = 24000\nturn = 90000\n"),
              Faults{"7: the block is larger than the field"});
}

TEST(BuildingFile, IsRefusedIfACopyOfALedgeOrJointIsOutsideTheField) {
    const std::string ledge =
        "[[ledge]]\nx = 0\ny = 5000\nwidth = 900\ncount = 4\nstep = [5000, 0]\n";
    EXPECT_EQ(faultsOf(kTitle + kLegend + kSound + ledge),
              Faults{"13: x of copy 4 is 15000, but must be from -12000 to 12000"});
    EXPECT_EQ(faultsOf(kTitle + kLegend + kSound + jointTo("q") + "count = 2\nstep = [0, 24000]\n"),
              Faults{"14: y in at of copy 2 is 31000, but must be from -18000 to 18000"});
}

TEST(BuildingFile, IsRefusedIfMoreThan20BlocksAreAtOnePlace) {
    const std::string crowd = "[[block]]\nkind = \"b\"\nx = 0\ny = 8000\nwidth = 3000\n"
                              "height = 3000\nstep = [10, 0]\ncount = ";
    EXPECT_EQ(faultsOf(kTitle + kLegend + crowd + "20\n"), Faults{});
    EXPECT_EQ(faultsOf(kTitle + kLegend + crowd + "60\nrows = 3\n"),
              Faults{"7: more than 20 blocks have their middles at one place"});
    EXPECT_EQ(faultsOf(kTitle + kLegend + crowd + "20\n" + kSound +
                       changed(crowd, "x = 0", "x = 5000") + "5\n"),
              Faults{});
}

// The thickness that an L or T has by default is checked as well.
TEST(BuildingFile, IsRefusedIfAnLIsThickerThanItsSize) {
    const auto with = [&](const std::string& keys) {
        return faultsOf(kTitle + kLegend + kSound +
                        "[[block]]\nkind = \"b\"\nx = 0\ny = 9000\nshape = \"L\"\n" + keys);
    };
    EXPECT_EQ(with("width = 300\n"), Faults{"12: thick must be a whole number from 100 to 200"});
    EXPECT_EQ(with("width = 100\n"),
              Faults{"12: width and height of an L or T must be at least 200"});
    EXPECT_EQ(with("width = 50\nthick = 500\n"),
              Faults{"17: width must be a whole number from 100 to 24000"});
    EXPECT_EQ(with("width = 300\nthick = 200\n"), Faults{});
}

} // namespace
