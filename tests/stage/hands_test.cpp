// SPDX-License-Identifier: MIT
#include <apart/stage/hands.hpp>

#include <gtest/gtest.h>

namespace apart {
namespace {

Signals holding(bool left, bool right) {
    Signals signals;
    signals.leftHeld = left;
    signals.rightHeld = right;
    return signals;
}

TEST(Hands, AHeldKeyBeginsGentlyAndReachesFullSpeedWithinAFifthOfASecond) {
    Hands hands;
    hands.take(holding(false, true));
    const int first = hands.next().paddle;
    EXPECT_GT(first, 0);
    EXPECT_LT(first, 64); // of 127
    int last = first;
    for (int tick = 0; tick < 24; ++tick) {
        const int now = hands.next().paddle;
        EXPECT_GE(now, last);
        last = now;
    }
    EXPECT_EQ(last, 127);
}

TEST(Hands, BothKeysTogetherStandStill) {
    Hands hands;
    hands.take(holding(true, true));
    EXPECT_EQ(hands.next().paddle, 0);
}

TEST(Hands, TurningAroundBeginsGentlyAgain) {
    Hands hands;
    hands.take(holding(true, false));
    for (int tick = 0; tick < 30; ++tick) {
        hands.next();
    }
    EXPECT_EQ(hands.next().paddle, -127);
    hands.take(holding(false, true));
    EXPECT_LT(hands.next().paddle, 64);
}

TEST(Hands, TheMouseRulesUntilAKeyIsHeld) {
    Hands hands;
    Signals moved;
    moved.pointer = kodo::Vec2{3.5f, 2};
    hands.take(moved);
    ASSERT_TRUE(hands.next().target.has_value());
    hands.take({});                                                    // the mouse rests
    EXPECT_EQ(hands.next().target, std::optional<std::int16_t>(3500)); // mm
    hands.take(holding(true, false));
    EXPECT_FALSE(hands.next().target.has_value());
}

TEST(Hands, APointerFarOutsideIsNoOverflow) {
    Hands hands;
    Signals moved;
    moved.pointer = kodo::Vec2{-1e6f, 0};
    hands.take(moved);
    EXPECT_EQ(hands.next().target, std::optional<std::int16_t>(-32000));
}

TEST(Hands, ALaunchCountsForOneTick) {
    Hands hands;
    hands.launch();
    EXPECT_TRUE(hands.next().launch);
    EXPECT_FALSE(hands.next().launch);
}

} // namespace
} // namespace apart
