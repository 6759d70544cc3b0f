// SPDX-License-Identifier: MIT
// What a replay shows at its end, and where it differs from its recording.
#include <gtest/gtest.h>

#include <cmath>

#include "stage_rig.hpp"

namespace apart {
namespace {

/// A show of a recorded game.
Show showing(const std::shared_ptr<const Level>& level, const Replay& replay) {
    return Show{level,
                replay.seed,
                replay.mode,
                [replay](const Game& game) {
                    return game.ticks() < replay.end ? std::optional(inputAt(replay, game.ticks()))
                                                     : std::nullopt;
                },
                replay.end,
                {},
                replay.hashes};
}

StageDef watching(const std::shared_ptr<const Level>& level, const Replay& replay) {
    StageDef def = StageRig::twoLevels();
    def.show = showing(level, replay);
    return def;
}

// Regression: the game went on without input, behind the result.
TEST(ReplayEnd, AGameThatWasLeftStandsStillAtItsLastRecordedTick) {
    const auto level = glassLevel("A row", {2, 4, 6, 8, 10, 12});
    const Replay replay = recordedGame(level, 3, 600);
    Playback played(replay, level);
    while (!played.done()) {
        played.tick();
    }
    ASSERT_EQ(played.game().result(), Result::Playing);
    StageRig rig(watching(level, replay));
    rig.untilOver();
    rig.frames(60 * 20);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_EQ(rig.stage.session().game().stateHash(), played.game().stateHash());
    EXPECT_TRUE(rig.picture().says("in 0:05"));
    EXPECT_TRUE(rig.picture().says("0:05 of 0:05"));
}

TEST(ReplayEnd, ThePictureStandsStillThere) {
    const auto level = glassLevel("A row", {2, 4, 6, 8, 10, 12});
    StageRig rig(watching(level, recordedGame(level, 3, 600)));
    while (rig.stage.session().game().ticks() < 600) {
        rig.frame();
    }
    rig.frames(5);
    ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    const Real shown =
        rig.stage.session().game().world()[rig.stage.session().game().balls()[0].body].position().x;
    const auto ball = [&] {
        const auto& strokes = rig.picture().strokes();
        return std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
            return std::abs(stroke.place.x - shown) < Real(1e-4);
        });
    };
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(ball()) << "not between two ticks";
        rig.frame({}, 0.4 / kTicksPerSecond);
    }
}

TEST(ReplayEnd, AGameTakenOverAtTheEndGoesOn) {
    const auto level = glassLevel("A row", {2, 4, 6, 8, 10, 12});
    StageRig rig(watching(level, recordedGame(level, 3, 600)));
    while (rig.stage.session().game().ticks() < 600) {
        rig.frame();
    }
    rig.frames(30);
    rig.press(Command::Confirm); // takes over
    rig.press(Command::Confirm); // goes on
    rig.frames(120);
    EXPECT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_GT(rig.stage.session().game().ticks(), 700u);
}

// Regression: of a game that is over before its recording ends, the clock went on.
TEST(ReplayEnd, TheClockStopsWhenTheGameIsOver) {
    const auto level = glassLevel("One block", {7});
    Replay replay = recordedGame(level, 3);
    const std::uint32_t over = replay.end;
    replay.end += 20 * kTicksPerSecond;
    StageRig rig(watching(level, replay));
    rig.untilOver();
    rig.frames(60 * 5);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    const std::uint32_t seconds = (over - 1) / kTicksPerSecond;
    const std::string clock = std::to_string(seconds / 60) + (seconds % 60 < 10 ? ":0" : ":") +
                              std::to_string(seconds % 60) + " of ";
    EXPECT_TRUE(rig.picture().says(clock)) << clock;
}

// Regression: it was played to its end without a word.
TEST(ReplayEnd, ADivergenceFromTheRecordingIsToldOnce) {
    const auto level = glassLevel("A row", {2, 4, 6, 8, 10, 12});
    Replay replay = recordedGame(level, 3, 1500);
    for (HashMark& mark : replay.hashes) {
        mark.hash ^= mark.tick >= 840 ? 1 : 0;
    }
    const std::string sentence = "The replay diverges from the recording at 0:07.";
    StageRig rig(watching(level, replay));
    while (rig.stage.session().game().ticks() < 838) {
        EXPECT_FALSE(rig.picture().says("diverges"));
        rig.frame();
    }
    rig.frames(10);
    EXPECT_TRUE(rig.picture().says(sentence));
    rig.frames(60 * 5);
    ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_FALSE(rig.picture().says("diverges")) << "it covers the field for a while only";
    rig.untilOver();
    EXPECT_TRUE(rig.picture().says(sentence)) << "beside the result";

    rig.clickItem(Action::Restart);
    rig.press(Command::Pause);
    rig.press(Command::Right);
    EXPECT_FALSE(rig.picture().says("diverges"));
    rig.press(Command::Right);
    EXPECT_TRUE(rig.picture().says(sentence)) << "also of ticks that were skipped";
}

TEST(ReplayEnd, OfARecordedGameNothingIsSaid) {
    const auto level = glassLevel("One block", {7});
    StageRig rig(watching(level, recordedGame(level, 3)));
    while (rig.stage.screen() == Screen::Playing) {
        ASSERT_FALSE(rig.picture().says("diverges"));
        rig.frame();
    }
    rig.frames(5);
    EXPECT_FALSE(rig.picture().says("diverges"));
}

} // namespace
} // namespace apart
