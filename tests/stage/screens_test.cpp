// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

TEST(Screens, TheTitleNamesTheChosenLevelAndEnterPlaysIt) {
    StageRig rig(StageRig::twoLevels());
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    EXPECT_TRUE(rig.picture().says("One block"));
    rig.press(Command::Right);
    EXPECT_TRUE(rig.picture().says("Three blocks"));
    rig.press(Command::Right); // there is no third
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.levelIndex(), 1u);
    EXPECT_EQ(rig.stage.game().level().title, "Three blocks");
}

TEST(Screens, ATileIsChosenAndPlayedByMouse) {
    StageRig rig(StageRig::twoLevels());
    Title title(2);
    Signals click;
    click.pointer = click.pointerNow = title.tile(1).center();
    click.clicked = true;
    rig.frame(click);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.levelIndex(), 1u);
}

TEST(Screens, EscapeLeavesTheTitleAndTheWindowButtonLeavesEverything) {
    StageRig title(StageRig::twoLevels());
    title.press(Command::Back);
    EXPECT_TRUE(title.stage.wantsToQuit());

    StageRig play(StageRig::playing());
    Signals closed;
    closed.closed = true;
    play.frame(closed);
    EXPECT_TRUE(play.stage.wantsToQuit());
}

TEST(Screens, NoTimePassesWhilePaused) {
    StageRig rig(StageRig::playing());
    rig.frames(10);
    rig.press(Command::Pause);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
    EXPECT_TRUE(rig.picture().says("Paused"));
    const std::uint32_t before = rig.stage.game().ticks();
    rig.frames(30);
    EXPECT_EQ(rig.stage.game().ticks(), before);
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    rig.frames(2);
    EXPECT_GT(rig.stage.game().ticks(), before);
}

TEST(Screens, LosingTheFocusPauses) {
    StageRig rig(StageRig::playing());
    Signals away;
    away.focusLost = true;
    rig.frame(away);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
    EXPECT_TRUE(rig.stage.wantsPointer());
}

TEST(Screens, KeysOfOneFrameAreTakenOneAfterTheOther) {
    StageRig rig(StageRig::playing());
    Signals all;
    all.commands = {Command::Pause, Command::Up, Command::Confirm}; // the last item: all levels
    rig.frame(all);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
}

TEST(Screens, RestartBeginsTheSameLevelAnew) {
    StageRig rig(StageRig::playing());
    rig.frames(50);
    rig.press(Command::Restart);
    EXPECT_LE(rig.stage.game().ticks(), 3u);
    EXPECT_EQ(rig.stage.levelIndex(), 0u);
}

TEST(Screens, AWonLevelLeadsToTheNext) {
    StageRig rig(StageRig::played());
    for (int i = 0; i < 60 * 120 && rig.stage.screen() == Screen::Playing; ++i) {
        rig.frame(); // the bot needs some seconds for one block; two minutes are ample
    }
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    ASSERT_EQ(rig.stage.game().result(), Result::Won);
    EXPECT_TRUE(rig.picture().says("Level cleared"));
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.levelIndex(), 1u);
}

TEST(Screens, APlayerWhoOnlyServesLosesAndMayTryAgain) {
    StageDef def = StageRig::playing();
    def.pilot = [](const Game& game) {
        Input input;
        input.launch = game.serving();
        input.target =
            std::int16_t(game.balls().empty() || game.balls()[0].heading.x > 0 ? -9000 : 9000);
        return std::optional(input);
    };
    StageRig rig(std::move(def));
    for (int i = 0; i < 60 * 600 && rig.stage.screen() == Screen::Playing; ++i) {
        rig.frame();
    }
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    const bool lost = rig.stage.game().result() == Result::Lost;
    EXPECT_TRUE(rig.picture().says(lost ? "Game over" : "Level cleared"));
    rig.press(Command::Restart);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.levelIndex(), 0u);
}

TEST(Screens, TheSettingsOfThePauseMenuStayInTheirRange) {
    StageRig rig(StageRig::playing());
    rig.press(Command::Pause);
    rig.press(Command::Down);
    rig.press(Command::Down); // sound
    for (int i = 0; i < 15; ++i) {
        rig.press(Command::Left);
    }
    EXPECT_EQ(rig.stage.effects().sound, 0);
    for (int i = 0; i < 15; ++i) {
        rig.press(Command::Right);
    }
    EXPECT_EQ(rig.stage.effects().sound, 100);
    EXPECT_TRUE(rig.picture().says("100 %"));
}

} // namespace
} // namespace apart
