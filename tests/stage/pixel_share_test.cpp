// SPDX-License-Identifier: MIT
// How many pixels the page of the game draws, by how late its frames are.
#include <apart/web/pixel_share.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using apart::PixelShare;

/// A machine that draws so many frames in a second with all pixels, on a screen of 60.
struct Machine {
    double full = 60;
    double screen = 60;
    int changes = 0;
    PixelShare share{};

    double rate() const { return std::min(screen, full / (share.share() * share.share())); }
    void run(double seconds) {
        while (seconds > 0) {
            const double before = share.share();
            const double frame = 1 / rate();
            share.next(frame);
            seconds -= frame;
            changes += share.share() != before ? 1 : 0;
        }
    }
};

TEST(PixelShare, IsWholeOnAMachineThatHoldsTheRateOfItsScreen) {
    for (const double screen : {60.0, 120.0}) {
        Machine machine{.full = screen, .screen = screen};
        machine.run(60);
        for (int i = 0; i < 10; ++i) { // a hitch now and then, and a page that was hidden
            machine.share.next(0.4);
            machine.share.next(30);
            machine.run(10);
        }
        EXPECT_EQ(machine.changes, 0);
    }
}

TEST(PixelShare, FallsUntilFramesAreInTime) {
    Machine slow{.full = 40};
    slow.run(10);
    EXPECT_EQ(slow.share.share(), 0.75);
    Machine slower{.full = 8};
    slower.run(10);
    EXPECT_EQ(slower.share.share(), 0.5) << "32 frames in a second are more than 8";
}

TEST(PixelShare, ReturnsWhenThereIsTimeAgain) {
    Machine machine{.full = 20};
    machine.run(10);
    EXPECT_EQ(machine.share.share(), 0.5);
    machine.full = 60;
    machine.run(90);
    EXPECT_EQ(machine.share.share(), 1);
}

TEST(PixelShare, TriesMorePixelsMoreAndMoreRarely) {
    Machine machine{.full = 40};
    machine.run(600);
    EXPECT_GT(machine.changes, 5);
    EXPECT_LT(machine.changes, 15)
        << "each trial is two changes, and each pause twice the last one";
    machine.changes = 0;
    machine.run(600);
    EXPECT_LE(machine.changes, 2);
}

TEST(PixelShare, IsWholeWhereFewerPixelsDoNotHelp) {
    Machine machine{.full = 1000, .screen = 30};
    machine.run(600);
    EXPECT_EQ(machine.share.share(), 1);
    EXPECT_LT(machine.changes, 20);
}

} // namespace
