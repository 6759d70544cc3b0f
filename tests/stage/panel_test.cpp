// SPDX-License-Identifier: MIT
// What the panel and the questions of a game say.
#include <apart/core/daily.hpp>
#include <apart/core/endless.hpp>
#include <apart/stage/canvas/palette.hpp>

#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

// Regression: the balls in reserve were rings, which look like lost ones.
TEST(Panel, HasAFilledDotForEachBall) {
    StageRig rig(StageRig::playing());
    const auto inRow = [&](Stroke::Kind kind) {
        const auto& strokes = rig.picture().strokes();
        return std::count_if(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
            return stroke.kind == kind && stroke.place.y == Real(10.1) &&
                   stroke.color.r == palette::kBall.r;
        });
    };
    ASSERT_EQ(rig.stage.session().game().lives(), 3);
    EXPECT_EQ(inRow(Stroke::Kind::Disc), 3);
    EXPECT_EQ(inRow(Stroke::Kind::Ring), 0);
}

TEST(Panel, TellsTimeNextMedalAndHonours) {
    StageDef def = StageRig::playing();
    MedalMarks marks{def.levels[0]->name, digestOf(*def.levels[0]), {100, 2000, 30000}};
    marks.fewHits = 3;
    marks.oneFall = 9;
    def.marks = {marks};
    StageRig rig(std::move(def));
    const RecordingCanvas& canvas = rig.picture();
    for (const char* text : {"0:00", "bronze from 100", "3 hits at most", "9 in one fall"}) {
        EXPECT_TRUE(canvas.says(text)) << text;
    }
    rig.frames(2 * 60);
    EXPECT_TRUE(rig.picture().says("0:02"));
}

// Regression: it was ENDLESS 1 there.
TEST(Panel, ADailyRunHasItsNameInItsReplayToo) {
    Level level = *glassLevel("Row", {7});
    level.name = EndlessName{20261126, 2}.text();
    StageDef def = StageRig::twoLevels();
    def.show = Show{std::make_shared<const Level>(level), 1, Mode::Standard,
                    [](const Game&) { return std::optional(Input{}); }, 6000};
    def.show->day = 20261126;
    StageRig rig(std::move(def));
    EXPECT_TRUE(rig.picture().says("Daily run 2026-11-26, level 2"));
    rig.press(Command::Confirm); // takes over
    EXPECT_TRUE(rig.picture().says("Daily run 2026-11-26, level 2"));
}

} // namespace
} // namespace apart
