// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/tuning.hpp>

#include <set>

#include "level_texts.hpp"

namespace {

using namespace apart;

const std::string kGood = R"(format = 1
place = 3
title = "Test"
idea = "An idea."
grid = '''
...............
..b.........X..
'''
[legend.b]
stuff = "brick"
strength = 7000
power = "weld"
[legend.X]
stuff = "steel"
)";

TEST(LevelFile, IsParsedIntoALevel) {
    const Read<Level> read = parseLevel(kGood, "test", "test.toml");
    ASSERT_EQ(problemOf(kGood), "none");
    const Level& level = std::get<Level>(read);
    EXPECT_EQ(level.name, "test");
    EXPECT_EQ(level.title, "Test");
    EXPECT_EQ(level.place, 3);
    EXPECT_EQ(level.lives, 3);
    ASSERT_EQ(level.cells.size(), 2u);
    EXPECT_EQ(level.cells[0].row, 1);
    EXPECT_EQ(level.cells[0].column, 2);
    const BlockKind& brick = level.kinds[level.cells[0].kind];
    EXPECT_EQ(brick.strength, 7000);
    EXPECT_EQ(brick.power, Power::Weld);
    EXPECT_EQ(brick.pattern, Pattern::Bricks);
    EXPECT_FALSE(level.kinds[level.cells[1].kind].breakable());
}

TEST(LevelFile, NamesTheLineOfAnError) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {changed(kGood, "format = 1", "format = 2"), "test.toml:1: format must be a whole number"},
        {changed(kGood, "place = 3", "plaice = 3"), "test.toml:2: unknown key plaice"},
        {changed(kGood, "place = 3", "place = 3.5"), "test.toml:2: place must be a whole number"},
        {changed(kGood, "title = \"Test\"", "title = 5"), "test.toml:3: title must be a text"},
        {changed(kGood, "title = \"Test\"", "title = \"Test"), "test.toml:3: "},
        {changed(kGood, "..b.........X..", "..b.........X."),
         "test.toml:7: a row of the grid has 15"},
        {changed(kGood, "..b.........X..", "..b.........Y.."), "test.toml:7: the letter Y is not"},
        {changed(kGood, "..b.........X..", "............X.."),
         "test.toml:5: the level holds no block"},
        {changed(kGood, "\"brick\"", "\"brik\""), "test.toml:10: stuff must be one of glass, wood"},
        {changed(kGood, "7000", "0"), "test.toml:11: strength must be a whole number from 1"},
        {changed(kGood, "\"weld\"", "\"wield\""), "test.toml:12: power must be one of none, weld"},
        {changed(kGood, "legend.X", "legend.XX"), "test.toml:13: legend.XX: a letter of the grid"},
        {kGood + "power = \"weld\"\n", "test.toml:13: legend.X.steel"},
        {kGood + "title = \"again\"\n", "test.toml:15: unknown key legend.X.title"},
        {changed(kGood, "place = 3", "format = 1"), "test.toml:2: "},
        {changed(kGood, "place = 3", "lives = 0"), "test.toml:2: lives must be a whole number"},
        {"", "test.toml"},
    };
    for (const auto& [text, start] : cases) {
        const std::string problem = problemOf(text);
        EXPECT_EQ(problem.substr(0, start.size()), start) << problem;
    }
}

TEST(LevelFile, IsRefusedIfItIsTooLarge) {
    EXPECT_NE(problemOf(kGood + std::string(kLargestLevel, '#')), "none");
    std::string rows;
    for (int row = 0; row <= kMostRows; ++row) {
        rows += "...............\n";
    }
    const std::string tall = changed(kGood, "...............\n", rows);
    EXPECT_EQ(problemOf(tall), "test.toml:21: the grid has more than 15 rows");
}

// D3: a key of 40,000 names would overflow the stack of the parser. Dots within texts are no names.
TEST(LevelFile, IsRefusedIfAKeyHasTooManyNames) {
    std::string key = "a";
    for (int i = 0; i < 40000; ++i) {
        key += ".a";
    }
    const Read<Level> read = parseLevel(kGood + key + " = 1\n", "test", "test.toml");
    ASSERT_TRUE(std::holds_alternative<FileProblem>(read));
    EXPECT_EQ(std::get<FileProblem>(read).text(),
              "test.toml:15: a key has more than 16 names, separated by dots");
}

// D5: problems are shown on terminals. Control characters, C1, bidirectional marks and bytes that
// are not UTF-8 become '?'; letters of other languages stay.
TEST(FileProblem, ShowsNoControlCharacters) {
    EXPECT_EQ(printable("a\x1b[2Jb\n\x7f"), "a?[2Jb??");
    EXPECT_EQ(printable("\xc2\x9b"
                        "1m \xe2\x80\xae \xe2\x81\xa6"),
              "?1m ? ?");
    EXPECT_EQ(printable("\xff\xc3"), "??");
    EXPECT_EQ(printable("gr\xc3\xbc\xc3\x9f \xe4\xb8\x96"), "gr\xc3\xbc\xc3\x9f \xe4\xb8\x96");
    EXPECT_EQ((FileProblem{"a\x1b", 3, "b\x07"}.text()), "a?:3: b?");
}

TEST(LevelFile, IsReportedIfItIsMissing) {
    const Read<Level> level = loadLevel("no_such_level");
    ASSERT_TRUE(std::holds_alternative<FileProblem>(level));
    EXPECT_NE(std::get<FileProblem>(level).reason.find("there is no level"), std::string::npos);
    EXPECT_TRUE(std::holds_alternative<FileProblem>(loadLevel("../secrets")));
}

TEST(Levels, AreAllValidWithUniqueTitlesAndIdeas) {
    std::set<std::string> titles;
    std::set<std::string> ideas;
    for (const std::string& name : levelNames()) {
        const Read<Level> level = loadLevel(name);
        ASSERT_TRUE(std::holds_alternative<Level>(level)) << std::get<FileProblem>(level).text();
        titles.insert(std::get<Level>(level).title);
        ideas.insert(std::get<Level>(level).idea);
    }
    EXPECT_GE(titles.size(), 5u);
    EXPECT_EQ(titles.size(), levelNames().size());
    EXPECT_EQ(ideas.size(), titles.size());
    EXPECT_EQ(levelNames().front(), "first_light");
}

TEST(LevelDigest, DependsOnTheRulesAndNotOnTheTexts) {
    const Level level = std::get<Level>(parseLevel(kGood, "test", "test.toml"));
    Level other = level;
    other.title = "Another";
    EXPECT_EQ(digestOf(other), digestOf(level));
    other.kinds[0].strength += 1;
    EXPECT_NE(digestOf(other), digestOf(level));
}

} // namespace
