// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/bot.hpp>
#include <apart/core/editor/edit_document.hpp>
#include <apart/core/editor/level_edit.hpp>
#include <apart/core/editor/level_writer.hpp>
#include <apart/core/editor/size_edit.hpp>
#include <apart/core/editor/trial.hpp>
#include <apart/core/level_file.hpp>
#include <apart/core/standing_trial.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

namespace apart {
namespace {

using kodo::Real;
using kodo::Vec2;
using Of = LevelPart::Of;

constexpr FreeBlock brick(std::int32_t x, std::int32_t y) {
    return {.x = x, .y = y, .width = 1600, .height = 800};
}

/// A ledge with its top at 6.2 m, and bricks.
Level bricks(std::initializer_list<FreeBlock> blocks) {
    Level level;
    level.name = "bricks";
    level = withLedge(std::move(level), {0, 6}, 8000);
    for (const FreeBlock& block : blocks) {
        level = withBlock(std::move(level), standingKind(Stuff::Brick), block);
    }
    return level;
}

std::shared_ptr<const Level> shared(Level level) {
    return std::make_shared<const Level>(std::move(level));
}

TEST(LevelEdit, ABlockIsFoundByItsShapeAndNotByItsBounds) {
    const Level level =
        bricks({{.form = Form::Wedge, .x = 0, .y = 6600, .width = 1600, .height = 800}});
    EXPECT_EQ(partAt(level, {Real(0.6), Real(6.4)}), (LevelPart{Of::Block, 0}));
    EXPECT_FALSE(partAt(level, {Real(-0.6), Real(6.9)})); // above its slope
    EXPECT_EQ(partAt(level, {3, 6}), (LevelPart{Of::Obstruction, 0}));
}

TEST(LevelEdit, SnapsToContactExactly) {
    const Level level = bricks({brick(0, 6600)});
    const kodo::Aabb bounds = boundsOf(placedShapeOf(brick(0, 0)));
    // 130 mm above the block, 90 mm beside its middle: on it, flush with the middle of the field.
    EXPECT_EQ(snapped(level, bounds, {}, {90, 7530}), (EditStep{0, 7400}));
    // 120 mm to the right of the block and 40 mm above the ledge: on the ledge, at the block.
    EXPECT_EQ(snapped(level, bounds, {}, {1720, 6640}), (EditStep{1600, 6600}));
    // Far from all: the lower left corner is on the grid of 50 mm.
    EXPECT_EQ(snapped(level, bounds, {}, {7311, 12318}), (EditStep{7300, 12300}));
}

TEST(LevelEdit, APartDoesNotSnapToWhatMovesWithIt) {
    const Level level = bricks({brick(3000, 12000)});
    const LevelParts own = {{Of::Block, 0}};
    EXPECT_EQ(snapped(level, boundsOf(level, own[0]), own, {100, 0}), (EditStep{100, 0}));
}

TEST(LevelEdit, EndsOfJointsMoveWithTheirBlocks) {
    Level level = bricks({brick(0, 8000)});
    level = *withRope(std::move(level), {0, 12}, {0, 8});
    ASSERT_EQ(level.links.size(), 1u);
    EXPECT_EQ(level.links[0].a, -1);
    const LevelParts parts = {{Of::Block, 0}};
    const LinkDef link = moved(level, parts, {100, -200}).links[0];
    EXPECT_EQ(link.fromX, 0);
    EXPECT_EQ(link.fromY, 12000);
    EXPECT_EQ(link.toX, 100);
    EXPECT_EQ(link.toY, 7800);
}

TEST(LevelEdit, ARemovedBlockTakesItsJointsAlongAndTheOthersKeepTheirs) {
    Level level = bricks({brick(-2000, 8000), brick(2000, 8000)});
    level = *withRope(std::move(level), {-2, 12}, {-2, 8});
    level = *withRope(std::move(level), {2, 12}, {2, 8});
    level = without(std::move(level), {{Of::Block, 0}});
    ASSERT_EQ(level.links.size(), 1u);
    EXPECT_EQ(level.links[0].b, 0);
    EXPECT_EQ(level.links[0].toX, 2000);
}

TEST(LevelEdit, NeitherEndOfARopeIsAtTheFieldAlone) {
    EXPECT_FALSE(withRope(bricks({brick(0, 8000)}), {5, 12}, {5, 8}));
    EXPECT_FALSE(withPin(bricks({brick(0, 8000)}), {5, 12}));
    const std::optional<Level> pinned =
        withPin(bricks({brick(0, 8000), brick(800, 8000)}), {Real(0.4), 8});
    ASSERT_TRUE(pinned);
    EXPECT_EQ(pinned->links[0].b, 1);
    EXPECT_EQ(pinned->links[0].a, 0);
}

TEST(LevelEdit, APinJoinsTwoChosenBlocksAndNotTheLatestOnesThere) {
    const Level level = bricks({brick(0, 8000), brick(400, 8000), brick(800, 8000)});
    const Vec2 place{Real(0.4), Real(8.2)};
    const LevelParts ends = {{Of::Block, 0}, {Of::Block, 2}};
    const std::optional<Level> pinned = withPin(level, place, ends);
    ASSERT_TRUE(pinned);
    EXPECT_EQ(pinned->links[0].a, 0);
    EXPECT_EQ(pinned->links[0].b, 2);
    const LevelParts one = {{Of::Block, 0}};
    EXPECT_EQ(withPin(level, place, one)->links[0].a, 1) << "the latest two";
}

TEST(LevelEdit, SizesChangeAboutTheMiddleAndStayPositive) {
    Level level = bricks({brick(0, 8000), {.form = Form::Round, .y = 9000, .width = 800}});
    const LevelParts all = {{Of::Block, 0}, {Of::Block, 1}, {Of::Obstruction, 0}};
    level = resized(std::move(level), all, {300, 0});
    EXPECT_EQ(level.freeBlocks[0].width, 1900);
    EXPECT_EQ(level.freeBlocks[0].height, 800);
    EXPECT_EQ(level.freeBlocks[0].x, 0);
    EXPECT_EQ(level.freeBlocks[1].width, 1100);
    EXPECT_EQ(level.freeBlocks[1].height, 1100);
    EXPECT_EQ(level.obstructions[0].size, 8300);
    level = resized(std::move(level), all, {0, -2000});
    EXPECT_EQ(level.freeBlocks[0].height, 100);
    EXPECT_EQ(level.freeBlocks[1].width, 100);
    EXPECT_EQ(level.obstructions[0].height, 100);
}

TEST(LevelEdit, AMirrorImageHasTheShapeAndTheJointsOfAMirror) {
    FreeBlock wedge{
        .form = Form::Wedge, .x = 2000, .y = 8000, .turn = 9000, .width = 1600, .height = 800};
    Level level = bricks({wedge});
    level = *withRope(std::move(level), {3, 12}, {2, 8});
    const LevelParts parts = {{Of::Block, 0}};
    level = withMirrorImages(std::move(level), parts);
    ASSERT_EQ(level.freeBlocks.size(), 2u);
    const kodo::Aabb left = boundsOf(level, {Of::Block, 1});
    const kodo::Aabb right = boundsOf(level, {Of::Block, 0});
    EXPECT_FLOAT_EQ(left.lower.x, -right.upper.x);
    EXPECT_FLOAT_EQ(left.lower.y, right.lower.y);
    ASSERT_EQ(level.links.size(), 2u);
    EXPECT_EQ(level.links[1].fromX, -3000);
    EXPECT_EQ(level.links[1].b, 1);
}

// Kinds are in the order of their letters; all who name them by index follow.
TEST(LevelEdit, ANewKindKeepsTheKindsOfAllOthers) {
    Level level = bricks({brick(0, 8000)});
    level = withBlock(std::move(level), standingKind(Stuff::Steel), brick(0, 9000));
    level =
        withBlock(std::move(level), standingKind(Stuff::Glass, Support::Mounted), brick(0, 10000));
    EditDocument document(newLevel("kinds"));
    level.title = level.idea = "kinds";
    EXPECT_EQ(document.apply(level), "");
    const Level& read = *document.level();
    EXPECT_EQ(read.kinds[read.freeBlocks[0].kind].stuff, Stuff::Brick);
    EXPECT_EQ(read.kinds[read.freeBlocks[1].kind].stuff, Stuff::Steel);
    EXPECT_EQ(read.kinds[read.freeBlocks[2].kind].stuff, Stuff::Glass);
}

TEST(EditDocument, RefusesWhatTheGameCannotRead) {
    EditDocument document(newLevel("own"));
    const auto before = document.level();
    const LevelParts block = {{Of::Block, 0}};
    EXPECT_EQ(document.apply(moved(*before, block, {20000, 0})),
              "x must be a whole number from -12000 to 12000");
    EXPECT_EQ(document.apply(without(*before, block)), "the level holds no block that can break");
    EXPECT_EQ(document.level(), before);
    EXPECT_FALSE(document.canUndo());
}

TEST(EditDocument, UndoAndRedoReachEachState) {
    EditDocument document(newLevel("own"));
    const LevelParts block = {{Of::Block, 0}};
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(document.apply(moved(*document.level(), block, {0, 100})), "");
    }
    EXPECT_FALSE(document.isSaved());
    document.markSaved();
    document.undo();
    document.undo();
    EXPECT_EQ(document.level()->freeBlocks[0].y, 6700);
    document.redo();
    EXPECT_EQ(document.level()->freeBlocks[0].y, 6800);
    ASSERT_EQ(document.apply(moved(*document.level(), block, {0, 1000})), "");
    EXPECT_FALSE(document.canRedo()); // another future
    document.undo();
    document.undo();
    document.undo();
    document.undo();
    EXPECT_EQ(*document.level(), newLevel("own"));
}

TEST(EditDocument, EveryLevelOfTheGameCanBeEditedInEachPart) {
    for (const std::string& name : levelNames()) {
        const Level level = std::get<Level>(loadLevel(name));
        EditDocument document(level);
        EXPECT_EQ(document.apply(level), "") << name;
        EXPECT_FALSE(document.canUndo()) << name;
        const LevelParts all = partsIn(level, {{-20, -20}, {20, 20}});
        EXPECT_EQ(all.size(), level.freeBlocks.size() + level.cells.size() + level.links.size() +
                                  level.obstructions.size() + level.wells.size() +
                                  level.waters.size())
            << name;
        EXPECT_EQ(moved(level, all, {}), level) << name;
    }
}

TEST(StandingTrial, NamesTheBlockThatMovesFirst) {
    // The upper brick overhangs by more than half: it falls, and the lower one stays.
    StandingTrial trial(shared(bricks({brick(0, 6600), brick(900, 7400)})));
    trial.advance(60);
    EXPECT_FALSE(trial.done());
    trial.advance(StandingTrial::kTicks);
    ASSERT_TRUE(trial.first());
    EXPECT_EQ(trial.first()->block.key, keyOfFree(1));
    EXPECT_TRUE(trial.done());

    StandingTrial still(shared(bricks({brick(0, 6600), brick(300, 7400)})));
    still.advance(StandingTrial::kTicks);
    EXPECT_FALSE(still.first());
}

TEST(FallForecast, SaysWhatComesDown) {
    const auto level = shared(bricks({brick(0, 6600), brick(0, 7400), brick(3000, 6600)}));
    FallForecast forecast(level, 0, {0, Real(6.6)});
    forecast.advance(100000);
    ASSERT_TRUE(forecast.done());
    std::vector<std::size_t> fallen;
    for (const auto& block : forecast.fallen()) {
        fallen.push_back(block.block);
    }
    std::sort(fallen.begin(), fallen.end());
    EXPECT_EQ(fallen.front(), 0u);
    EXPECT_EQ(std::count(fallen.begin(), fallen.end(), 2u), 0);
}

TEST(ServeMap, IsTheSameInSlicesOfAnySize) {
    Level weak = std::get<Level>(loadLevel("first_light"));
    for (BlockKind& kind : weak.kinds) {
        kind.strength = 1;
    }
    const auto level = shared(std::move(weak));
    ServeMap once(level);
    ServeMap slices(level);
    once.advance(3000);
    for (int i = 0; i < 300; ++i) {
        slices.advance(10);
    }
    EXPECT_GT(once.served(), 2u);
    EXPECT_EQ(once.served(), slices.served());
    double most = 0;
    for (std::size_t i = 0; i < level->freeBlocks.size(); ++i) {
        EXPECT_EQ(once.clearedBy(i), slices.clearedBy(i));
        most = std::max(most, once.clearedBy(i));
    }
    EXPECT_GT(most, 0);
    EXPECT_LE(most, 1);
}

Level levelOf(std::string text) {
    const Read<Level> read = parseLevel(
        "format = 1\ntitle = 'map'\nidea = 'map'\nball-speed = 12000\n" + text, "map", "map");
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        ADD_FAILURE() << problem->text();
        return {};
    }
    return std::get<Level>(read);
}

// Two ledges and a gate that lets it down alone guard a block: no ball reaches it. A wait brings it
// down after 4 s, and it has left the field before the 8 s of a serve are over.
TEST(ServeMap, WhatAWaitBringsDownIsNotCleared) {
    const auto level = shared(levelOf(R"(
grid = '''
...............
...............
...............
...............
...............
...............
...............
.......v.......
'''
[legend.v]
obstruction = "gate"
facing = "down"
size = 2000
[legend.g]
stuff = "glass"
[[block]]
kind = "g"
x = 0
y = 15000
[[ledge]]
x = 1200
y = 14500
width = 400
height = 7000
mirror = true
)"));
    Game game(level, 1);
    game.tick({.launch = true});
    for (std::uint32_t i = 0; i < ServeMap::kSeconds * kTicksPerSecond; ++i) {
        game.tick(bot(game));
    }
    EXPECT_EQ(game.result(), Result::Won) << "the wait brings it down";
    ServeMap map(level);
    map.advance(5 * ServeMap::kSeconds * kTicksPerSecond);
    EXPECT_GE(map.served(), 5u);
    EXPECT_EQ(map.clearedBy(0), 0);
}

// Three blocks on pegs make up most of a building; the fourth one stands in a closed box. Once the
// others are down it comes down by itself.
TEST(ServeMap, TheRestOfABuildingThatIsDownIsNotCleared) {
    const auto level = shared(levelOf(R"(
[legend.g]
stuff = "glass"
hold = "standing"
[[ledge]]
x = -6000
y = 9000
width = 400
count = 3
step = [6000, 0]
[[block]]
kind = "g"
x = -6000
y = 9600
count = 3
step = [6000, 0]
[[ledge]]
x = 0
y = 14000
width = 4000
count = 2
step = [0, 2000]
[[ledge]]
x = 1800
y = 15000
width = 400
height = 1600
mirror = true
[[block]]
kind = "g"
x = 0
y = 14600
)"));
    ServeMap map(level);
    map.advance(40 * ServeMap::kSeconds * kTicksPerSecond);
    EXPECT_GT(map.clearedBy(0), 0.2);
    EXPECT_GT(map.clearedBy(1), 0.2);
    EXPECT_GT(map.clearedBy(2), 0.2);
    EXPECT_EQ(map.clearedBy(3), 0);
}

// Regression: the paddle stood in the middle, far from the ball.
TEST(Trial, ThePaddleIsBelowTheBallAndInsideTheField) {
    for (const Real x : {Real(5), Real(-11), Real(11)}) {
        Game game(bricks({brick(0, 6600)}), 1);
        Trial::dropBall(game, {x, 12});
        const Real paddle = game.world()[game.paddle()].position().x;
        EXPECT_NEAR(paddle, x, 3);
        EXPECT_EQ(paddle == x, x == 5);
        const kodo::Aabb bounds = game.world()[game.paddle()].bounds();
        EXPECT_GE(bounds.lower.x, -kFieldWidth / 2 + 2 * kBallRadius - Real(0.001));
        EXPECT_LE(bounds.upper.x, kFieldWidth / 2 - 2 * kBallRadius + Real(0.001));
        game.tick({});
        EXPECT_NEAR(game.world()[game.paddle()].position().x, paddle, 0.001);
    }
}

TEST(Trial, ABallBeginsAboveABlockAndNotInIt) {
    Game game(bricks({brick(0, 6600), brick(0, 7400)}), 1);
    Trial::dropBall(game, {0, Real(6.5)});
    const Vec2 ball = game.world()[game.balls()[0].body].position();
    EXPECT_EQ(ball.x, 0);
    EXPECT_GT(ball.y, Real(7.8) + kBallRadius);
    EXPECT_LT(ball.y, Real(7.8) + 3 * kBallRadius);
    Game full(bricks({{.x = 0, .y = 12000, .width = 2000, .height = 16000}}), 1);
    Trial::dropBall(full, {0, 12});
    EXPECT_EQ(full.world()[full.balls()[0].body].position(), (Vec2{0, 12})) << "no place is free";
}

TEST(Trial, ABallFromAPlaceFliesDownAndIsNotHollow) {
    Game game(bricks({brick(0, 6600)}), 1);
    Trial::dropBall(game, {5, 12});
    EXPECT_FALSE(game.serving());
    EXPECT_FALSE(game.balls()[0].hollow);
    game.tick({});
    const kodo::BodyView ball = game.world()[game.balls()[0].body];
    EXPECT_NEAR(ball.position().x, 5, 0.01);
    EXPECT_LT(ball.velocity().y, -5);
}

} // namespace
} // namespace apart
