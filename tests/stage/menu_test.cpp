// SPDX-License-Identifier: MIT
#include <apart/stage/records/recording.hpp>
#include <apart/stage/screens/menu.hpp>

#include <gtest/gtest.h>

namespace apart {
namespace {

Menu someMenu() {
    return Menu({{Action::Resume, "Go on"},
                 {Action::Dial, "Shake", Gauge{60, 0, 100}, 5},
                 {Action::Dial, "Mouse", Gauge{100, 20, 300}, 1},
                 {Action::Back, "Back"}},
                10);
}

std::optional<MenuOutcome> press(Menu& menu, Command command) {
    Signals signals;
    signals.commands = {command};
    return menu.take(signals);
}

std::optional<MenuOutcome> click(Menu& menu, Vec2 place) {
    Signals signals;
    signals.pointer = signals.pointerNow = place;
    signals.clicked = true;
    return menu.take(signals);
}

TEST(Menu, WrapsAroundInBothDirections) {
    Menu menu = someMenu();
    press(menu, Command::Up);
    EXPECT_EQ(menu.chosen(), 3u);
    press(menu, Command::Down);
    EXPECT_EQ(menu.chosen(), 0u);
}

TEST(Menu, EnterAndSpaceChooseAnItemButNotADial) {
    Menu menu = someMenu();
    ASSERT_TRUE(press(menu, Command::Confirm));
    EXPECT_EQ(press(menu, Command::Launch)->action, Action::Resume);
    press(menu, Command::Down);
    EXPECT_FALSE(press(menu, Command::Confirm));
}

TEST(Menu, LeftAndRightTurnADialByANotchAndStopAtItsEnds) {
    Menu menu = someMenu();
    EXPECT_FALSE(press(menu, Command::Left)); // the first item has no dial
    press(menu, Command::Down);
    const auto more = press(menu, Command::Right);
    ASSERT_TRUE(more);
    EXPECT_EQ(more->action, Action::Dial);
    EXPECT_EQ(more->dial, 5u);
    EXPECT_EQ(more->percent, 70);
    menu.setPercent(5, 95);
    EXPECT_EQ(press(menu, Command::Right)->percent, 100);
    menu.setPercent(5, 100);
    EXPECT_FALSE(press(menu, Command::Right));
    menu.setPercent(1, 20);
    press(menu, Command::Down);
    EXPECT_FALSE(press(menu, Command::Left)); // minimum 20
}

TEST(Menu, AClickOnTheBarSetsTheDialThere) {
    Menu menu = someMenu();
    const Aabb bar = menu.bar(2); // 20 to 300
    EXPECT_EQ(click(menu, {bar.upper.x, bar.center().y})->percent, 300);
    EXPECT_EQ(click(menu, {bar.lower.x, bar.center().y})->percent, 20);
    EXPECT_EQ(click(menu, bar.center())->percent, 160);
    EXPECT_EQ(click(menu, {bar.upper.x + 0.3f, bar.center().y})->percent, 110); // one notch
    EXPECT_EQ(click(menu, {bar.lower.x - 0.3f, bar.center().y})->percent, 90);
}

TEST(Menu, TheMouseChoosesTheItemUnderIt) {
    Menu menu = someMenu();
    Signals over;
    over.pointer = menu.place(3).center();
    EXPECT_FALSE(menu.take(over));
    EXPECT_EQ(menu.chosen(), 3u);
    EXPECT_EQ(click(menu, menu.place(0).center())->action, Action::Resume);
    EXPECT_FALSE(click(menu, {50, 50}));
}

TEST(Menu, ShowsEachItemAndItsValue) {
    RecordingCanvas canvas;
    canvas.begin({{-10, 0}, {10, 20}}, {});
    someMenu().draw(canvas);
    for (const char* text : {"Go on", "Shake", "60 %", "Mouse", "100 %", "Back"}) {
        EXPECT_TRUE(canvas.says(text)) << text;
    }
}

TEST(Menu, AnEmptyMenuIgnoresAllInput) {
    Menu menu;
    EXPECT_FALSE(press(menu, Command::Down));
    EXPECT_FALSE(press(menu, Command::Confirm));
    EXPECT_FALSE(click(menu, {0, 0}));
}

} // namespace
} // namespace apart
