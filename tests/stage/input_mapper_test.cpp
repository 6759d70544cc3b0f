// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/controls/input_mapper.hpp>

#include <gtest/gtest.h>

namespace apart {
namespace {

Signals holding(bool left, bool right) {
    Signals signals;
    signals.leftHeld = left;
    signals.rightHeld = right;
    return signals;
}

TEST(InputMapper, AHeldKeyStartsSlowlyAndReachesFullSpeedWithinAFifthOfASecond) {
    InputMapper hands;
    hands.take(holding(false, true), 0, 1);
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

TEST(InputMapper, BothKeysTogetherCancel) {
    InputMapper hands;
    hands.take(holding(true, true), 0, 1);
    EXPECT_EQ(hands.next().paddle, 0);
}

TEST(InputMapper, AReversalStartsSlowlyAgain) {
    InputMapper hands;
    hands.take(holding(true, false), 0, 1);
    for (int tick = 0; tick < 30; ++tick) {
        hands.next();
    }
    EXPECT_EQ(hands.next().paddle, -127);
    hands.take(holding(false, true), 0, 1);
    EXPECT_LT(hands.next().paddle, 64);
}

Signals movingBy(float metres) {
    Signals signals;
    signals.moved = metres;
    return signals;
}

TEST(InputMapper, TheMouseMovesATargetThatStartsAtThePaddle) {
    InputMapper hands;
    hands.take(movingBy(1.5f), 2, 1);
    EXPECT_EQ(hands.next().target, std::optional<std::int16_t>(3500)); // mm
    hands.take({}, 2.2f, 1);                                           // no mouse motion
    EXPECT_EQ(hands.next().target, std::optional<std::int16_t>(3500));
    hands.take(movingBy(-1), 3, 1); // relative to the target, not to the paddle that follows it
    EXPECT_EQ(hands.next().target, std::optional<std::int16_t>(2500));
}

TEST(InputMapper, TheMouseSpeedScalesItsMotion) {
    InputMapper hands;
    hands.take(movingBy(1), 0, 2.5f);
    EXPECT_EQ(hands.next().target, std::optional<std::int16_t>(2500));
}

TEST(InputMapper, TheMouseControlsUntilAKeyIsHeld) {
    InputMapper hands;
    hands.take(movingBy(3), 0, 1);
    hands.take(holding(true, false), 1, 1);
    EXPECT_FALSE(hands.next().target.has_value());
    hands.take(movingBy(1), -4, 1); // relative to the position reached by keys
    EXPECT_EQ(hands.next().target, std::optional<std::int16_t>(-3000));
}

// Otherwise the mouse would have to return over the whole distance beyond the wall.
TEST(InputMapper, AMouseBeyondTheWallReversesAtOnce) {
    InputMapper hands;
    hands.take(movingBy(1e6f), 0, 1);
    const auto far = hands.next().target;
    ASSERT_TRUE(far);
    EXPECT_EQ(*far, std::int16_t(1000 * (kFieldWidth / 2 - kPaddleHalfWidth)));
    hands.take(movingBy(-0.5f), 9, 1);
    EXPECT_EQ(hands.next().target, std::optional(static_cast<std::int16_t>(*far - 500)));
}

TEST(InputMapper, PullAndPushAreHeldAndCancelTogether) {
    InputMapper hands;
    Signals held;
    held.pullHeld = true;
    hands.take(held, 0, 1);
    EXPECT_EQ(hands.next().force, Force::Pull);
    EXPECT_EQ(hands.next().force, Force::Pull);
    held.pushHeld = true;
    hands.take(held, 0, 1);
    EXPECT_EQ(hands.next().force, Force::None);
    held.pullHeld = false;
    hands.take(held, 0, 1);
    EXPECT_EQ(hands.next().force, Force::Push);
}

// The left button serves and pulls: holding it after the serve must not pull the ball back.
TEST(InputMapper, TheButtonThatServedPullsOnlyWhenPressedAgain) {
    InputMapper hands;
    Signals held;
    held.pullHeld = true;
    hands.launch({}, std::nullopt);
    hands.take(held, 0, 1);
    EXPECT_EQ(hands.next().force, Force::None);
    hands.take({}, 0, 1);
    hands.take(held, 0, 1);
    EXPECT_EQ(hands.next().force, Force::Pull);
}

Signals holdingServe(float moved = 0) {
    Signals signals = movingBy(moved);
    signals.serveHeld = true;
    return signals;
}

TEST(InputMapper, AHeldServeIsTurnedByTheMouseAndServedWhenReleased) {
    InputMapper hands;
    hands.take(movingBy(1.5f), 2, 1);
    hands.launch(holdingServe(), kodo::Vec2{0, 1});
    hands.take(holdingServe(3), 2, 1);
    const Input held = hands.next();
    EXPECT_FALSE(held.launch);
    EXPECT_EQ(held.target, std::optional<std::int16_t>(3500)) << "the paddle stays";
    ASSERT_TRUE(held.aim);
    EXPECT_GT(*held.aim, 200);
    hands.take(holdingServe(-6), 2, 1);
    EXPECT_LT(*hands.next().aim, -200);
    hands.take(movingBy(0), 2, 1);
    const Input released = hands.next();
    EXPECT_TRUE(released.launch);
    EXPECT_LT(released.aim.value_or(0), -200);
    EXPECT_FALSE(hands.next().launch);
    EXPECT_FALSE(hands.next().aim);
}

TEST(InputMapper, AHeldServeIsTurnedByKeysAndStickUpToItsFlattestDirection) {
    for (const bool keys : {true, false}) {
        InputMapper hands;
        hands.launch(holdingServe(), kodo::Vec2{0, 1});
        Signals right = holdingServe();
        right.rightHeld = keys;
        right.stick = keys ? 0 : 1;
        hands.take(right, 0, 1);
        Input input = hands.next();
        EXPECT_EQ(input.paddle, 0);
        EXPECT_GT(input.aim.value_or(0), 0);
        for (int tick = 0; tick < 2 * kTicksPerSecond; ++tick) {
            input = hands.next();
        }
        EXPECT_NEAR(input.aim.value_or(0), kMostAim, 2);
    }
}

TEST(InputMapper, AClickThatIsOverServesAtOnceAlongTheDirectionShown) {
    InputMapper hands;
    hands.launch({}, kodo::Vec2{0, 1});
    const Input input = hands.next();
    EXPECT_TRUE(input.launch);
    EXPECT_FALSE(input.aim);
}

TEST(InputMapper, ALaunchCountsForOneTick) {
    InputMapper hands;
    hands.launch({}, std::nullopt);
    EXPECT_TRUE(hands.next().launch);
    EXPECT_FALSE(hands.next().launch);
}

} // namespace
} // namespace apart
