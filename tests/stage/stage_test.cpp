// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/palette.hpp>

#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

TEST(Stage, TheFrameRateDoesNotChangeTheGame) {
    StageRig slow(StageRig::played());
    StageRig fast(StageRig::played());
    while (slow.stage.session().game().ticks() < 300) {
        slow.frame({}, 1.0 / 30);
    }
    while (fast.stage.session().game().ticks() < slow.stage.session().game().ticks()) {
        fast.frame({}, 1.0 / 240);
    }
    EXPECT_EQ(slow.stage.session().game().stateHash(), fast.stage.session().game().stateHash());
}

// Accessibility: the same game at a lower speed.
TEST(Stage, TheGameRunsAtTheChosenSpeed) {
    std::vector<std::uint32_t> ticks;
    for (const int percent : {100, 50}) {
        StageDef def = StageRig::playedStraight();
        def.profile.settings.speed = percent;
        StageRig rig(std::move(def));
        rig.frames(60);
        ticks.push_back(rig.stage.session().game().ticks());
    }
    EXPECT_NEAR(ticks[0], kTicksPerSecond, 1);
    EXPECT_NEAR(ticks[1], kTicksPerSecond / 2, 1);
}

TEST(Stage, AfterAStallTheGameSlowsDownInsteadOfCatchingUp) {
    StageRig rig(StageRig::playing());
    rig.frame({}, 60.0);
    EXPECT_LE(rig.stage.session().game().ticks(), 12u); // 0.1 s
}

TEST(Stage, NothingInTheFieldIsDrawnOverABall) {
    StageRig rig(StageRig::playedStraight());
    int seen = 0;
    for (int i = 0; i < 200; ++i) {
        rig.frame();
        const Game& game = rig.stage.session().game();
        if (game.balls().size() != 1 || game.serving()) {
            continue;
        }
        ++seen;
        const std::vector<Stroke>& strokes = rig.picture().strokes();
        // A ball is the last outline in ink, as wide as two rims, and its body.
        const auto ball = std::find_if(strokes.rbegin(), strokes.rend(), [](const Stroke& stroke) {
            return stroke.kind == Stroke::Kind::Outline && stroke.color == palette::kInk;
        });
        ASSERT_NE(ball, strokes.rend());
        const Vec2 center = game.world()[game.balls()[0].body].center();
        ASSERT_LT(length(ball->place - center), 2 * kBallRadius);
        for (auto after = strokes.rbegin(); after != ball; ++after) {
            if (after->place.x > kFieldWidth / 2) {
                continue; // the panel
            }
            // Only the body and its highlight follow.
            EXPECT_LT(length(after->place - ball->place), 3 * kBallRadius);
        }
    }
    EXPECT_GT(seen, 50);
}

TEST(Stage, EventsCauseSounds) {
    StageRig rig(StageRig::played());
    rig.frames(60 * 5);
    const auto heard = [&](Voice voice) {
        return std::any_of(rig.speaker.notes.begin(), rig.speaker.notes.end(),
                           [&](const Note& note) { return note.voice == voice; });
    };
    EXPECT_TRUE(heard(Voice::Serve));
    for (const Note& note : rig.speaker.notes) {
        EXPECT_GT(note.volume, 0);
        EXPECT_LE(note.volume, 1);
        EXPECT_GT(note.pitch, 0);
    }
}

TEST(Stage, AHeldServeIsAimedByTheMouseAndServedWhenReleased) {
    StageRig rig(StageRig::playing());
    rig.frames(30);
    const Vec2 before = rig.stage.session().game().serveHeading();
    Signals held;
    held.serveHeld = true;
    held.clicked = true;
    rig.frame(held);
    held.clicked = false;
    held.moved = 3;
    rig.frame(held);
    held.moved = 0;
    rig.frame(held);
    EXPECT_TRUE(rig.stage.session().game().serving());
    const Vec2 aimed = rig.stage.session().game().serveHeading();
    EXPECT_GT(aimed.x, before.x + Real(0.1));
    rig.frames(2);
    EXPECT_FALSE(rig.stage.session().game().serving());
    EXPECT_EQ(rig.stage.session().game().serveHeading(), aimed);
}

TEST(Stage, SpaceServesAndTheHeldKeyMovesThePaddle) {
    StageRig rig(StageRig::playing());
    rig.frames(5);
    EXPECT_TRUE(rig.stage.session().game().serving());
    EXPECT_TRUE(rig.picture().says("space or click to serve"));
    rig.press(Command::Launch);
    rig.frames(2);
    EXPECT_FALSE(rig.stage.session().game().serving());

    const auto paddleX = [&] {
        const Game& game = rig.stage.session().game();
        return game.world()[game.paddle()].position().x;
    };
    const Real before = paddleX();
    Signals held;
    held.rightHeld = true;
    for (int i = 0; i < 12; ++i) {
        rig.frame(held);
    }
    EXPECT_GT(paddleX(), before + 1);
}

TEST(Stage, ThePaddleMovesAsFarAsTheMouse) {
    StageRig rig(StageRig::playing());
    Signals moved;
    moved.moved = -6;
    rig.frame(moved);
    rig.frames(60);
    const Game& game = rig.stage.session().game();
    EXPECT_NEAR(game.world()[game.paddle()].position().x, -6, 0.1f);
}

TEST(Stage, APilotThatIsDoneEndsTheGame) {
    StageDef def = StageRig::playing();
    def.pilot = [](const Game& game) {
        return game.ticks() < 100 ? std::optional(Input{}) : std::nullopt;
    };
    StageRig rig(std::move(def));
    rig.frames(60 * 3);
    EXPECT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_TRUE(rig.picture().says("The replay ends"));
}

// A3: ball, paddle, walls and blocks in a window.
TEST(Stage, ScriptedControlsPlayTheGame) {
    StageRig rig(StageRig::twoLevels());
    ScriptedControls controls;
    controls.script.resize(3);
    controls.script[0].commands = {Command::Confirm};
    controls.script[2].commands = {Command::Pause};
    for (int i = 0; i < 5; ++i) {
        rig.frame(controls.poll());
    }
    EXPECT_EQ(rig.stage.screen(), Screen::Paused);
}

} // namespace
TEST(Stage, ShowsAllErrorsOfAnEditedLevelFile) {
    StageDef def = StageRig::playing();
    std::size_t count = 21;
    def.reload = [&] {
        LevelChange change;
        for (std::size_t i = 0; i < count; ++i) {
            change.errors.push_back("fault number " + std::to_string(i));
        }
        return std::optional(change);
    };
    StageRig rig(std::move(def));
    rig.frames(60);
    EXPECT_TRUE(rig.picture().says("fault number 0"));
    EXPECT_TRUE(rig.picture().says("fault number 20"));
    EXPECT_FALSE(rig.picture().says("..."));
    count = 99;
    rig.frames(60);
    EXPECT_TRUE(rig.picture().says("..."));
    EXPECT_FALSE(rig.picture().says("fault number 98")) << "below the picture";
}

/// True if points rise in the field.
bool showsPoints(const RecordingCanvas& canvas) {
    return std::any_of(canvas.strokes().begin(), canvas.strokes().end(), [](const Stroke& stroke) {
        return stroke.text.size() > 1 && stroke.text[0] == '+';
    });
}

TEST(Stage, WordsOfTheGameAreNotReadThroughAMenu) {
    StageDef def = StageRig::twoLevels();
    def.levels = {glassLevel("Many", {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})};
    def.bot = [](const Game& game) { return std::optional(bot(game)); };
    StageRig rig(std::move(def));
    rig.frames(60 * 21);
    ASSERT_TRUE(rig.stage.attracting());
    for (int i = 0; i < 60 * 60 && !showsPoints(rig.picture()); ++i) {
        rig.frame();
    }
    EXPECT_TRUE(showsPoints(rig.picture())) << "without a menu";
    rig.press(Command::Down); // restores the menu
    ASSERT_FALSE(rig.stage.attracting());
    EXPECT_FALSE(showsPoints(rig.picture()));
    rig.clickItem(Action::Play);
    makePoints(rig);
    EXPECT_TRUE(showsPoints(rig.picture()));
    rig.press(Command::Pause);
    EXPECT_FALSE(showsPoints(rig.picture()));
}

} // namespace apart
