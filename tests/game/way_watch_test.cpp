// SPDX-License-Identifier: MIT
// Ways to bring a building down.
#include <apart/core/assets.hpp>
#include <apart/core/editor/level_writer.hpp>
#include <apart/core/lint.hpp>
#include <apart/core/way_watch.hpp>

#include <game/game_access.hpp>
#include <gtest/gtest.h>

namespace {

using namespace apart;
using kodo::Vec2;

/// Two towers, of brick and of wood, and their ways: of any block by bank, of brick, of wood.
std::string towers() {
    return R"(format = 1
title = "t"
idea = "i"
[legend.b]
stuff = "brick"
hold = "standing"
[legend.w]
stuff = "wood"
hold = "standing"
[[ledge]]
x = 0
y = 7800
width = 10000
[[block]]
kind = "b"
shape = "square"
x = 4000
y = 8400
rows = 5
row-step = [0, 800]
[[block]]
kind = "w"
shape = "square"
x = -4000
y = 8400
rows = 5
row-step = [0, 800]
[[way]]
name = "by the wall"
bank = true
[[way]]
name = "the bricks first"
strikes = "b"
[[way]]
name = "the wood first"
strikes = "w"
)";
}

/// The ways after a shot in the game of seed 1.
std::uint32_t waysAfter(Vec2 from, Vec2 velocity) {
    Game game(levelFrom(towers()), 1);
    playOn(game, 60);
    GameTestAccess::beginBlow(game);
    GameTestAccess::shoot(game, from, velocity);
    WayWatch watch;
    EXPECT_EQ(watch.ways(game.level()), 0u) << "nothing has fallen";
    for (int i = 0; i < 120; ++i) {
        game.tick({});
        watch.update(game);
    }
    EXPECT_GT(game.collapse().largest, 0);
    return watch.ways(game.level());
}

TEST(WayWatch, TellsTheBlockThatWasStruckBeforeTheFall) {
    EXPECT_EQ(waysAfter({0, 10}, {16, 0}), 0b010u);
    EXPECT_EQ(waysAfter({0, 10}, {-16, 0}), 0b100u);
}

TEST(WayWatch, TellsABankBeforeTheFirstBlock) {
    EXPECT_EQ(waysAfter({11, 10}, {16, 0}), 0b011u) << "off the wall at the right";
    EXPECT_EQ(waysAfter({-11, 10}, {-16, 0}), 0b101u);
}

// The ball touches a block of steel, which stays, before it comes off the wall to the bricks.
TEST(WayWatch, AWallAfterTheFirstBlockIsNoBank) {
    const std::string steel = "[legend.x]\nstuff = \"steel\"\n"
                              "[[block]]\nkind = \"x\"\nshape = \"square\"\nx = 0\ny = 12000\n";
    Game game(levelFrom(towers() + steel), 1);
    playOn(game, 60);
    GameTestAccess::beginBlow(game);
    WayWatch watch;
    std::string struck; // letters; . for a wall
    const auto play = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            game.tick({});
            watch.update(game);
            for (const Event& event : game.events()) {
                const auto* hit = std::get_if<Struck>(&event);
                if (hit != nullptr && game.collapse().largest == 0) {
                    struck += hit->what == Role::Block ? hit->letter : '.';
                }
            }
        }
    };
    GameTestAccess::shoot(game, {0, 10}, {0, 16});
    play(30);
    ASSERT_EQ(struck, "x");
    GameTestAccess::shoot(game, {11, 10}, {16, 0});
    play(120);
    EXPECT_EQ(struck, "x.b");
    EXPECT_GT(game.collapse().largest, 0);
    EXPECT_EQ(watch.ways(game.level()), 0b010u) << "the bricks, not by the wall";
}

// A serve strikes the bricks, and only later a mount fails.
TEST(WayWatch, AFallThatBeginsWithoutABallHasNoWay) {
    Game game(levelFrom(towers()), 1);
    WayWatch watch;
    const auto play = [&] {
        game.tick({});
        watch.update(game);
    };
    game.tick({.launch = true});
    GameTestAccess::beginBlow(game);
    kodo::BodyRef ball = GameTestAccess::world(game)[game.balls()[0].body];
    ball.setPosition({0, 10});
    ball.setVelocity({16, 0});
    bool struck = false;
    for (int i = 0; i < 120 && !struck; ++i) {
        play();
        const Struck* hit = eventOf<Struck>(game);
        struck = hit != nullptr && hit->letter == 'b';
    }
    ASSERT_TRUE(struck);
    for (std::uint32_t i = 0; i <= kFailTicks && game.collapse().largest == 0; ++i) {
        GameTestAccess::shoot(game, {0, 4}, {0, 12});
        play();
    }
    ASSERT_GT(game.collapse().largest, 0);
    EXPECT_EQ(watch.ways(game.level()), 0u);
}

// Regression: the panel lit a way while the served ball was hollow.
TEST(WayWatch, AFallUnderAHollowBallHasNoWay) {
    Game game(levelFrom(towers()), 1);
    playOn(game, 60);
    WayWatch watch;
    GameTestAccess::countHit(game); // a serve, which begins no blow
    GameTestAccess::shoot(game, {0, 10}, {16, 0});
    for (int i = 0; i < 120; ++i) {
        game.tick({});
        watch.update(game);
    }
    ASSERT_GT(game.collapse().largest, 0);
    EXPECT_EQ(watch.ways(game.level()), 0u);
}

TEST(WayWatch, WaysAreReadAndWrittenAndChangeNoDigest) {
    const Level level = levelFrom(towers());
    ASSERT_EQ(level.ways.size(), 3u);
    EXPECT_EQ(level.ways[1], (WayDef{"the bricks first", "b", std::nullopt}));
    EXPECT_EQ(levelFrom(toToml(level)).ways, level.ways);
    Level bare = level;
    bare.ways.clear();
    EXPECT_EQ(digestOf(bare), digestOf(level)) << "scores and replays stay valid";
}

TEST(WayWatch, AWrongWayIsRefusedByLine) {
    const auto problem = [](const std::string& before, const std::string& after) {
        std::string text = towers();
        text.replace(text.find(before), before.size(), after);
        const Read<Level> level = parseLevel(text, "test", "test.toml");
        const auto* found = std::get_if<FileProblem>(&level);
        return found == nullptr ? std::string("none") : found->text();
    };
    EXPECT_EQ(problem("strikes = \"b\"", "strikes = \"q\""),
              "test.toml:33: way.strikes must be letters of blocks in the legend");
    EXPECT_EQ(problem("bank = true\n", ""), "test.toml:28: a way needs strikes or bank");
    EXPECT_EQ(problem("strikes = \"w\"", "strikes = \"w\"\nbanks = true"),
              "test.toml:37: unknown key way.banks");
}

TEST(WayWatch, EachBuildingHasTwoWays) {
    for (const std::string& name : levelNames()) {
        const Level level = std::get<Level>(loadLevel(name));
        EXPECT_EQ(level.ways.size(), isBuilding(level) ? 2u : 0u) << level.name;
    }
}

} // namespace
