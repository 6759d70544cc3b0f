// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "stage_rig.hpp"

namespace apart {
namespace {

TEST(Screens, TheTitleOffersTheFirstLevelThatIsNotCleared) {
    StageDef def = StageRig::twoLevels();
    def.profile.enter(Mode::Standard, def.levels[0]->name, {50, true, false, false});
    StageRig rig(std::move(def));
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    EXPECT_TRUE(rig.picture().says("Three blocks"));
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().level().name, "test_3");
}

TEST(Screens, ALevelIsChosenByKeys) {
    StageRig rig(StageRig::twoLevels());
    rig.press(Command::Down);
    rig.press(Command::Confirm);
    ASSERT_EQ(rig.stage.screen(), Screen::Levels);
    EXPECT_TRUE(rig.picture().says("One block"));
    rig.press(Command::Right);
    EXPECT_TRUE(rig.picture().says("Three blocks"));
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().level().title, "Three blocks");
}

TEST(Screens, ALevelIsChosenByMouse) {
    StageRig rig(StageRig::twoLevels());
    rig.clickItem(Action::Levels);
    ASSERT_EQ(rig.stage.screen(), Screen::Levels);
    rig.click(rig.stage.levelMap().backPlace().center());
    ASSERT_EQ(rig.stage.screen(), Screen::Title);
    rig.clickItem(Action::Levels);
    rig.click(rig.stage.levelMap().tile(1).center());
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().level().name, "test_3");
}

TEST(Screens, EveryMenuReturnsToItsOrigin) {
    StageRig rig(StageRig::twoLevels());
    rig.clickItem(Action::Options);
    EXPECT_EQ(rig.stage.screen(), Screen::Options);
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    rig.clickItem(Action::Play);
    rig.press(Command::Pause);
    rig.clickItem(Action::Options);
    EXPECT_EQ(rig.stage.screen(), Screen::Options);
    const std::uint32_t before = rig.stage.session().game().ticks();
    rig.frames(10);
    EXPECT_EQ(rig.stage.session().game().ticks(), before); // the game is paused behind them
    rig.clickItem(Action::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
    rig.clickItem(Action::Resume);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    rig.press(Command::Pause);
    rig.clickItem(Action::ToTitle);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    rig.clickItem(Action::Quit);
    EXPECT_FALSE(rig.stage.wantsToQuit());
    EXPECT_TRUE(rig.picture().says("once more to quit"));
    rig.clickItem(Action::Quit);
    EXPECT_TRUE(rig.stage.wantsToQuit());
}

TEST(Screens, EscapeLeavesTheTitleAndTheWindowButtonQuits) {
    StageRig title(StageRig::twoLevels());
    title.press(Command::Back);
    EXPECT_FALSE(title.stage.wantsToQuit());
    title.frames(60 * 3);
    title.press(Command::Back);
    EXPECT_FALSE(title.stage.wantsToQuit()) << "the question has expired";
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
    const std::uint32_t before = rig.stage.session().game().ticks();
    rig.frames(30);
    EXPECT_EQ(rig.stage.session().game().ticks(), before);
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    rig.frames(2);
    EXPECT_GT(rig.stage.session().game().ticks(), before);
}

TEST(Screens, LosingTheFocusPauses) {
    StageRig rig(StageRig::playing());
    Signals away;
    away.focusLost = true;
    rig.frame(away);
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
    EXPECT_TRUE(rig.stage.wantsPointer());
}

TEST(Screens, KeysOfOneFrameAreHandledInOrder) {
    StageRig rig(StageRig::playing());
    Signals all;
    all.commands = {Command::Pause, Command::Up, Command::Confirm}; // the last item: title
    rig.frame(all);
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
}

TEST(Screens, RestartBeginsTheSameLevelAgain) {
    StageRig rig(StageRig::playing());
    rig.frames(50);
    rig.press(Command::Restart);
    EXPECT_LE(rig.stage.session().game().ticks(), 3u);
    EXPECT_EQ(rig.stage.session().game().level().name, "test_1");
}

TEST(Screens, AWonLevelLeadsToTheNext) {
    StageRig rig(StageRig::played());
    rig.untilOver();
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    EXPECT_TRUE(rig.picture().says("Level cleared"));
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().level().name, "test_3");
}

TEST(Screens, AGameWithoutPaddleInputIsLostAndCanBeRestarted) {
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
    const bool lost = rig.stage.session().game().result() == Result::Lost;
    EXPECT_TRUE(rig.picture().says(lost ? "Game over" : "Level cleared"));
    rig.press(Command::Restart);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().level().name, "test_1");
}

TEST(Screens, OptionsStayInTheirRangeAndCanBeReset) {
    StageRig rig(StageRig::twoLevels());
    rig.clickItem(Action::Options); // the first dial is the sound
    rig.press(Command::Up);
    rig.press(Command::Down);
    for (int i = 0; i < 15; ++i) {
        rig.press(Command::Left);
    }
    EXPECT_EQ(rig.stage.records().profile().settings.sound, 0);
    for (int i = 0; i < 15; ++i) {
        rig.press(Command::Right);
    }
    EXPECT_EQ(rig.stage.records().profile().settings.sound, 100);
    EXPECT_TRUE(rig.picture().says("100 %"));
    rig.clickItem(Action::Reset);
    EXPECT_EQ(rig.stage.records().profile().settings.sound, 100) << "it asks once";
    EXPECT_TRUE(rig.picture().says("once more to reset the options"));
    rig.press(Command::Up); // another item: the question is gone
    EXPECT_FALSE(rig.picture().says("once more"));
    rig.clickItem(Action::Reset);
    EXPECT_EQ(rig.stage.records().profile().settings.sound, 100);
    rig.clickItem(Action::Reset);
    EXPECT_EQ(rig.stage.records().profile().settings, Settings{});
    rig.clickItem(Action::Reset);
    EXPECT_FALSE(rig.picture().says("once more")) << "there is nothing to lose";
}

TEST(Screens, SettingsAndResultsAreSaved) {
    std::vector<Profile> kept;
    StageDef def = StageRig::playing();
    def.keeping.save = StageRig::keeping(kept);
    StageRig rig(std::move(def));
    rig.press(Command::Pause);
    rig.clickItem(Action::Options);
    rig.press(Command::Up);
    rig.press(Command::Down);
    rig.press(Command::Left);
    rig.press(Command::Back);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].settings.sound, Settings{}.sound - 10);
}

TEST(Screens, TheScoreOfAGameIsEnteredInItsOwnTable) {
    for (const Mode mode : {Mode::Standard, Mode::Pure, Mode::Assisted}) {
        std::vector<Profile> kept;
        StageDef def = StageRig::playing();
        def.profile.mode = mode;
        def.keeping.save = StageRig::keeping(kept);
        StageRig rig(std::move(def));
        playToTheEnd(rig);
        ASSERT_EQ(rig.stage.screen(), Screen::Over);
        ASSERT_EQ(kept.size(), 1u);
        const Game& game = rig.stage.session().game();
        const Best best = kept[0].bestOf(mode, game.level().name);
        EXPECT_EQ(best.score, game.score());
        EXPECT_EQ(best.cleared, game.result() == Result::Won);
        EXPECT_EQ(kept[0].bestOf(next(mode), game.level().name), Best{});
        EXPECT_EQ(kept[0].bestOf(next(next(mode)), game.level().name), Best{});
    }
}

TEST(Screens, AGameOfThePlayerIsRecordedBitForBit) {
    std::vector<std::pair<ReplayRun, std::string>> kept;
    StageDef def = StageRig::playing();
    def.keeping.keepReplay = [&kept](const ReplayRun& run, const std::string& best) {
        kept.emplace_back(run, best);
        return std::string("It was kept.");
    };
    const std::shared_ptr<const Level> level = def.levels[0];
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    ASSERT_GT(rig.stage.session().game().score(), 0);
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].second, "") << "the last game";
    EXPECT_EQ(kept[1].second, level->name) << "the best one: it is the first";
    EXPECT_EQ(kept[0].first, kept[1].first);
    ASSERT_EQ(kept[0].first.size(), 1u);
    Playback playback(kept[0].first[0], level);
    while (!playback.done()) {
        playback.tick();
    }
    EXPECT_FALSE(playback.divergence());
    EXPECT_EQ(playback.game().result(), rig.stage.session().game().result());
    EXPECT_EQ(playback.game().score(), rig.stage.session().game().score());
    rig.clickItem(Action::ToTitle);
    EXPECT_TRUE(rig.picture().says("It was kept."));
}

TEST(Screens, GamesOfAPilotAreNotSaved) {
    std::vector<Profile> kept;
    StageDef def = StageRig::played();
    def.keeping.save = StageRig::keeping(kept);
    bool recorded = false;
    def.keeping.keepReplay = [&recorded](const ReplayRun&, const std::string&) {
        recorded = true;
        return std::string();
    };
    StageRig rig(std::move(def));
    rig.untilOver();
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_TRUE(kept.empty());
    EXPECT_FALSE(recorded);
}

TEST(Screens, AModeIsChosenOnTheTitleAndShownInTheGame) {
    StageRig rig(StageRig::twoLevels());
    rig.clickItem(Action::Mode);
    EXPECT_EQ(rig.stage.records().profile().mode, Mode::Pure);
    rig.clickItem(Action::Mode);
    EXPECT_EQ(rig.stage.records().profile().mode, Mode::Assisted);
    rig.clickItem(Action::Play);
    EXPECT_EQ(rig.stage.session().game().mode(), Mode::Assisted);
    EXPECT_TRUE(rig.picture().says("ASSISTED"));
}

TEST(Screens, AnyServeKeySkipsTheFanfare) {
    StageRig rig(StageRig::played());
    while (rig.stage.session().game().result() == Result::Playing) {
        rig.frame();
    }
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    rig.frames(10);
    ASSERT_EQ(rig.stage.screen(), Screen::Playing); // during the fanfare
    rig.press(Command::Launch);
    EXPECT_EQ(rig.stage.screen(), Screen::Over);
    const std::size_t heard = rig.speaker.notes.size();
    rig.frames(120);
    EXPECT_TRUE(std::none_of(rig.speaker.notes.begin() + std::ptrdiff_t(heard),
                             rig.speaker.notes.end(),
                             [](const Note& note) { return note.voice == Voice::Cleared; }));
}

TEST(Screens, TheBotPlaysADemoWithoutInput) {
    StageDef def = StageRig::twoLevels();
    def.bot = [](const Game& game) { return std::optional(bot(game)); };
    StageRig rig(std::move(def));
    EXPECT_FALSE(rig.stage.attracting());
    EXPECT_TRUE(rig.picture().says("Options"));
    rig.frames(60 * 25);
    EXPECT_TRUE(rig.stage.attracting());
    EXPECT_FALSE(rig.picture().says("Options"));
    EXPECT_TRUE(rig.speaker.notes.empty());
    rig.press(Command::Confirm); // only restores the menu
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
    EXPECT_FALSE(rig.stage.attracting());
    rig.frames(60 * 25);
    ASSERT_TRUE(rig.stage.attracting());
    Signals meaningless;
    meaningless.anyKey = true;
    rig.frame(meaningless);
    EXPECT_FALSE(rig.stage.attracting());
}

TEST(Screens, AnEndlessRunContinuesAndSumsItsScores) {
    std::vector<Profile> kept;
    StageDef def = StageRig::twoLevels();
    def.keeping.save = StageRig::keeping(kept);
    def.endless = [](std::uint32_t, std::uint32_t number) {
        return glassLevel(number == 1 ? "Row 1" : "Row 2", {7});
    };
    std::vector<std::pair<ReplayRun, std::string>> recorded;
    def.keeping.keepReplay = [&recorded](const ReplayRun& run, const std::string& best) {
        recorded.emplace_back(run, best);
        return std::string();
    };
    StageRig rig(std::move(def));
    rig.clickItem(Action::Endless);
    ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_TRUE(rig.picture().says("ENDLESS 1"));
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    const std::int32_t first = rig.stage.session().game().score();
    rig.press(Command::Next);
    EXPECT_EQ(rig.stage.session().game().level().title, "Row 2");
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_EQ(kept.back().bestOf(Mode::Standard, "endless").score,
              first + rig.stage.session().game().score());
    // The whole run is recorded, level by level.
    ASSERT_EQ(recorded.size(), 4u);
    EXPECT_EQ(recorded[1].first.size(), 1u);
    EXPECT_EQ(recorded[3].first.size(), 2u);
    EXPECT_EQ(recorded[3].second, kEndlessKey);
    EXPECT_EQ(recorded[3].first[0], recorded[1].first[0]);
    rig.clickItem(Action::ToTitle);
    EXPECT_TRUE(rig.picture().says("Endless   best"));
    rig.clickItem(Action::Play);
    playToTheEnd(rig);
    EXPECT_EQ(recorded.back().first.size(), 1u) << "a later game is not a part of it";
}

TEST(Screens, AnEndlessRunRestartsAtItsFirstLevel) {
    StageDef def = StageRig::twoLevels();
    def.endless = [](std::uint32_t, std::uint32_t number) {
        return glassLevel(number == 4 ? "Row 4" : "Another", {7});
    };
    def.firstEndless = 4;
    StageRig rig(std::move(def));
    ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_TRUE(rig.picture().says("ENDLESS 4"));
    playToTheEnd(rig);
    rig.press(Command::Next);
    EXPECT_EQ(rig.stage.session().game().level().title, "Another");
    rig.press(Command::Restart);
    EXPECT_TRUE(rig.picture().says("once more to start again")) << "the run has points";
    rig.press(Command::Restart);
    EXPECT_EQ(rig.stage.session().game().level().title, "Row 4");
}

/// A recorded game of this level without input.
StageDef showing(std::shared_ptr<const Level> level) {
    StageDef def = StageRig::twoLevels();
    def.seed = 70;
    def.show = Show{std::move(level), 8, Mode::Pure, [](const Game& game) {
                        return game.ticks() < 100 ? std::optional(Input{}) : std::nullopt;
                    }};
    return def;
}

// Regression: LEVEL 3 OF 3 was shown for a level outside the list.
TEST(Screens, ARecordedGameShowsTheNumberOfItsLevel) {
    StageRig listed(showing(StageRig::twoLevels().levels[1]));
    EXPECT_TRUE(listed.picture().says("LEVEL 2 OF 2"));
    StageRig alone(showing(glassLevel("Another", {1, 2, 3, 4})));
    EXPECT_TRUE(alone.picture().says("A LEVEL OF ITS OWN"));
    Level endless = *glassLevel("Row", {1});
    endless.name = "endless:7:12";
    StageRig row(showing(std::make_shared<const Level>(endless)));
    EXPECT_TRUE(row.picture().says("ENDLESS 12"));
}

// Regression: later games were played by the recorded inputs, and watching again used another seed.
TEST(Screens, ARecordedGameCanBeReplayedAndLaterGamesUsePlayerInput) {
    std::vector<Profile> kept;
    StageDef def = showing(StageRig::twoLevels().levels[0]);
    def.keeping.save = StageRig::keeping(kept);
    StageRig rig(std::move(def));
    EXPECT_TRUE(rig.picture().says("REPLAY"));
    rig.untilOver();
    EXPECT_TRUE(rig.picture().says("The replay ends"));
    EXPECT_TRUE(rig.picture().says("Watch again"));
    rig.clickItem(Action::Restart);
    EXPECT_EQ(rig.stage.session().game().seed(), 8u);
    EXPECT_EQ(rig.stage.session().game().mode(), Mode::Pure);
    rig.untilOver();
    EXPECT_TRUE(kept.empty());
    rig.clickItem(Action::ToTitle);
    rig.clickItem(Action::Play);
    EXPECT_EQ(rig.stage.session().game().seed(), 70u);
    EXPECT_EQ(rig.stage.session().game().mode(), Mode::Standard);
    EXPECT_FALSE(rig.picture().says("REPLAY"));
    rig.frames(200);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing); // waits for the serve
}

TEST(Screens, WithoutEndlessLevelsNoneAreOffered) {
    StageRig rig(StageRig::twoLevels());
    EXPECT_FALSE(rig.picture().says("Endless"));
}

// The first game has the requested seed, however many games the bot has shown before.
TEST(Screens, TheFirstGameHasTheRequestedSeed) {
    StageDef def = StageRig::twoLevels();
    def.seed = 70;
    def.bot = [](const Game& game) { return std::optional(bot(game)); };
    StageRig rig(std::move(def));
    rig.frames(60 * 150);     // longer than one game of the bot
    rig.press(Command::Down); // restores the menu
    rig.clickItem(Action::Play);
    EXPECT_EQ(rig.stage.session().game().seed(), 70u);
}

TEST(Screens, ANoticeIsShownOnTheTitle) {
    StageDef def = StageRig::twoLevels();
    def.notices = {"Scores are reset."};
    StageRig rig(std::move(def));
    EXPECT_TRUE(rig.picture().says("Scores are reset."));
}

// An earlier notice stays when another one is added; an equal one is not repeated.
TEST(Screens, NoticesAreStackedOnTheTitle) {
    StageDef def = StageRig::playing();
    def.levels = {glassLevel("Three blocks", {2, 7, 12})};
    def.bot = [](const Game&) { return std::optional(Input{.launch = true}); };
    def.notices = {"Scores are reset."};
    def.keeping.save = [](const Profile&) { return std::string("Scores are not kept."); };
    def.keeping.keepReplay = [](const ReplayRun&, const std::string&) {
        return std::string("The game is not recorded.");
    };
    StageRig rig(std::move(def));
    for (int game = 0; game < 2; ++game) { // lost without a move
        while (rig.stage.screen() == Screen::Playing) {
            rig.press(Command::Launch);
        }
        ASSERT_EQ(rig.stage.session().game().result(), Result::Lost);
        rig.clickItem(game == 0 ? Action::Restart : Action::ToTitle);
    }
    std::vector<Real> heights;
    for (const Stroke& stroke : rig.picture().strokes()) {
        for (const char* notice :
             {"Scores are reset.", "Scores are not kept.", "The game is not recorded."}) {
            if (stroke.text == notice) {
                heights.push_back(stroke.place.y);
            }
        }
    }
    ASSERT_EQ(heights.size(), 3u);
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i) {
        EXPECT_GT(heights[i] - heights[i - 1], Real(0.42)); // the letter height
    }
}

// The score is lost on this screen; the title comes later, or never.
TEST(Screens, WhatCannotBeKeptIsToldOnTheResults) {
    StageDef def = StageRig::playing();
    bool full = true;
    def.keeping.save = [&full](const Profile&) {
        return std::string(full ? "Scores are not kept: the disk is full." : "");
    };
    StageRig rig(std::move(def));
    rig.frames(10);
    EXPECT_FALSE(rig.picture().says("Scores are not kept"));
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_TRUE(rig.picture().says("Scores are not kept: the disk is full."));
    full = false;
    rig.press(Command::Restart);
    playToTheEnd(rig);
    EXPECT_FALSE(rig.picture().says("Scores are not kept"));
}

} // namespace
} // namespace apart
