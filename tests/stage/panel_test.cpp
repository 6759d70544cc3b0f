// SPDX-License-Identifier: MIT
// What the panel and the questions of a game say.
#include <apart/core/daily.hpp>
#include <apart/core/endless.hpp>
#include <apart/stage/canvas/palette.hpp>

#include <gtest/gtest.h>

#include <memory>

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

// Regression: of nine balls eight were shown, the last one over the edge.
TEST(Panel, AllBallsFitIntoIt) {
    StageDef def = StageRig::playing();
    Level level = *def.levels[0];
    level.lives = 9;
    def.levels[0] = std::make_shared<const Level>(level);
    StageRig rig(std::move(def));
    ASSERT_EQ(rig.stage.session().game().lives(), 9);
    std::vector<Real> places;
    for (const Stroke& stroke : rig.picture().strokes()) {
        if (stroke.kind == Stroke::Kind::Disc && stroke.place.y == Real(10.1)) {
            places.push_back(stroke.place.x);
        }
    }
    ASSERT_EQ(places.size(), 9u);
    for (std::size_t i = 1; i < places.size(); ++i) {
        EXPECT_GT(places[i] - places[i - 1], 2 * Real(0.2)) << "they overlap";
    }
    EXPECT_LT(places.back() + Real(0.2), layout::kPanelRight);
}

TEST(Panel, TellsTimeNextMedalAndHonours) {
    StageDef def = StageRig::playing();
    MedalMarks marks{def.levels[0]->name, digestOf(*def.levels[0]), {100, 2000, 30000}};
    marks.fewHits = 3;
    marks.oneFall = 9;
    def.marks = {marks};
    StageRig rig(std::move(def));
    const RecordingCanvas& canvas = rig.picture();
    for (const char* text : {"0:00", "bronze from 100", "3 hits at most", "a fall of 9"}) {
        EXPECT_TRUE(canvas.says(text)) << text;
    }
    rig.frames(2 * 60);
    EXPECT_TRUE(rig.picture().says("0:02"));
}

/// Colour of the first text that begins so, in the panel or left of it.
Color colorOf(const RecordingCanvas& canvas, const std::string& text, bool inPanel) {
    for (const Stroke& stroke : canvas.strokes()) {
        if (stroke.text.starts_with(text) && (stroke.place.x > layout::kRight) == inPanel) {
            return stroke.color;
        }
    }
    ADD_FAILURE() << text << " is not told";
    return {};
}

/// A game that makes points and is lost then. Its prize is no other number of the picture: with
/// some seeds it is the score.
std::unique_ptr<StageRig> lostRig(StageDef def) {
    for (def.seed = 1; def.seed <= 20; ++def.seed) {
        auto rig = std::make_unique<StageRig>(def);
        makePoints(*rig);
        for (int i = 0; i < 60 * 120 && rig->stage.screen() == Screen::Playing; ++i) {
            Signals aside;
            aside.leftHeld = true;
            aside.commands = {Command::Launch};
            rig->frame(aside);
        }
        const Game& game = rig->stage.session().game();
        if (game.result() == Result::Lost && game.counts().prize() > 0 &&
            game.counts().prize() != game.score()) {
            return rig;
        }
    }
    return nullptr;
}

// Regression: the prize was that of a won game, and honours and ways that only a won game has were
// lit.
TEST(Panel, OfALostGameAgreesWithItsResult) {
    Level level = *glassLevel("Ten blocks", {1, 2, 3, 5, 6, 8, 9, 11, 12, 13});
    level.ways = {{"by any blow", ""}};
    StageDef def = StageRig::playing();
    def.levels = {std::make_shared<const Level>(level)};
    MedalMarks marks{level.name, digestOf(level), {100, 2000, 30000}};
    marks.fewHits = 1000;
    def.marks = {marks};
    StageRig early(def);
    makePoints(early);
    EXPECT_EQ(colorOf(early.picture(), "1 000 hits", true), palette::kAccent);
    const auto lost = lostRig(std::move(def));
    ASSERT_NE(lost, nullptr) << "no seed loses with a prize";
    StageRig& rig = *lost;
    const Session& session = rig.stage.session();
    ASSERT_EQ(session.game().result(), Result::Lost);
    ASSERT_EQ(rig.stage.screen(), Screen::Over);
    EXPECT_GT(session.game().counts().prize(), 0);
    EXPECT_EQ(session.statistics().points.sum(), session.game().score());
    const RecordingCanvas& canvas = rig.picture();
    EXPECT_FALSE(canvas.says(grouped(session.game().counts().prize())));
    EXPECT_EQ(hudLookOf(rig.stage).ways, 0u);
    for (const bool inPanel : {true, false}) {
        EXPECT_EQ(colorOf(canvas, "1 000 hits", inPanel), palette::kQuiet);
    }
    EXPECT_EQ(colorOf(canvas, "cleared", false), palette::kQuiet);
}

TEST(Results, NamesOfHonoursAreLitIfTheyAreWon) {
    StageDef def = StageRig::playing();
    def.marks = {{def.levels[0]->name, 0, {10, 20, 9999999}, 99, 7}};
    StageRig rig(std::move(def));
    playToTheEnd(rig);
    ASSERT_EQ(rig.stage.session().game().result(), Result::Won);
    const RecordingCanvas& canvas = rig.picture();
    EXPECT_EQ(colorOf(canvas, "cleared", false), palette::kAccent);
    EXPECT_EQ(colorOf(canvas, "a fall of 7", false), palette::kQuiet);
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
