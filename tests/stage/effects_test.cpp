// SPDX-License-Identifier: MIT
#include <apart/core/tuning.hpp>
#include <apart/stage/canvas/layout.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stage_rig.hpp"

namespace apart {
namespace {

StageDef playedWith(int percent) {
    StageDef def = StageRig::played();
    for (const Dial& dial : kDials) {
        if (dial.least == 0) { // an effect, since it can be off
            def.profile.settings.*dial.value = percent;
        }
    }
    return def;
}

void playUntil(StageRig& rig, std::uint32_t tick) {
    while (rig.stage.session().game().ticks() < tick) {
        rig.frame({}, 1.0 / kTicksPerSecond); // at most one tick, none during a hit-freeze
        rig.picture();
    }
}

// A7: effects for the eye.
// Each effect alone and all together, at 0 and at maximum, give the same game.
TEST(Effects, DoNotAffectTheSimulation) {
    StageRig plain(playedWith(0));
    playUntil(plain, 900);
    const std::uint64_t expected = plain.stage.session().game().stateHash();
    StageRig rich(playedWith(100));
    playUntil(rich, 900);
    ASSERT_EQ(rich.stage.session().game().ticks(), 900u);
    EXPECT_EQ(rich.stage.session().game().stateHash(), expected);
    for (const Dial& dial : kDials) {
        StageDef def = playedWith(0);
        def.profile.settings.*dial.value = dial.most;
        StageRig one(std::move(def));
        playUntil(one, 900);
        EXPECT_EQ(one.stage.session().game().stateHash(), expected) << dial.key;
    }
}

TEST(Effects, AreInvisibleAndSilentAtZero) {
    StageRig rig(playedWith(0));
    for (int i = 0; i < 600; ++i) {
        rig.frame();
        ASSERT_EQ(rig.picture().shake(), Vec2{});
    }
    EXPECT_TRUE(rig.speaker.notes.empty());
    StageRig rich(playedWith(100));
    bool shook = false;
    for (int i = 0; i < 600; ++i) {
        rich.frame();
        shook = shook || rich.picture().shake() != Vec2{};
    }
    EXPECT_TRUE(shook);
    EXPECT_FALSE(rich.speaker.notes.empty());
}

// A game that loses a ball as often as possible: the most frequent flash.
TEST(Effects, FlashAtMostThreeTimesInASecond) {
    Level level = *glassLevel("x", {0, 1, 2});
    level.lives = 9;
    Game game(level, 1);
    Settings settings;
    settings.flash = 100;
    Juice juice(1, settings);
    std::vector<std::uint32_t> flashes; // ticks
    float before = 0;
    for (int i = 0; i < 60 * kTicksPerSecond; ++i) {
        Input input;
        input.launch = true;
        input.target =
            std::int16_t(game.balls().empty() || game.balls()[0].heading.x > 0 ? -9000 : 9000);
        game.tick(input);
        juice.tick(game);
        if (juice.flashes().field() > before) {
            flashes.push_back(game.ticks());
        }
        before = juice.flashes().field();
    }
    ASSERT_GE(flashes.size(), 3u); // the test is not vacuous
    for (std::size_t i = 3; i < flashes.size(); ++i) {
        EXPECT_GT(flashes[i] - flashes[i - 3], std::uint32_t(kTicksPerSecond));
    }
}

// Regression: points of blocks in the upper corners rose above the wall.
TEST(Effects, PointsStayInTheField) {
    StageDef def = StageRig::played();
    Level corner = *def.levels[0];
    corner.cells = {{0, 0, 0}, {0, kColumns - 1, 0}};
    def.levels = {std::make_shared<const Level>(corner)};
    StageRig rig(std::move(def));
    int seen = 0;
    for (int i = 0; i < 60 * 300 && rig.stage.screen() == Screen::Playing; ++i) {
        rig.frame();
        for (const Stroke& stroke : rig.picture().strokes()) {
            if (stroke.kind == Stroke::Kind::Text && stroke.text.starts_with("+")) {
                ++seen;
                EXPECT_LE(stroke.place.y + stroke.size / 2, layout::kTop);
                EXPECT_LT(std::abs(stroke.place.x) + stroke.size, layout::kRight);
            }
        }
    }
    EXPECT_GT(seen, 10);
}

// Regression: the arcs of a pull beside a wall crossed the score panel.
TEST(Effects, TheFieldOfThePaddleStaysBetweenTheWalls) {
    StageRig rig(StageRig::playing());
    Signals right;
    right.moved = kFieldWidth;
    rig.frame(right);
    rig.frames(60);
    Signals serve; // before it, the force rests
    serve.commands = {Command::Launch};
    rig.frame(serve);
    rig.frame(); // what was held at the serve does not pull
    ASSERT_FALSE(rig.stage.session().game().serving());
    const auto countPoints = [&](Real from, Real to) {
        const auto& strokes = rig.picture().strokes();
        return std::count_if(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
            return stroke.kind == Stroke::Kind::Ribbon && stroke.place.x > from &&
                   stroke.place.x < to && stroke.place.y < kFieldHeight / 2;
        });
    };
    const auto before = countPoints(0, layout::kRight);
    Signals pull;
    pull.pullHeld = true;
    rig.frame(pull);
    ASSERT_EQ(rig.stage.session().game().force(), Force::Pull);
    EXPECT_GT(countPoints(0, layout::kRight), before);
    EXPECT_EQ(countPoints(layout::kRight, layout::kRight + 100), 0); // the wall's edge line lies
                                                                     // exactly there
}

TEST(Effects, AHardImpactFreezesThePictureBriefly) {
    const auto framesTo = [](int freeze) {
        StageDef def = playedWith(0);
        def.profile.settings.freeze = freeze;
        StageRig rig(std::move(def));
        int frames = 0;
        for (; rig.stage.session().game().ticks() < 1200; ++frames) {
            rig.frame();
        }
        return frames;
    };
    const int without = framesTo(0);
    const int with = framesTo(100);
    EXPECT_GT(with, without);
    EXPECT_LT(with, without + without / 4); // at most 60 ms of hit-freeze per 300 ms: one fifth
}

} // namespace
} // namespace apart
