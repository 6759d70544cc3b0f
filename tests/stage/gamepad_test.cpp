// SPDX-License-Identifier: MIT
// An emulated gamepad at the place where the state of a device enters, in front of a stage.
#include <apart/front/held_keys.hpp>

#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

using Commands = std::vector<Command>;

constexpr std::uint32_t kA = 1u << 0;
constexpr std::uint32_t kLeftShoulder = 1u << 4;

/// The signals of one frame.
Signals after(HeldKeys& keys, const Pad& pad) {
    Signals signals;
    keys.take({pad}, signals);
    return signals;
}

TEST(Gamepad, AStickMovesAMenuOnceUntilItReturns) {
    HeldKeys keys;
    EXPECT_EQ(after(keys, {.stickY = 0.5f}).commands, Commands{});
    EXPECT_EQ(after(keys, {.stickY = 0.7f}).commands, Commands{Command::Down});
    EXPECT_EQ(after(keys, {.stickY = 1}).commands, Commands{});
    EXPECT_EQ(after(keys, {.stickY = 0.5f}).commands, Commands{}) << "it trembles";
    EXPECT_EQ(after(keys, {.stickY = 0.7f}).commands, Commands{});
    EXPECT_EQ(after(keys, {}).commands, Commands{});
    EXPECT_EQ(after(keys, {.stickY = -1}).commands, Commands{Command::Up});
    EXPECT_EQ(after(keys, {.stickX = -1, .stickY = 0.3f}).commands, Commands{Command::Left});
    EXPECT_EQ(after(keys, {.stickX = 0.9f, .stickY = 0.8f}).commands, Commands{Command::Right});
    EXPECT_EQ(after(keys, {.padY = 1}).commands, Commands{Command::Down});
}

TEST(Gamepad, AButtonIsPressedOnceAndHeld) {
    HeldKeys keys;
    const Signals first = after(keys, {.held = kA});
    EXPECT_EQ(first.commands, Commands{Command::Launch});
    EXPECT_EQ(first.presses, (std::vector<Press>{{true, 0}}));
    EXPECT_TRUE(first.serveHeld);
    const Signals second = after(keys, {.held = kA});
    EXPECT_EQ(second.commands, Commands{});
    EXPECT_TRUE(second.serveHeld);
}

TEST(Gamepad, ATriggerActsAsItsShoulder) {
    HeldKeys keys;
    EXPECT_FALSE(after(keys, {.triggers = {-1, -1}}).pullHeld) << "at rest";
    const Signals left = after(keys, {.triggers = {0.8f, -1}});
    EXPECT_TRUE(left.pullHeld);
    EXPECT_FALSE(left.pushHeld);
    EXPECT_EQ(left.presses, (std::vector<Press>{{true, 4}}));
    EXPECT_EQ(after(keys, {.held = kLeftShoulder}).presses, std::vector<Press>{}) << "held on";
    EXPECT_TRUE(after(keys, {.triggers = {-1, 1}}).pushHeld);
}

TEST(Gamepad, OfTwoGamepadsEachMoves) {
    const Pad still;
    const Pad moved{.stickX = -0.9f, .triggers = {0, 1}, .held = kA};
    for (const Pad& pad : {still.joined(moved), moved.joined(still)}) {
        HeldKeys keys;
        const Signals signals = after(keys, pad);
        EXPECT_LT(signals.stick, -0.8);
        EXPECT_TRUE(signals.pushHeld);
        EXPECT_TRUE(signals.serveHeld);
    }
}

TEST(Gamepad, AButtonHasItsNameWhereItIsBound) {
    EXPECT_EQ(buttonText(0), "button A");
    EXPECT_EQ(buttonText(5), "right shoulder");
    EXPECT_EQ(buttonText(7), "start");
    EXPECT_EQ(buttonText(8), "button 9");
    EXPECT_EQ(buttonText(kNoKey), "-");
}

/// A stage with a gamepad only.
struct PadRig : StageRig {
    PadRig() : StageRig(StageRig::twoLevels()) {}
    void hold(const Pad& pad) {
        Signals signals;
        keys.take({pad}, signals);
        frame(signals);
    }
    void tap(const Pad& pad) {
        hold(pad);
        hold({});
    }
    HeldKeys keys;
};

TEST(Gamepad, LeadsFromTheTitleOverTheMapIntoAGame) {
    PadRig rig;
    rig.tap({.stickY = 1}); // from the first item to the map
    rig.tap({.held = kA});
    ASSERT_EQ(rig.stage.screen(), Screen::Levels);
    rig.tap({.stickX = 1}); // to the second level
    rig.tap({.held = kA});
    ASSERT_EQ(rig.stage.screen(), Screen::Playing);
    EXPECT_EQ(rig.stage.session().game().level().name, "test_3");
}

} // namespace
} // namespace apart
