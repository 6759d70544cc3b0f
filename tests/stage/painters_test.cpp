// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/marks.hpp>
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/painters/backdrop.hpp>
#include <apart/stage/painters/hud.hpp>
#include <apart/stage/records/recording.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "stage_rig.hpp"

namespace apart {
namespace {

/// The drawn primitives without their colours.
std::string shapeOf(const RecordingCanvas& canvas) {
    std::string shape;
    for (const Stroke& stroke : canvas.strokes()) {
        shape += std::to_string(static_cast<int>(stroke.kind)) + " " +
                 std::to_string(stroke.place.x) + " " + std::to_string(stroke.place.y) + " " +
                 std::to_string(stroke.size) + "\n";
    }
    return shape;
}

// Shapes alone distinguish the powers, for colour-blind players.
TEST(Marks, EachPowerHasAUniqueShape) {
    std::set<std::string> shapes;
    std::set<std::string_view> words;
    for (std::size_t i = 1; i < kPowerNames.size(); ++i) {
        RecordingCanvas canvas;
        paintMark(canvas, static_cast<Power>(i), {}, 1, {});
        EXPECT_FALSE(canvas.strokes().empty()) << kPowerNames[i];
        EXPECT_TRUE(shapes.insert(shapeOf(canvas)).second) << kPowerNames[i];
        EXPECT_TRUE(words.insert(wordsOf(static_cast<Power>(i))).second) << kPowerNames[i];
    }
}

TEST(Marks, EachMoodHasAUniqueShape) {
    std::set<std::string> shapes;
    for (const Mood mood : {Mood::Good, Mood::Mixed, Mood::Bad}) {
        RecordingCanvas canvas;
        paintMood(canvas, mood, {}, {1, {}, {}});
        EXPECT_TRUE(shapes.insert(shapeOf(canvas)).second);
    }
}

TEST(Backdrop, EachThemeHasAUniqueLookBetweenTheWalls) {
    std::set<std::string> shapes;
    for (std::size_t i = 0; i < kThemeNames.size(); ++i) {
        SCOPED_TRACE(kThemeNames[i]);
        const auto theme = static_cast<Theme>(i);
        EXPECT_FALSE(lookOf(theme).title.empty());
        RecordingCanvas canvas;
        canvas.begin(layout::kShown, {});
        paintDistance(canvas, theme, 12.5);
        ASSERT_FALSE(canvas.strokes().empty());
        EXPECT_TRUE(shapes.insert(shapeOf(canvas)).second);
        for (const Stroke& stroke : canvas.strokes()) {
            // A stroke may extend beyond the field by less than the thickness of the walls.
            EXPECT_LE(std::abs(stroke.place.x), layout::kRight + layout::kFrame);
        }
    }
}

TEST(Hud, GroupsDigitsByThree) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1 000");
    EXPECT_EQ(grouped(1234567), "1 234 567");
    EXPECT_EQ(grouped(-1000), "-1 000");
}

TEST(Hud, WrapsBetweenWords) {
    EXPECT_EQ(wrapped("one two three", 7), (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(wrapped("word", 2), std::vector<std::string>{"word"});
    EXPECT_EQ(wrapped("gr\u00fcn rot", 8), std::vector<std::string>{"gr\u00fcn rot"}) << "letters";
    EXPECT_TRUE(wrapped("", 5).empty());
}

TEST(Hud, CutsWhatIsTooLong) {
    EXPECT_EQ(shortened("one two", 7), "one two");
    EXPECT_EQ(shortened("one two three", 8), "one t...");
    EXPECT_EQ(shortened("one two three", 7), "one...");
    EXPECT_EQ(shortened("\u00e4\u00f6\u00fc\u00e4\u00f6\u00fc", 5), "\u00e4\u00f6...") << "letters";
    EXPECT_EQ(wrappedInto(2, "one two three four five", 5, 9),
              (std::vector<std::string>{"one two", "three..."}));
    EXPECT_EQ(wrappedInto(2, "one two three", 5, 9),
              (std::vector<std::string>{"one two", "three"}));
}

TEST(Hud, ListsOnlyThePowersOfTheLevel) {
    Level level = *glassLevel("x", {1, 2});
    level.kinds.push_back(level.kinds[0]);
    level.kinds[1].power = Power::Magnet;
    level.cells[1].kind = 1;
    const Game game(level, 1);
    RecordingCanvas canvas;
    canvas.begin(layout::kShown, {});
    paintHud(canvas, game, {});
    EXPECT_TRUE(canvas.says(wordsOf(Power::Magnet)));
    EXPECT_FALSE(canvas.says(wordsOf(Power::Weld)));
}

// A level may have more powers than fit on the panel.
TEST(Hud, ThePowersLeaveTheFootOfThePanelFree) {
    Level level = *glassLevel("x", {1});
    for (std::size_t i = 1; i < kPowerNames.size(); ++i) {
        level.kinds.push_back(level.kinds[0]);
        level.kinds[i].power = static_cast<Power>(i);
        level.cells.push_back({3, static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i)});
    }
    const Game game(level, 1);
    RecordingCanvas canvas;
    canvas.begin(layout::kShown, {});
    HudLook look;
    look.pilot = "REPLAY";
    paintHud(canvas, game, look);
    const auto foot = std::find_if(canvas.strokes().begin(), canvas.strokes().end(),
                                   [](const Stroke& stroke) { return stroke.text == "REPLAY"; });
    ASSERT_NE(foot, canvas.strokes().end());
    for (auto stroke = canvas.strokes().begin(); stroke != foot; ++stroke) {
        EXPECT_GT(stroke->place.y, foot->place.y + foot->size) << stroke->text;
    }
}

TEST(Hud, ShowsTheBallsInReserve) {
    Level level = *glassLevel("x", {1});
    const auto balls = [&](int lives) {
        level.lives = lives;
        const Game game(level, 1);
        RecordingCanvas canvas;
        canvas.begin(layout::kShown, {});
        paintHud(canvas, game, {});
        return std::count_if(canvas.strokes().begin(), canvas.strokes().end(), [](const Stroke& s) {
            return s.kind == Stroke::Kind::Disc && s.place.y == Real(10.1);
        });
    };
    EXPECT_EQ(balls(1), 1); // the one in play
    EXPECT_EQ(balls(3), 3);
    EXPECT_EQ(balls(12), 12);
}

} // namespace
} // namespace apart
