// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/controls/bindings.hpp>
#include <apart/stage/records/profile_file.hpp>

#include <gtest/gtest.h>

#include <set>

#include "stage_rig.hpp"

namespace apart {
namespace {

Press keyPress(std::string_view name) {
    return {false, keyNamed(name).value()};
}

TEST(Bindings, EveryKeyHasItsOwnNameAndEachActAKey) {
    EXPECT_EQ(std::set<std::string_view>(kKeyNames.begin(), kKeyNames.end()).size(),
              kKeyNames.size());
    const Bindings usual;
    for (std::size_t i = 0; i < kActs; ++i) {
        const auto act = static_cast<Act>(i);
        EXPECT_EQ(usual.actOf({false, usual.at(act, 0)}), act);
        EXPECT_EQ(usual.at(act, Bindings::kPadColumn) != kNoKey, hasButton(act));
    }
    EXPECT_EQ(usual.prompt(Act::Left), "left or A");
    EXPECT_EQ(usual.prompt(Act::Serve), "space");
    EXPECT_EQ(usual.firstKey(Act::Left), "left");
    EXPECT_EQ(usual.actOf({true, 0}), Act::Serve);
    EXPECT_EQ(usual.actOf({false, kNoKey}), std::nullopt);
}

TEST(Bindings, ATouchScreenIsToldOfFingers) {
    StageDef def = StageRig::twoLevels();
    def.profile.bindings.fingers = true;
    StageRig rig(std::move(def));
    EXPECT_TRUE(rig.picture().says("tap a word"));
    rig.clickItem(Action::Play);
    EXPECT_TRUE(rig.picture().says("tap to serve"));
    EXPECT_TRUE(rig.picture().says("a second finger: pull"));
    EXPECT_FALSE(rig.picture().says("P: pause")); // the page has a button
    rig.press(Command::Pause);
    EXPECT_TRUE(rig.picture().says("a finger: move"));
    EXPECT_FALSE(rig.picture().says("left button"));
}

TEST(Bindings, ATouchScreenLeavesTheHelpByTaps) {
    StageDef def = StageRig::twoLevels();
    def.profile.bindings.fingers = true;
    StageRig rig(std::move(def));
    rig.clickItem(Action::Help);
    ASSERT_EQ(rig.stage.screen(), Screen::Help);
    EXPECT_TRUE(rig.picture().says("tap: the powers"));
    EXPECT_FALSE(rig.picture().says("F11"));
    rig.click({0, 5});
    EXPECT_TRUE(rig.picture().says("tap: back"));
    rig.click({0, 5});
    EXPECT_EQ(rig.stage.screen(), Screen::Title);
}

TEST(Bindings, ATouchScreenHasAMapWithoutKeys) {
    StageDef def = StageRig::twoLevels();
    def.profile.bindings.fingers = true;
    StageRig rig(std::move(def));
    rig.clickItem(Action::Levels);
    EXPECT_TRUE(rig.picture().says("edit"));
    EXPECT_FALSE(rig.picture().says("edit (E)"));
    EXPECT_FALSE(rig.picture().says("escape"));
}

TEST(Bindings, ATouchScreenHasATitleForFingers) {
    StageDef def = StageRig::twoLevels();
    def.profile.bindings.fingers = true;
    def.quits = false;
    StageRig rig(std::move(def));
    const Menu& menu = rig.stage.menu();
    const std::size_t count = menu.items().size();
    ASSERT_GT(count, 4u);
    const Real pixels = 360 / layout::kShownTitle.extent().y; // for a metre on a small phone
    for (std::size_t i = 0; i < count; ++i) {
        const Aabb place = menu.place(i);
        EXPECT_GE(place.extent().y * pixels, 40);
        EXPECT_TRUE(layout::kShownTitle.contains(place.lower));
        EXPECT_TRUE(layout::kShownTitle.contains(place.upper));
        for (std::size_t k = 0; k < count; ++k) {
            EXPECT_EQ(menu.place(k).contains(place.center()), k == i);
        }
    }
    rig.click(menu.place(count - 1).center());
    EXPECT_EQ(rig.stage.screen(), Screen::Options);
}

TEST(Bindings, AKeyThatIsUsedIsRefused) {
    Bindings bindings;
    EXPECT_EQ(bindings.bind(Act::Serve, 0, *keyNamed("P")), "P is in use: pause");
    EXPECT_EQ(bindings.bind(Act::Serve, Bindings::kPadColumn, 4), "left shoulder is in use: pull");
    EXPECT_EQ(bindings.bind(Act::Left, 0, *keyNamed("A")), "A is in use: left") << "other column";
    EXPECT_NE(bindings.bind(Act::Serve, 0, *keyNamed("escape")), "");
    EXPECT_NE(bindings.bind(Act::Left, Bindings::kPadColumn, 9), "") << "the stick moves";
    EXPECT_EQ(bindings, Bindings{});
    EXPECT_EQ(bindings.bind(Act::Serve, 0, *keyNamed("space")), "") << "it has this key already";
    EXPECT_EQ(bindings.bind(Act::Pause, 0, kNoKey), "");
    EXPECT_EQ(bindings.bind(Act::Serve, 0, *keyNamed("P")), "") << "now it is free";
    EXPECT_EQ(bindings.prompt(Act::Serve), "P");
    EXPECT_EQ(bindings.prompt(Act::Pause), "pause") << "its other key";
}

TEST(Bindings, AreKeptInTheProfile) {
    Profile profile;
    EXPECT_EQ(profile.bindings.bind(Act::Serve, 1, *keyNamed("[")), "");
    EXPECT_EQ(profile.bindings.bind(Act::Mute, 0, kNoKey), "");
    EXPECT_EQ(profile.bindings.bind(Act::Serve, Bindings::kPadColumn, 20), "");
    const auto read = profileFrom(toText(profile), "x");
    ASSERT_TRUE(std::holds_alternative<Profile>(read)) << std::get<FileProblem>(read).text();
    EXPECT_EQ(std::get<Profile>(read).bindings, profile.bindings);
    for (const char* keys :
         {"serve = [\"P\", \"P\", 0]", "serve = [\"escape\", \"-\", 0]",
          "serve = [\"space\", \"-\"]", "serve = [\"space\", \"-\", 33]",
          "serve = [\"no key\", \"-\", 0]", "serve = 1", "leap = [\"-\", \"-\", 0]",
          "serve = [\"space\", \"-\", -1]", "left = [\"A\", \"-\", 1]"}) {
        const std::string text = std::string("format = 1\n[keys]\n") + keys + "\n";
        EXPECT_TRUE(std::holds_alternative<FileProblem>(profileFrom(text, "x"))) << keys;
    }
}

/// A stage on the screen of keys, its first cell chosen: the first key of "left".
struct KeyRig : StageRig {
    KeyRig() : StageRig(StageRig::twoLevels()) {
        clickItem(Action::Options);
        clickItem(Action::Keys);
    }
    /// A key of the keyboard, with the command that it has in menus.
    void type(Press press, std::vector<Command> commands = {}) {
        Signals signals;
        signals.presses = {press};
        signals.commands = std::move(commands);
        signals.anyKey = true;
        frame(signals);
    }
};

TEST(KeyScreen, TheNextKeyIsBoundAndShownInPrompts) {
    KeyRig rig;
    ASSERT_EQ(rig.stage.screen(), Screen::Keys);
    EXPECT_TRUE(rig.picture().says("Keys and buttons"));
    for (int i = 0; i < 4; ++i) {
        rig.press(Command::Down); // serve
    }
    rig.type(keyPress("enter"), {Command::Confirm});
    EXPECT_TRUE(rig.picture().says("press a key; escape: leave it as it is"));
    rig.type({true, 12}); // a button is no key
    EXPECT_TRUE(rig.picture().says("press it ..."));
    rig.type(keyPress("P"), {Command::Pause});
    EXPECT_TRUE(rig.picture().says("P is in use: pause"));
    EXPECT_EQ(rig.stage.records().profile().bindings, Bindings{});
    rig.type(keyPress("enter"), {Command::Confirm});
    rig.type(keyPress("M"), {Command::Mute});
    EXPECT_FALSE(rig.stage.records().profile().muted) << "the key does nothing else meanwhile";
    rig.type(keyPress("enter"), {Command::Confirm});
    rig.type(keyPress("X"));
    EXPECT_EQ(rig.stage.records().profile().bindings.at(Act::Serve, 0), *keyNamed("X"));
    rig.press(Command::Back);
    EXPECT_EQ(rig.stage.screen(), Screen::Options);
    rig.press(Command::Back);
    rig.clickItem(Action::Play);
    rig.frames(5);
    EXPECT_TRUE(rig.picture().says("X or click to serve"));
    rig.press(Command::Pause);
    EXPECT_TRUE(rig.picture().says("X or click: serve"));
    rig.clickItem(Action::Help);
    EXPECT_TRUE(rig.picture().says("X, enter, click"));
}

TEST(KeyScreen, EscapeLeavesAKeyAsItIsAndDeleteRemovesIt) {
    KeyRig rig;
    rig.press(Command::Confirm);
    rig.type(keyPress("escape"), {Command::Back});
    EXPECT_EQ(rig.stage.screen(), Screen::Keys);
    EXPECT_EQ(rig.stage.records().profile().bindings, Bindings{});
    rig.type(keyPress("delete"));
    EXPECT_EQ(rig.stage.records().profile().bindings.at(Act::Left, 0), kNoKey);
    EXPECT_EQ(rig.stage.records().profile().bindings.prompt(Act::Left), "A");
    for (std::size_t i = 0; i < KeyScreen::kResetRow; ++i) {
        rig.press(Command::Down);
    }
    rig.press(Command::Confirm);
    EXPECT_NE(rig.stage.records().profile().bindings, Bindings{}) << "it asks once";
    EXPECT_TRUE(rig.picture().says("once more to reset the keys and buttons"));
    rig.press(Command::Up); // another row: the question is gone
    EXPECT_FALSE(rig.picture().says("once more"));
    rig.press(Command::Down);
    rig.press(Command::Confirm);
    EXPECT_NE(rig.stage.records().profile().bindings, Bindings{});
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.records().profile().bindings, Bindings{});
    rig.press(Command::Down);
    rig.press(Command::Confirm);
    EXPECT_EQ(rig.stage.screen(), Screen::Options);
}

TEST(KeyScreen, AButtonIsBoundByMouse) {
    KeyRig rig;
    const KeyScreen table;
    rig.click(table.cell(4, Bindings::kPadColumn).center());
    rig.type({true, 12});
    EXPECT_EQ(rig.stage.records().profile().bindings.at(Act::Serve, Bindings::kPadColumn), 12);
    rig.click(table.cell(0, Bindings::kPadColumn).center());
    EXPECT_TRUE(rig.picture().says("the stick moves the paddle"));
    rig.click(table.cell(KeyScreen::kBackRow, 0).center());
    EXPECT_EQ(rig.stage.screen(), Screen::Options);
}

} // namespace
} // namespace apart
