// SPDX-License-Identifier: MIT
// The editor: ground by mouse, what is placed freely, and the frame of its picture.
#include <apart/core/level_file.hpp>
#include <apart/front/held_keys.hpp>
#include <apart/stage/canvas/layout.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include "editor_rig.hpp"

namespace apart {
namespace {

class EditorGround : public EditorStage {
protected:
    using Corners = std::vector<GroundPoint>;

    /// Draws a trapezoid whose upper side is at 4.5 m, in clockwise order.
    void drawHill() {
        button(EditorAct::Ground);
        click({Real(-9), Real(3.2)});
        click({Real(-10), Real(4.5)});
        click({Real(-5), Real(4.5)});
        click({Real(-6), Real(3.2)});
    }
    std::size_t grounds() {
        return static_cast<std::size_t>(
            std::count_if(level().obstructions.begin(), level().obstructions.end(),
                          [](const auto& def) { return def.kind == ObstructionKind::Ground; }));
    }
    const ObstructionDef& ground() { return level().obstructions.back(); }

    const Corners hill_ = {{-6000, 3200}, {-5000, 4500}, {-10000, 4500}, {-9000, 3200}};
};

TEST_F(EditorGround, ClicksDrawItAndTheFirstCornerEndsIt) {
    start();
    drawHill();
    EXPECT_EQ(grounds(), 0u) << "it is not finished";
    EXPECT_TRUE(rig_->picture().says("enter: done"));
    click({Real(-8.9), Real(3.25)});
    ASSERT_EQ(grounds(), 1u);
    EXPECT_EQ(ground().points, hill_) << "counter-clockwise, so that turf grows on its top";
    EXPECT_EQ(ground().turf, Turf::Grass);
    key("Z");
    EXPECT_EQ(grounds(), 0u);
    key("Y");
    EXPECT_EQ(grounds(), 1u);
}

TEST_F(EditorGround, KeysEndItTakeCornersBackAndDropIt) {
    start();
    drawHill();
    key("enter");
    ASSERT_EQ(grounds(), 1u);
    EXPECT_EQ(ground().points, hill_);
    button(EditorAct::Ground);
    click({4, 4});
    click({5, 4});
    click({5, 9}); // one too many
    key("Z");
    EXPECT_EQ(grounds(), 1u) << "that ground stays";
    key("enter");
    EXPECT_TRUE(rig_->picture().says("Ground has three corners or more."));
    click({Real(4.5), 5});
    key("enter");
    ASSERT_EQ(grounds(), 2u);
    EXPECT_EQ(ground().points, (Corners{{4000, 4000}, {5000, 4000}, {4500, 5000}}));
    button(EditorAct::Ground);
    click({-2, 4});
    rig_->press(Command::Back);
    ASSERT_EQ(rig_->stage.screen(), Screen::Editor);
    key("enter");
    EXPECT_EQ(grounds(), 2u) << "the outline was dropped";
}

TEST_F(EditorGround, OneThatCrossesItselfIsRefusedAndCanBeMended) {
    start();
    button(EditorAct::Ground);
    for (const Vec2 corner : {Vec2{4, 4}, Vec2{6, 5}, Vec2{6, 4}, Vec2{4, 5}}) {
        click(corner);
    }
    key("enter");
    EXPECT_EQ(grounds(), 0u);
    EXPECT_TRUE(rig_->picture().says("the outline of points crosses or touches itself"));
    key("X");
    key("enter");
    EXPECT_EQ(grounds(), 1u);
}

TEST_F(EditorGround, CornersAreDraggedAddedChosenAndRemoved) {
    start();
    drawHill();
    key("enter");
    key("A");
    drag({Real(-5), Real(4.5)}, {Real(-4), 5});
    EXPECT_EQ(ground().points[1], (GroundPoint{-4000, 5000}));
    key("up");
    EXPECT_EQ(ground().points[1], (GroundPoint{-4000, 5050})) << "the corner alone";
    EXPECT_EQ(ground().points[0], (GroundPoint{-6000, 3200}));
    drag({Real(-9.5), Real(3.85)}, {Real(-11), Real(3.8)}); // the middle of an edge
    ASSERT_EQ(ground().points.size(), 5u);
    EXPECT_EQ(ground().points[3], (GroundPoint{-11000, 3800}));
    click({Real(-10), Real(4.5)});
    key("X");
    ASSERT_EQ(ground().points.size(), 4u);
    EXPECT_EQ(ground().points[2], (GroundPoint{-11000, 3800}));
    for (int i = 0; i < 4; ++i) {
        key("Z");
    }
    EXPECT_EQ(ground().points, hill_);
}

TEST_F(EditorGround, ItIsMovedMirroredAndRemoved) {
    start();
    drawHill();
    key("enter");
    key("A");
    click({0, 12});
    drag({Real(-7.5), 4}, {-7, Real(4.5)});
    EXPECT_EQ(ground().points[0], (GroundPoint{-5500, 3700}));
    key("M");
    ASSERT_EQ(grounds(), 2u);
    EXPECT_EQ(ground().points, (Corners{{8500, 3700}, {9500, 5000}, {4500, 5000}, {5500, 3700}}));
    key("X");
    ASSERT_EQ(grounds(), 1u) << "the first one was chosen";
    EXPECT_EQ(ground().points[0].x, 8500);
}

TEST_F(EditorGround, ItsTurfIsThatOfTheButton) {
    start();
    button(EditorAct::Turf, 2);
    click({4, 4});
    click({6, 4});
    click({6, 5});
    key("enter");
    ASSERT_EQ(grounds(), 1u);
    EXPECT_EQ(ground().turf, Turf::Sand);
    button(EditorAct::Turf, 3);
    EXPECT_EQ(ground().turf, Turf::Timber) << "of the chosen one";
    EXPECT_EQ(grounds(), 1u);
}

TEST_F(EditorGround, ItEndsWithinAWallAndNotBelowThePaddlesLeap) {
    start();
    button(EditorAct::Ground);
    shift_ = true;
    click({Real(-12.5), 5});
    click({Real(-12.5), 1});
    click({Real(-8.123), Real(4.567)});
    key("enter");
    ASSERT_EQ(grounds(), 1u);
    EXPECT_EQ(ground().points, (Corners{{-12500, 5000}, {-12500, 3000}, {-8123, 4567}}));
}

TEST_F(EditorGround, ASavedOneIsReadByTheGame) {
    start();
    button(EditorAct::Turf, 1);
    drawHill();
    key("enter");
    button(EditorAct::Turf, 1);
    key("S");
    const Read<Level> read = readLevelFile(folder_ / "my_level.toml");
    ASSERT_TRUE(std::holds_alternative<Level>(read));
    EXPECT_EQ(std::get<Level>(read), level());
    EXPECT_EQ(std::get<Level>(read).obstructions.back().points, hill_);
    EXPECT_EQ(std::get<Level>(read).obstructions.back().turf, Turf::Rock);
}

TEST_F(EditorGround, AChosenOneStaysChosenWhileALedgeIsAddedBeforeIt) {
    start();
    drawHill();
    key("enter");
    button(EditorAct::Ledge);
    click({5, 9});
    ASSERT_EQ(editor().chosen().size(), 1u);
    EXPECT_EQ(level().obstructions[editor().chosen()[0].index].points, hill_);
}

TEST_F(EditorStage, WithShiftNothingSnaps) {
    start();
    shift_ = true;
    drag({0, Real(6.6)}, {Real(0.123), Real(6.711)});
    EXPECT_EQ(level().freeBlocks[0].x, 123);
    EXPECT_EQ(level().freeBlocks[0].y, 6711);
    button(EditorAct::Shape, 3);
    click({Real(3.017), Real(9.033)});
    ASSERT_EQ(level().freeBlocks.size(), 2u);
    EXPECT_EQ(level().freeBlocks[1].x, 3017);
    EXPECT_EQ(level().freeBlocks[1].y, 9033);
    button(EditorAct::Rope);
    drag({Real(0.333), Real(12.011)}, {Real(0.222), Real(6.744)});
    ASSERT_EQ(level().links.size(), 1u);
    EXPECT_EQ(level().links[0].fromX, 333);
    EXPECT_EQ(level().links[0].fromY, 12011);
    EXPECT_EQ(level().links[0].toX, 222);
    button(EditorAct::Ledge);
    drag({Real(5.003), Real(4.017)}, {Real(7.014), Real(4.017)});
    EXPECT_EQ(level().obstructions.back().size, 2011);
    EXPECT_EQ(level().obstructions.back().y, 4017);
    EXPECT_TRUE(rig_->picture().says("shift: no snapping"));
    key("Z");
    key("A");
    shift_ = false;
    drag({Real(3.017), Real(9.033)}, {Real(3.1), Real(9.133)});
    EXPECT_EQ(level().freeBlocks[1].x % kSnapGrid, 0);
}

TEST(HeldKeys, EitherShiftIsHeldUntilItIsReleased) {
    for (const char* name : {"left shift", "right shift"}) {
        HeldKeys keys;
        Signals signals;
        keys.press(*keyNamed(name), signals);
        keys.addHeld({}, signals);
        EXPECT_TRUE(signals.shiftHeld) << name;
        EXPECT_TRUE(signals.commands.empty()) << "it means nothing else";
        signals = {};
        keys.release(*keyNamed(name));
        keys.addHeld({}, signals);
        EXPECT_FALSE(signals.shiftHeld) << name;
    }
}

TEST(HeldKeys, TheLatestKeyIsTheOneThatRepeats) {
    HeldKeys keys;
    const auto held = [&] {
        Signals signals;
        keys.addHeld({}, signals);
        return signals.keyHeld;
    };
    Signals signals;
    EXPECT_EQ(held(), kNoKey);
    keys.press(*keyNamed("W"), signals);
    EXPECT_EQ(held(), keyNamed("W"));
    keys.press(*keyNamed("K"), signals);
    EXPECT_EQ(held(), keyNamed("K"));
    keys.release(*keyNamed("K"));
    EXPECT_EQ(held(), kNoKey);
    keys.press(*keyNamed("K"), signals);
    keys.releaseAll();
    EXPECT_EQ(held(), kNoKey);
}

/// Keeps the rectangles of a picture.
class Rectangles : public RecordingCanvas {
public:
    void rectangle(const Aabb& box, Color below, Color) override { all_.emplace_back(box, below); }
    /// The uppermost one.
    Color at(Vec2 place) const {
        const auto found = std::find_if(all_.rbegin(), all_.rend(), [&](const auto& rectangle) {
            return rectangle.first.contains(place);
        });
        return found == all_.rend() ? Color{} : found->second;
    }

private:
    std::vector<std::pair<Aabb, Color>> all_;
};

// Regression: a bar of the panel covered the upper right corner, and ran on above it.
TEST_F(EditorStage, NothingCoversTheCornersOfTheFrame) {
    start();
    Rectangles picture;
    rig_->stage.draw(picture);
    for (const Real beside : {Real(0.2), Real(0.43), Real(0.6)}) { // on the frame, and outside
        for (const Real above : {Real(-2), Real(0.2), Real(0.7)}) {
            const Vec2 right{layout::kRight + beside, layout::kTop + above};
            EXPECT_EQ(picture.at(right), picture.at({-right.x, right.y}))
                << beside << ", " << above;
        }
    }
}

} // namespace
} // namespace apart
