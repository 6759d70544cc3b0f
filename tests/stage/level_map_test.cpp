// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/theme_look.hpp>
#include <apart/stage/records/recording.hpp>
#include <apart/stage/screens/level_map.hpp>

#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

/// Eight levels of the first theme in two rows, and three of another theme.
LevelList elevenLevels() {
    LevelList levels;
    for (int i = 0; i < 11; ++i) {
        Level level = *glassLevel("x", {7});
        level.name = "level_" + std::to_string(i);
        level.title = "Title " + std::to_string(i);
        level.theme = i < 8 ? Theme::Daybreak : Theme::Harbour;
        levels.push_back(std::make_shared<const Level>(level));
    }
    return levels;
}

void press(LevelMap& map, Command command) {
    Signals signals;
    signals.commands = {command};
    EXPECT_FALSE(map.take(signals));
}

TEST(LevelMap, ArrowsFollowTheWayWhereItTurns) {
    LevelMap map(elevenLevels());
    press(map, Command::Left); // no level before the first
    EXPECT_EQ(map.chosen(), 0u);
    for (int i = 0; i < 8; ++i) {
        press(map, Command::Right);
    }
    EXPECT_EQ(map.chosen(), 8u) << "the first of the next theme, above the last one";
    EXPECT_LT(std::abs(map.tile(8).center().x - map.tile(7).center().x), Real(0.1));
    press(map, Command::Left); // there the way leads to the left
    EXPECT_EQ(map.chosen(), 9u);
    press(map, Command::Left);
    press(map, Command::Left); // no level after the last
    EXPECT_EQ(map.chosen(), 10u);
    press(map, Command::Down); // to the nearest one below
    EXPECT_EQ(map.chosen(), 0u);
    press(map, Command::Down);
    EXPECT_EQ(map.chosen(), 0u);
    press(map, Command::Up);
    EXPECT_EQ(map.chosen(), 10u);
    press(map, Command::Up);
    EXPECT_EQ(map.chosen(), 10u);
}

TEST(LevelMap, NoTwoLevelsOverlapAndEachCanBeClicked) {
    LevelMap map(elevenLevels());
    for (std::size_t i = 0; i < 11; ++i) {
        for (std::size_t other = 0; other < i; ++other) {
            EXPECT_FALSE(overlap(map.tile(i), map.tile(other))) << i << " " << other;
        }
        Signals click;
        click.pointer = click.pointerNow = map.tile(i).center();
        click.clicked = true;
        EXPECT_EQ(map.take(click), std::optional(i));
    }
    Signals aside;
    aside.pointer = aside.pointerNow = {0, 18};
    aside.clicked = true;
    EXPECT_FALSE(map.take(aside));
}

// Regression: the level over which a pointer passed on its way to a button was the chosen one.
TEST(LevelMap, APointerThatPassesShowsALevelAndOneThatRestsChoosesIt) {
    LevelMap map(elevenLevels());
    double now = 0;
    const auto move = [&](Vec2 place) {
        Signals signals;
        signals.pointer = signals.pointerNow = place;
        map.point(signals, now += 0.1);
    };
    const auto rest = [&](double seconds) { map.point({}, now += seconds); };
    map.choose(9);
    for (const std::size_t level : {5u, 4u, 3u}) {
        move(map.tile(level).center());
        EXPECT_EQ(map.shown(), level);
        rest(0.1);
        EXPECT_EQ(map.chosen(), 9u);
    }
    move(map.editPlace().center());
    EXPECT_EQ(map.shown(), 9u) << "the card is that of the chosen level again";
    rest(1);
    EXPECT_EQ(map.chosen(), 9u);
    move(map.tile(4).center());
    rest(0.45);
    EXPECT_EQ(map.chosen(), 4u);
    move(map.tile(6).center());
    press(map, Command::Right); // from the one that is shown
    EXPECT_EQ(map.chosen(), 7u);
    rest(1);
    EXPECT_EQ(map.chosen(), 7u) << "the pointer has not moved since";
    Signals click;
    click.clicked = true;
    click.pointerNow = map.tile(2).center();
    EXPECT_EQ(map.take(click), std::optional<std::size_t>(2));
    EXPECT_EQ(map.chosen(), 2u);
}

TEST(LevelMap, ABandOfManyLevelsMovesAlongWithTheChosenOne) {
    LevelList levels(40, glassLevel("x", {7}));
    LevelMap map(levels, {{}, 1}); // all but the first are the player's
    const auto inSight = [&](std::size_t level) { return map.tile(level).center().x < 100; };
    EXPECT_TRUE(inSight(1));
    EXPECT_FALSE(inSight(39));
    for (int i = 0; i < 39; ++i) {
        press(map, i == 0 ? Command::Up : Command::Left);
        EXPECT_TRUE(inSight(map.chosen())) << i;
    }
    EXPECT_EQ(map.chosen(), 39u);
    EXPECT_FALSE(inSight(1));
    map.choose(1);
    EXPECT_TRUE(inSight(1));
}

TEST(LevelMap, AClosedLevelIsShownWithWhatItAsksForAndCannotBePlayed) {
    static constexpr std::array<std::string_view, 1> kOne = {"level_7"};
    LevelMap map(elevenLevels(), {kOne});
    Records records({}, {}, {}, {});
    map.update(records);
    for (int i = 0; i < 3; ++i) {
        press(map, Command::Right);
    }
    ASSERT_EQ(map.chosen(), 3u);
    press(map, Command::Confirm);
    Signals click;
    click.pointerNow = map.tile(3).center();
    click.clicked = true;
    EXPECT_FALSE(map.take(click));
    const auto says = [&](const char* text) {
        RecordingCanvas canvas;
        canvas.begin({{-16, 0}, {16, 20}}, {});
        map.draw(canvas, records, 0);
        return canvas.says(text);
    };
    EXPECT_TRUE(says("2 more medals"));
    EXPECT_FALSE(says("Only for tests."));
    records.profile().settings.openLevels = 1;
    map.update(records);
    EXPECT_TRUE(says("Only for tests."));
    EXPECT_EQ(map.take(click), std::optional<std::size_t>(3));
}

TEST(LevelMap, ShowsThemeTitleIdeaBestScoresAndProgress) {
    LevelMap map(elevenLevels());
    map.choose(8);
    Records records({}, {}, {}, {});
    records.enter({{Mode::Standard, "level_8"}, {12300, true, false, false}, {}});
    records.enter({{Mode::Pure, "level_8"}, {4500, false, false, false}, {}});
    RecordingCanvas canvas;
    canvas.begin({{-16, 0}, {16, 20}}, {});
    map.draw(canvas, records, 0);
    for (const char* text :
         {"Title 8", "Only for tests.", "12 300", "4 500", "1 of 11 cleared, 12 300 points"}) {
        EXPECT_TRUE(canvas.says(text)) << text;
    }
    EXPECT_TRUE(canvas.says(lookOf(Theme::Daybreak).title));
    EXPECT_TRUE(canvas.says(lookOf(Theme::Harbour).title));
    // Medals, and what is cleared, count for all modes; points for one.
    records.profile().mode = Mode::Assisted;
    RecordingCanvas assisted;
    assisted.begin({{-16, 0}, {16, 20}}, {});
    map.draw(assisted, records, 0);
    EXPECT_TRUE(assisted.says("1 of 11 cleared, 0 points by assisted rules"));
}

// Regression: a level of one block that a player had written counted as a medal of the game.
TEST(LevelMap, MedalsAtTheTopAreThoseOfTheGame) {
    for (const std::size_t own : {std::size_t{8}, std::size_t{11}}) {
        LevelMap map(elevenLevels(), {.own = own});
        Records records({}, {}, {}, {});
        for (int i = 0; i < 11; ++i) {
            records.enter({{Mode::Standard, "level_" + std::to_string(i)}, {100, true}, {}});
        }
        map.update(records);
        RecordingCanvas canvas;
        canvas.begin({{-16, 0}, {16, 20}}, {});
        map.draw(canvas, records, 0);
        const auto& strokes = canvas.strokes();
        EXPECT_TRUE(std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
            return stroke.place.y > Real(16.7) && stroke.text == std::to_string(own);
        })) << own;
    }
}

TEST(LevelMap, NamesTheHonourUnderThePointer) {
    LevelMap map(elevenLevels());
    const Records records({}, {}, {}, {});
    const auto seen = [&](Vec2 pointer) {
        Signals signals;
        signals.pointer = pointer;
        map.point(signals, 0);
        RecordingCanvas canvas;
        canvas.begin({{-16, 0}, {16, 20}}, {});
        map.draw(canvas, records, 0);
        return canvas.says("no ball lost");
    };
    EXPECT_FALSE(seen({0, 0}));
    int places = 0; // of a grid of half a metre, right of the tiles
    for (Real x = 4; x < 15; x += Real(0.5)) {
        for (Real y = 0; y < 16; y += Real(0.5)) {
            places += seen({x, y}) ? 1 : 0;
        }
    }
    EXPECT_GE(places, 2) << "in both columns";
    EXPECT_LE(places, 8);
}

} // namespace
} // namespace apart
