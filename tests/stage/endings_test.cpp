// SPDX-License-Identifier: MIT
// What ends a game asks once if points are lost by it.
#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

// A page of a browser may be closed at any time, without a word to the game.
TEST(Endings, AModeThatIsChosenIsSavedAtOnce) {
    std::vector<Profile> kept;
    StageDef def = StageRig::twoLevels();
    def.keeping.save = StageRig::keeping(kept);
    StageRig rig(std::move(def));
    rig.clickItem(Action::Mode);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].mode, Mode::Pure);
}

TEST(Endings, ATitleThatCannotQuitOffersNoQuit) {
    StageDef def = StageRig::twoLevels();
    def.quits = false;
    StageRig rig(std::move(def));
    EXPECT_EQ(rig.stage.menu().items().back().action, Action::Options);
    EXPECT_FALSE(rig.picture().says("quit"));
    rig.press(Command::Back);
    rig.press(Command::Back);
    EXPECT_FALSE(rig.stage.wantsToQuit());
}

TEST(Endings, WhatEndsAGameWithPointsAsksOnceInPlayAndInThePauseMenu) {
    StageDef def = StageRig::twoLevels();
    def.firstLevel = 1; // three blocks
    def.startAtOnce = true;
    StageRig rig(std::move(def));
    makePoints(rig);
    const std::uint32_t ticks = rig.stage.session().game().ticks();
    rig.press(Command::Restart);
    EXPECT_TRUE(rig.picture().says("once more to start again"));
    rig.press(Command::Pause);
    rig.frames(60 * 3); // the question expires
    EXPECT_FALSE(rig.picture().says("once more"));
    for (const auto& [action, question] :
         {std::pair{Action::Restart, "once more to start again"},
          std::pair{Action::ToTitle, "once more to leave the game"},
          std::pair{Action::Levels, "once more to leave the game"}}) {
        rig.clickItem(action);
        EXPECT_EQ(rig.stage.screen(), Screen::Paused);
        EXPECT_GE(rig.stage.session().game().ticks(), ticks);
        EXPECT_TRUE(rig.picture().says(question));
    }
    rig.press(Command::Up); // another item: its question is gone
    EXPECT_FALSE(rig.picture().says("once more"));
    rig.press(Command::Restart);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused) << "another question";
    rig.clickItem(Action::Restart);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing) << "the key and the item ask the same";
    EXPECT_LE(rig.stage.session().game().ticks(), 3u);
    makePoints(rig);
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle);
    rig.clickItem(Action::ToTitle);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
}

TEST(Endings, WhatEndsAGameWithoutPointsDoesNotAsk) {
    for (const Action action : {Action::Restart, Action::ToTitle, Action::Levels}) {
        StageRig rig(StageRig::playing());
        rig.frames(30);
        rig.press(Command::Pause);
        rig.clickItem(action);
        EXPECT_NE(rig.stage.screen(), Screen::Paused);
    }
}

TEST(Endings, TheQuestionInTheFirstLevelOfARunSaysThatItHasNoScore) {
    const std::string reason = ": left in its first level, a run has no score";
    StageDef def = StageRig::twoLevels();
    def.levels = {def.levels[1]};
    def.endless = [](std::uint32_t, std::uint32_t number) {
        return number == 1 ? glassLevel("Row 1", {4, 7}) : glassLevel("Row 2", {2, 7, 12});
    };
    StageRig rig(std::move(def));
    const auto expectReason = [&](bool said) {
        rig.press(Command::Restart);
        EXPECT_TRUE(rig.picture().says("once more to start again"));
        EXPECT_EQ(rig.picture().says("once more to start again" + reason), said);
        rig.press(Command::Pause);
        rig.clickItem(Action::ToTitle);
        EXPECT_EQ(rig.picture().says("once more to leave the game" + reason), said);
        rig.press(Command::Pause);
    };
    rig.clickItem(Action::Endless);
    makePoints(rig);
    expectReason(true);
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    rig.press(Command::Next);
    expectReason(false);
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle); // asked just before
    rig.clickItem(Action::Play);    // no run
    makePoints(rig);
    expectReason(false);
}

// Regression: during the fanfare the score was lost.
TEST(Endings, ClosingAndRestartingEnterAResultThatIsNotEnteredYet) {
    for (const bool closes : {true, false}) {
        StageRig rig(StageRig::playing());
        for (int i = 0; i < 120 * 300 && rig.stage.session().game().result() == Result::Playing;
             ++i) {
            makeMove(rig);
        }
        ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
        ASSERT_EQ(rig.stage.screen(), Screen::Playing);
        const std::string name = rig.stage.session().game().level().name;
        const std::int32_t score = rig.stage.session().game().score();
        if (closes) {
            Signals signals;
            signals.closed = true;
            rig.frame(signals);
            EXPECT_TRUE(rig.stage.wantsToQuit());
        } else {
            rig.press(Command::Restart);
            EXPECT_EQ(rig.stage.session().game().result(), Result::Playing);
        }
        EXPECT_EQ(rig.stage.records().profile().bestOf(Mode::Standard, name).score, score);
        EXPECT_EQ(rig.stage.records().profile().totals[0].games, 1);
    }
}

/// One frame with a press: of a key, or of the mouse on the first item.
void pressOnce(StageRig& rig, std::optional<Command> command) {
    Signals signals;
    if (command) {
        signals.commands = {*command};
    } else {
        signals.clicked = true;
        signals.pointerNow = rig.stage.menu().place(0).center();
    }
    rig.frame(signals);
}

// Regression: a serve or a pull at the end of a game went on to the next one.
TEST(Endings, AResultLetsNothingBeChosenAtFirst) {
    for (const std::optional<Command> command :
         {std::optional(Command::Launch), std::optional(Command::Confirm),
          std::optional<Command>()}) {
        StageRig rig(StageRig::playing());
        playToTheEnd(rig);
        ASSERT_EQ(rig.stage.screen(), Screen::Over);
        int presses = 0;
        for (; presses < 300 && rig.stage.screen() == Screen::Over; ++presses) {
            pressOnce(rig, command);
        }
        EXPECT_EQ(rig.stage.screen(), Screen::Playing);
        EXPECT_NEAR(presses / 60.0, Outcome::kReading, 0.05);
    }
}

TEST(Endings, AResultLeavesItsChoiceToKeysThatPulledAndPushed) {
    StageRig rig(StageRig::playing());
    playToTheEnd(rig);
    pressOnce(rig, Command::Down);
    EXPECT_EQ(rig.stage.menu().chosen(), 0u);
    rig.press(Command::Down);
    EXPECT_EQ(rig.stage.menu().chosen(), 1u);
}

// These keys mean nothing else.
TEST(Endings, AResultTakesNextRestartAndBackAtOnce) {
    for (const Command command : {Command::Next, Command::Restart, Command::Back}) {
        StageRig rig(StageRig::playing());
        playToTheEnd(rig);
        ASSERT_EQ(rig.stage.screen(), Screen::Over);
        pressOnce(rig, command);
        EXPECT_NE(rig.stage.screen(), Screen::Over);
    }
}

TEST(Screens, EachEndlessRunHasASeedOfItsOwn) {
    StageDef def = StageRig::twoLevels();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> made; // seed, number
    def.endless = [&made](std::uint32_t seed, std::uint32_t number) {
        made.emplace_back(seed, number);
        return glassLevel("Row", {7});
    };
    def.endlessSeed = [next = 40u]() mutable { return ++next; };
    StageRig rig(std::move(def));
    rig.clickItem(Action::Endless);
    playToTheEnd(rig);
    rig.press(Command::Next);
    playToTheEnd(rig);
    rig.clickItem(Action::ToTitle);
    rig.clickItem(Action::Endless);
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    EXPECT_EQ(made, (Pairs{{41, 1}, {41, 2}, {42, 1}}));
}

} // namespace
} // namespace apart
