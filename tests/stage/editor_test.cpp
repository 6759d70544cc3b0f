// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/daily.hpp>
#include <apart/core/level_file.hpp>
#include <apart/core/replay_link.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "editor_rig.hpp"

namespace apart {
namespace {

// A new level has a ledge whose top is at 6.2 m, and a brick on it.
TEST_F(EditorStage, BlocksArePlacedAndSnapToContact) {
    start();
    ASSERT_EQ(rig_->stage.screen(), Screen::Editor);
    button(EditorAct::Stuff, 3);
    button(EditorAct::Shape, 3); // a square of stone
    click({Real(-1.1), Real(6.7)});
    ASSERT_EQ(level().freeBlocks.size(), 2u);
    EXPECT_EQ(level().freeBlocks[1].x, -1200); // beside the brick
    EXPECT_EQ(level().freeBlocks[1].y, 6600);  // on the ledge
    EXPECT_EQ(level().kinds[level().freeBlocks[1].kind].stuff, Stuff::Stone);
    EXPECT_TRUE(rig_->picture().says("2 blocks"));
}

TEST_F(EditorStage, ABlockIsDraggedMirroredRemovedAndAllOfItUndone) {
    start();
    drag({0, Real(6.6)}, {Real(2.02), Real(6.65)});
    EXPECT_EQ(level().freeBlocks[0].x, 2000);
    EXPECT_EQ(level().freeBlocks[0].y, 6600);
    key("M");
    ASSERT_EQ(level().freeBlocks.size(), 2u);
    EXPECT_EQ(level().freeBlocks[1].x, -2000);
    key("right");
    EXPECT_EQ(level().freeBlocks[0].x, 2050);
    key("X");
    ASSERT_EQ(level().freeBlocks.size(), 1u);
    EXPECT_EQ(level().freeBlocks[0].x, -2000);
    for (int i = 0; i < 4; ++i) {
        key("Z");
    }
    EXPECT_EQ(level().freeBlocks[0].x, 0);
    key("Y");
    EXPECT_EQ(level().freeBlocks[0].x, 2000);
}

TEST_F(EditorStage, RopesAndPinsAreDrawnByTheMouse) {
    start();
    button(EditorAct::Rope);
    drag({0, 12}, {0, Real(6.6)});
    button(EditorAct::Pin);
    click({Real(0.5), Real(6.6)});
    ASSERT_EQ(level().links.size(), 2u);
    EXPECT_EQ(level().links[0].kind, LinkKind::Rope);
    EXPECT_EQ(level().links[0].fromY, 12000);
    EXPECT_EQ(level().links[1].kind, LinkKind::Pin);
    click({8, 8});
    EXPECT_EQ(level().links.size(), 2u);
    EXPECT_TRUE(rig_->picture().says("A pin is at a block that is not mounted."));
}

TEST_F(EditorStage, KeysChangeTheSizeOfChosenBlocksAndOfTheOneInHand) {
    start();
    click({0, Real(6.6)});
    key("W");
    key("W");
    key("J");
    EXPECT_EQ(level().freeBlocks[0].width, 1800);
    EXPECT_EQ(level().freeBlocks[0].height, 700);
    key("3");
    key("Q");
    key("K");
    click({6, 12});
    ASSERT_EQ(level().freeBlocks.size(), 2u);
    EXPECT_EQ(level().freeBlocks[1].width, 1500);
    EXPECT_EQ(level().freeBlocks[1].height, 900);
}

TEST_F(EditorStage, TheLampNamesTheBlockThatMovesFirst) {
    start();
    rig_->frames(20);
    EXPECT_FALSE(editor().standing().done()); // 60 ticks a frame
    rig_->frames(110);
    EXPECT_TRUE(editor().standing().done());
    EXPECT_TRUE(rig_->picture().says("it stands"));
    button(EditorAct::Shape, 0);
    click({Real(1.1), Real(7.4)}); // overhangs the lower block too far
    rig_->frames(60);
    ASSERT_TRUE(editor().standing().first());
    EXPECT_EQ(editor().standing().first()->block.key, keyOfFree(1));
    EXPECT_TRUE(rig_->picture().says("moves after"));
}

TEST_F(EditorStage, APointerThatRestsShowsTheFall) {
    start();
    button(EditorAct::Shape, 0);
    click({0, Real(7.4)});
    key("A");
    mouse({0, Real(6.6)}, false, false);
    rig_->frames(60);
    ASSERT_TRUE(editor().forecast());
    EXPECT_EQ(editor().forecast()->struck(), 0u);
    EXPECT_TRUE(editor().forecast()->done());
    EXPECT_TRUE(rig_->picture().says("cleared by a hit here"));
    mouse({8, 12}, false, false);
    rig_->frame();
    EXPECT_FALSE(editor().forecast());
}

TEST_F(EditorStage, TheMapOfServesGrowsInSlices) {
    start();
    rig_->frames(130); // the level stands
    key("H");
    rig_->frames(40);
    ASSERT_TRUE(editor().map());
    const std::uint32_t served = editor().map()->served();
    EXPECT_GT(served, 0u);
    EXPECT_LT(served, ServeMap::kServes);
    rig_->frames(40);
    EXPECT_GT(editor().map()->served(), served);
    EXPECT_TRUE(rig_->picture().says("of 200 serves"));
}

TEST_F(EditorStage, ATryBeginsAtThePointerAndLeadsBack) {
    start();
    mouse({5, 12}, false, false);
    key("T");
    ASSERT_EQ(rig_->stage.screen(), Screen::Playing);
    EXPECT_FALSE(rig_->stage.session().game().serving());
    const Game& game = rig_->stage.session().game();
    EXPECT_NEAR(game.world()[game.balls()[0].body].position().x, 5, 0.1);
    rig_->press(Command::Back);
    EXPECT_EQ(rig_->stage.screen(), Screen::Editor);
    key("T");
    rig_->press(Command::Restart);
    EXPECT_EQ(rig_->stage.screen(), Screen::Playing);
    EXPECT_LT(rig_->stage.session().game().ticks(), 5u);
    for (int i = 0; i < 60 * 300 && rig_->stage.screen() == Screen::Playing; ++i) {
        rig_->press(Command::Launch); // the paddle stays: lost
    }
    EXPECT_EQ(rig_->stage.screen(), Screen::Editor);
    EXPECT_TRUE(rig_->stage.records().profile().best[0].empty());
}

// Regression: it began at the button, and the paddle was far from it.
TEST_F(EditorStage, ATryByItsButtonBeginsWhereThePointerStayedInTheField) {
    start();
    mouse({-7, 12}, false, false);
    rig_->frames(20);
    mouse({Real(11.5), 9}, false, false); // on the way to the button
    button(EditorAct::Try);
    ASSERT_EQ(rig_->stage.screen(), Screen::Playing);
    const Game& game = rig_->stage.session().game();
    EXPECT_NEAR(game.world()[game.balls()[0].body].position().x, -7, 0.1);
    EXPECT_NEAR(game.world()[game.paddle()].position().x, -7, 0.2);
}

TEST_F(EditorStage, ATryIsNamedInItsPanel) {
    start();
    key("T");
    EXPECT_TRUE(rig_->picture().says("TRY OF my_level"));
    EXPECT_TRUE(rig_->picture().says("escape: back to the editor"));
    EXPECT_FALSE(rig_->picture().says("A LEVEL OF ITS OWN"));
}

TEST_F(EditorStage, WhatAHeldKeyDidIsTakenBackAtOnce) {
    start();
    click({0, Real(6.6)});
    const Level before = level();
    const auto hold = [&](const char* name, int frames) {
        Signals signals;
        signals.presses = {{false, *keyNamed(name)}};
        signals.keyHeld = *keyNamed(name);
        rig_->frame(signals);
        signals.presses.clear();
        for (int i = 0; i < frames; ++i) {
            rig_->frame(signals);
        }
        rig_->frame();
    };
    key("right");
    const Level nudged = level();
    hold("W", 90);
    const Level wide = level();
    EXPECT_GT(wide.freeBlocks[0].width, before.freeBlocks[0].width + 300);
    hold("right", 90);
    EXPECT_GT(level().freeBlocks[0].x, wide.freeBlocks[0].x + 300);
    key("Z");
    EXPECT_EQ(level(), wide);
    key("Z");
    EXPECT_EQ(level(), nudged) << "not with the key before";
    key("Z");
    EXPECT_EQ(level(), before);
    hold("Y", 90);
    EXPECT_GT(level().freeBlocks[0].x, wide.freeBlocks[0].x + 300)
        << "a held Y leads on step by step";
    hold("Z", 90);
    EXPECT_EQ(level(), before);
}

TEST_F(EditorStage, AHeldKeyOfASizeRepeats) {
    start();
    click({0, Real(6.6)});
    key("W");
    EXPECT_EQ(level().freeBlocks[0].width, 1700);
    const auto hold = [&](const char* name, int frames) {
        Signals signals;
        signals.keyHeld = *keyNamed(name);
        for (int i = 0; i < frames; ++i) {
            rig_->frame(signals);
        }
    };
    hold("W", 60);
    EXPECT_EQ(level().freeBlocks[0].width, 1700) << "it was released meanwhile";
    Signals signals;
    signals.presses = {{false, *keyNamed("W")}};
    signals.keyHeld = *keyNamed("W");
    rig_->frame(signals);
    hold("W", 16);
    EXPECT_EQ(level().freeBlocks[0].width, 1800) << "not before 0.3 s";
    hold("W", 62);
    EXPECT_NEAR(level().freeBlocks[0].width, 1800 + 12 * 100, 100);
    const std::int32_t width = level().freeBlocks[0].width;
    rig_->frame();
    hold("W", 60);
    EXPECT_EQ(level().freeBlocks[0].width, width);
    signals.presses = {{false, *keyNamed("M")}};
    signals.keyHeld = *keyNamed("M");
    rig_->frame(signals);
    hold("M", 60);
    EXPECT_EQ(level().freeBlocks.size(), 2u) << "a mirror image is made once";
}

// The brick stands on a ledge.
TEST_F(EditorStage, AChangedSizeKeepsContactUnlessShiftIsHeld) {
    start();
    click({0, Real(6.6)});
    key("K");
    EXPECT_EQ(level().freeBlocks[0].height, 900);
    EXPECT_EQ(level().freeBlocks[0].y, 6650);
    Signals signals;
    signals.presses = {{false, *keyNamed("K")}};
    signals.shiftHeld = true;
    rig_->frame(signals);
    EXPECT_EQ(level().freeBlocks[0].height, 1000);
    EXPECT_EQ(level().freeBlocks[0].y, 6650);
}

TEST_F(EditorStage, ARefusalGoesWithTheNextChangeOrAfterSomeSeconds) {
    start();
    const auto refuse = [&] {
        button(EditorAct::Pin);
        click({8, 8});
        EXPECT_TRUE(rig_->picture().says("A pin is at a block that is not mounted."));
    };
    refuse();
    rig_->frames(60 * 7);
    EXPECT_FALSE(rig_->picture().says("A pin is at a block that is not mounted."));
    refuse();
    button(EditorAct::Shape, 0);
    click({0, Real(7.4)});
    EXPECT_FALSE(rig_->picture().says("A pin is at a block that is not mounted."));
    refuse();
    key("Z");
    EXPECT_FALSE(rig_->picture().says("A pin is at a block that is not mounted."));
}

TEST_F(EditorStage, ASavedLevelIsReadByTheGameAndStandsInTheList) {
    start();
    key("S");
    const Read<Level> read = readLevelFile(folder_ / "my_level.toml");
    ASSERT_TRUE(std::holds_alternative<Level>(read));
    EXPECT_EQ(std::get<Level>(read), level());
    key("M");
    rig_->press(Command::Back);
    EXPECT_EQ(rig_->stage.screen(), Screen::Levels);
    EXPECT_TRUE(rig_->picture().says("my_level"));
}

TEST_F(EditorStage, UnsavedWorkIsLeftByASecondEscapeAlone) {
    start();
    button(EditorAct::Shape, 0);
    click({0, Real(7.4)});
    rig_->press(Command::Back);
    ASSERT_EQ(rig_->stage.screen(), Screen::Editor);
    EXPECT_TRUE(rig_->picture().says("Not saved."));
    rig_->press(Command::Back);
    EXPECT_EQ(rig_->stage.screen(), Screen::Levels);
    EXPECT_FALSE(fs::exists(folder_ / "my_level.toml"));
}

TEST_F(EditorStage, ALevelOfTheGameIsCopied) {
    const LevelList levels = StageRig::twoLevels().levels;
    const EditorStart copy = editorOf(levels[0].get(), levels, folder_);
    EXPECT_EQ(copy.level.name, levels[0]->name + "_own");
    EXPECT_EQ(copy.save("x"), "");
    EXPECT_EQ(editorOf(levels[0].get(), levels, folder_).level.name, levels[0]->name + "_own2");
    Level own = *levels[0];
    own.name += "_own";
    EXPECT_EQ(editorOf(&own, levels, folder_).file, (folder_ / (own.name + ".toml")).string());
}

// Regression: it was the level over which the pointer had passed last.
TEST_F(EditorStage, TheButtonOfTheMapEditsTheLevelOnWhichThePointerRested) {
    start();
    rig_->press(Command::Back);
    ASSERT_EQ(rig_->stage.screen(), Screen::Levels);
    const LevelMap& map = rig_->stage.levelMap();
    mouse(map.tile(1).center(), false, false);
    rig_->frames(30);
    mouse(map.tile(0).center(), false, false);
    click(map.editPlace().center());
    ASSERT_EQ(rig_->stage.screen(), Screen::Editor);
    EXPECT_EQ(level().name, "test_3_own");
    rig_->press(Command::Back);
    mouse(map.tile(0).center(), false, false);
    key("E"); // of the level that is shown
    EXPECT_EQ(level().name, "test_1_own");
}

TEST_F(EditorStage, AFileIsEditedWhereverItIs) {
    const auto fresh = editorOfFile(folder_ / "tower.toml");
    ASSERT_TRUE(std::holds_alternative<EditorStart>(fresh));
    EXPECT_EQ(std::get<EditorStart>(fresh).level, newLevel("tower"));
    std::ofstream(folder_ / "bad.toml") << "format = 2\n";
    EXPECT_TRUE(std::holds_alternative<std::string>(editorOfFile(folder_ / "bad.toml")));
}

TEST(ShareGame, TheResultsCopyALinkThatPlaysTheGame) {
    std::vector<std::string> copied;
    StageDef def = StageRig::playing();
    def.sharing.copy = [&](const std::string& text) { copied.push_back(text); };
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_TRUE(rig.picture().says("C: copy a link to this game"));
    Signals signals;
    signals.presses = {{false, *keyNamed("C")}};
    rig.frame(signals);
    ASSERT_EQ(copied.size(), 1u);
    const Read<ReplayRun> read = runOfLink(copied[0]);
    ASSERT_TRUE(std::holds_alternative<ReplayRun>(read));
    Playback playback(std::get<ReplayRun>(read)[0], StageRig::twoLevels().levels[0]);
    while (!playback.done()) {
        playback.tick();
    }
    EXPECT_EQ(playback.game().score(), rig.stage.session().game().score());
    EXPECT_FALSE(playback.divergence());
    EXPECT_TRUE(rig.picture().says("A link to the game is copied."));
}

TEST(ShareGame, TheLargestFallOfAReplayIsShownFromBeforeItToAfterIt) {
    const auto level = std::make_shared<const Level>(std::get<Level>(loadLevel("arch")));
    const Replay replay = recordedGame(level, 1);
    const std::optional<Fall> fall = largestFall(replay, level);
    ASSERT_TRUE(fall);
    EXPECT_GT(fall->blocks, 3);
    Rerun rerun = fall->rerun;
    EXPECT_LT(rerun.play().game().collapse().blocks, fall->blocks);
    std::int32_t most = 0;
    const std::uint32_t first = rerun.play().game().ticks();
    for (double at = 0; at < rerun.seconds() - 0.05; at += 0.05) {
        rerun.advance(0.05);
        most = std::max(most, rerun.play().game().collapse().blocks);
        EXPECT_GE(rerun.play().game().ticks(), first);
    }
    EXPECT_EQ(most, fall->blocks);
    const auto glass = glassLevel("One block", {7});
    EXPECT_FALSE(largestFall(recordedGame(glass, 1), glass));
}

// Regression: the film began wherever the rerun behind the results was.
TEST(ShareGame, TheFilmOfTheResultsIsThatOfTheReplay) {
    std::vector<Rerun> filmed;
    StageDef def = StageRig::played();
    def.levels = {std::make_shared<const Level>(std::get<Level>(loadLevel("tower")))};
    def.sharing.film = [&](const Rerun& fall) {
        filmed.push_back(fall);
        return std::string("filmed");
    };
    StageRig rig(std::move(def));
    rig.untilOver();
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    for (int i = 0; i < 2; ++i) {
        Signals signals;
        signals.presses = {{false, *keyNamed("G")}};
        rig.frame(signals);
        for (int frame = 0; frame < 25; ++frame) {
            rig.frame();
        }
    }
    ASSERT_EQ(filmed.size(), 2u) << "the collapse that ended the game is shown again";
    const Game& game = rig.stage.session().game();
    const std::optional<Fall> fall =
        largestFall(*rig.stage.session().record(), std::make_shared<const Level>(game.level()));
    ASSERT_TRUE(fall);
    for (const Rerun& rerun : filmed) {
        EXPECT_EQ(rerun.play().game().stateHash(), fall->rerun.play().game().stateHash());
        EXPECT_EQ(rerun.seconds(), fall->rerun.seconds());
    }
}

TEST(ShareGame, ARivalIsTheGhostOfItsLevelAlone) {
    StageDef def = StageRig::playing();
    def.rival = recordedGame(def.levels[0], 5);
    StageRig rig(def);
    ASSERT_TRUE(rig.stage.session().ghost());
    EXPECT_EQ(rig.stage.session().ghost()->game().seed(), 5u);
    def.firstLevel = 1;
    EXPECT_FALSE(StageRig(def).stage.session().ghost());
    def.firstLevel = 0;
    def.rival->levelDigest = 1; // of another content
    EXPECT_FALSE(StageRig(def).stage.session().ghost());
}

TEST(DailyLine, SaysDayPointsLevelAndTime) {
    EXPECT_EQ(dailyLine({20261126, 31250, 3, 102 * kTicksPerSecond}),
              "aPart, daily run 2026-11-26: 31250 points, level 3, 1:42");
    EXPECT_EQ(dailyLine({20260102, 0, 1, 0}),
              "aPart, daily run 2026-01-02: 0 points, level 1, 0:00");
}

} // namespace
} // namespace apart
