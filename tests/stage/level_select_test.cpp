// SPDX-License-Identifier: MIT
#include <apart/stage/level_select.hpp>
#include <apart/stage/recording.hpp>
#include <apart/stage/theme_look.hpp>

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

void press(LevelSelect& select, Command command) {
    Signals signals;
    signals.commands = {command};
    EXPECT_FALSE(select.take(signals));
}

TEST(LevelSelect, ArrowsMoveThroughRowsOfUnequalLength) {
    LevelSelect select(elevenLevels());
    press(select, Command::Left); // no level before the first
    EXPECT_EQ(select.chosen(), 0u);
    for (int i = 0; i < 4; ++i) {
        press(select, Command::Right);
    }
    EXPECT_EQ(select.chosen(), 4u);
    press(select, Command::Down); // the second row has two levels
    EXPECT_EQ(select.chosen(), 7u);
    press(select, Command::Down); // the next theme starts a new row
    EXPECT_EQ(select.chosen(), 9u);
    press(select, Command::Down);
    EXPECT_EQ(select.chosen(), 9u);
    press(select, Command::Right);
    press(select, Command::Right); // no level after the last
    EXPECT_EQ(select.chosen(), 10u);
    press(select, Command::Up);
    press(select, Command::Up);
    EXPECT_EQ(select.chosen(), 1u);
}

TEST(LevelSelect, NoTwoTilesOverlapAndEachCanBeClicked) {
    LevelSelect select(elevenLevels());
    for (std::size_t i = 0; i < 11; ++i) {
        for (std::size_t other = 0; other < i; ++other) {
            EXPECT_FALSE(overlap(select.tile(i), select.tile(other))) << i << " " << other;
        }
        Signals click;
        click.pointer = click.pointerNow = select.tile(i).center();
        click.clicked = true;
        EXPECT_EQ(select.take(click), std::optional(i));
    }
    Signals aside;
    aside.pointer = aside.pointerNow = {0, 18};
    aside.clicked = true;
    EXPECT_FALSE(select.take(aside));
}

TEST(LevelSelect, HiddenRowsScrollIntoViewWhenChosen) {
    LevelList levels;
    for (int theme = 0; theme < 7; ++theme) {
        Level level = *glassLevel("x", {7});
        level.theme = static_cast<Theme>(theme);
        levels.push_back(std::make_shared<const Level>(level));
    }
    LevelSelect select(levels);
    const auto inSight = [&](std::size_t level) { return select.tile(level).center().x < 100; };
    EXPECT_TRUE(inSight(0));
    EXPECT_FALSE(inSight(6));
    for (int i = 0; i < 6; ++i) {
        press(select, Command::Down);
    }
    EXPECT_EQ(select.chosen(), 6u);
    EXPECT_TRUE(inSight(6));
    EXPECT_FALSE(inSight(0));
    select.choose(0);
    EXPECT_TRUE(inSight(0));
    const auto click = [&](const Aabb& place) {
        Signals signals;
        signals.pointer = signals.pointerNow = place.center();
        signals.clicked = true;
        EXPECT_FALSE(select.take(signals));
    };
    for (int i = 0; i < 3; ++i) {
        click(select.downPlace());
    }
    EXPECT_TRUE(inSight(6));
    click(select.downPlace()); // no more rows
    EXPECT_EQ(select.chosen(), 6u);
    for (int i = 0; i < 3; ++i) {
        click(select.upPlace());
    }
    EXPECT_TRUE(inSight(0));
    EXPECT_EQ(select.chosen(), 0u);
}

TEST(LevelSelect, ShowsThemeTitleIdeaBestScoresAndProgress) {
    LevelSelect select(elevenLevels());
    select.choose(8);
    Records records({}, {}, {}, {});
    records.enter({{Mode::Standard, "level_8"}, {12300, true, false, false}, {}});
    records.enter({{Mode::Pure, "level_8"}, {4500, false, false, false}, {}});
    RecordingCanvas canvas;
    canvas.begin({{-16, 0}, {16, 20}}, {});
    select.draw(canvas, records, 0);
    for (const char* text :
         {"Title 8", "Only for tests.", "12 300", "4 500", "1 of 11 cleared, 12 300 points"}) {
        EXPECT_TRUE(canvas.says(text)) << text;
    }
    EXPECT_TRUE(canvas.says(lookOf(Theme::Daybreak).title));
    EXPECT_TRUE(canvas.says(lookOf(Theme::Harbour).title));
}

TEST(LevelSelect, NamesTheHonourUnderThePointer) {
    LevelSelect select(elevenLevels());
    const Records records({}, {}, {}, {});
    const auto seen = [&](Vec2 pointer) {
        Signals signals;
        signals.pointer = pointer;
        select.take(signals);
        RecordingCanvas canvas;
        canvas.begin({{-16, 0}, {16, 20}}, {});
        select.draw(canvas, records, 0);
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
