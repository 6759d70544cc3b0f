// SPDX-License-Identifier: MIT
#include <apart/core/editor/edit_document.hpp>
#include <apart/core/editor/ground_edit.hpp>
#include <apart/core/editor/level_edit.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace apart {
namespace {

using kodo::Real;
using kodo::Vec2;
using Of = LevelPart::Of;
using Corners = std::vector<GroundPoint>;

/// A valley: its middle is open from above.
const Corners kValley = {{-9000, 3500}, {-5000, 3500}, {-5000, 6000}, {-7000, 4000}, {-9000, 6000}};

Level valley() {
    return withGround(newLevel("valley"), kValley, Turf::Sand);
}
std::size_t last(const Level& level) {
    return level.obstructions.size() - 1;
}

TEST(GroundEdit, CornersOfEitherDirectionMakeTheSameOutline) {
    const Corners clockwise(kValley.rbegin(), kValley.rend());
    const Level level = withGround(newLevel("valley"), clockwise, Turf::Sand);
    EXPECT_EQ(level.obstructions[last(level)].points, kValley);
    EXPECT_EQ(level, valley());
}

TEST(GroundEdit, ItIsFoundByItsOutlineAndNotByItsBounds) {
    const Level level = valley();
    EXPECT_EQ(partAt(level, {-7, Real(3.8)}), (LevelPart{Of::Obstruction, last(level)}));
    EXPECT_EQ(partAt(level, {Real(-8.8), Real(5.7)}), (LevelPart{Of::Obstruction, last(level)}));
    EXPECT_FALSE(partAt(level, {-7, 5})) << "in the valley";
}

TEST(GroundEdit, ACornerIsTakenBeforeTheMiddleOfAnEdge) {
    const Level level = valley();
    const ObstructionDef& ground = level.obstructions[last(level)];
    EXPECT_EQ(gripAt(ground, {Real(-6.9), Real(4.1)}), (GroundGrip{3, false}));
    EXPECT_EQ(gripAt(ground, {Real(-7.1), Real(3.5)}), (GroundGrip{0, true}));
    EXPECT_FALSE(gripAt(ground, {-7, 5}));
    ObstructionDef small;
    small.points = {{0, 4000}, {300, 4000}, {300, 4300}};
    EXPECT_EQ(gripAt(small, {Real(0.16), 4}), (GroundGrip{1, false}));
}

TEST(GroundEdit, CornersAreMovedAddedAndRemoved) {
    Level level = withCorner(valley(), 1, {3}, {-7000, 4500});
    EXPECT_EQ(level.obstructions[1].points[3], (GroundPoint{-7000, 4500}));
    level = withCorner(std::move(level), 1, {0, true}, {-7000, 3000});
    EXPECT_EQ(level.obstructions[1].points[1], (GroundPoint{-7000, 3000}));
    level = withoutCorner(withoutCorner(std::move(level), 1, 4), 1, 1);
    EXPECT_EQ(level.obstructions[1].points,
              (Corners{{-9000, 3500}, {-5000, 3500}, {-5000, 6000}, {-9000, 6000}}));
}

// A triangle whose tip is dragged through its base would else have its turf below.
TEST(GroundEdit, AnOutlineThatIsTurnedOverStaysCounterClockwise) {
    Level level = withGround(newLevel("tip"), {{0, 5000}, {4000, 5000}, {2000, 7000}}, Turf::Grass);
    level = withCorner(level, last(level), {2}, {2000, 3500});
    EXPECT_EQ(level.obstructions[last(level)].points,
              (Corners{{2000, 3500}, {4000, 5000}, {0, 5000}}));
}

TEST(GroundEdit, TheDocumentRefusesAnOutlineThatCrossesItself) {
    EditDocument document(newLevel("own"));
    ASSERT_EQ(document.apply(withGround(*document.level(), kValley, Turf::Grass)), "");
    const auto before = document.level();
    EXPECT_EQ(document.apply(withCorner(*before, 1, {3}, {-7000, 3200})),
              "the outline of points crosses or touches itself");
    EXPECT_EQ(
        document.apply(withoutCorner(withoutCorner(withoutCorner(*before, 1, 0), 1, 0), 1, 0)),
        "points must be a list of 3 to 64 corners [x, y] of an outline");
    EXPECT_EQ(document.level(), before);
    document.undo();
    EXPECT_EQ(*document.level(), newLevel("own"));
}

TEST(GroundEdit, AMirrorImageIsReadAsItWasWritten) {
    Level level = valley();
    ObstructionDef hills;
    hills.kind = ObstructionKind::Ground;
    hills.x = -11000;
    hills.spacing = 1000;
    hills.heights = {900, 300, 0};
    level.obstructions.push_back(hills);
    const LevelParts both = {{Of::Obstruction, 1}, {Of::Obstruction, 2}};
    level = withMirrorImages(std::move(level), both);
    ASSERT_EQ(level.obstructions.size(), 5u);
    EXPECT_EQ(level.obstructions[3].points,
              (Corners{{9000, 6000}, {7000, 4000}, {5000, 6000}, {5000, 3500}, {9000, 3500}}));
    EXPECT_EQ(level.obstructions[3].turf, Turf::Sand);
    EXPECT_EQ(level.obstructions[4].x, 9000);
    EXPECT_EQ(level.obstructions[4].heights, (std::vector<std::int32_t>{0, 300, 900}));
    EditDocument document(newLevel("valley"));
    EXPECT_EQ(document.apply(level), "");
    EXPECT_EQ(*document.level(), level);
}

TEST(GroundEdit, AFlippedOneKeepsItsPlace) {
    Level level = withGround(newLevel("flip"), {{0, 4000}, {4000, 4000}, {4000, 6000}}, Turf::Rock);
    const LevelParts ground = {{Of::Obstruction, last(level)}};
    level = flipped(std::move(level), ground);
    EXPECT_EQ(level.obstructions[last(level)].points,
              (Corners{{0, 6000}, {0, 4000}, {4000, 4000}}));
}

TEST(GroundEdit, BlocksAreSnappedOntoItsLevelEdges) {
    const Level level = withGround(
        newLevel("hill"), {{5000, 3500}, {9000, 3500}, {8000, 4710}, {6000, 4710}}, Turf::Grass);
    const kodo::Aabb bounds{{-1, Real(-0.5)}, {1, Real(0.5)}};
    // 140 mm above the top, 90 mm beside its middle: on it, in the middle.
    EXPECT_EQ(snapped(level, bounds, {}, {7090, 5350}), (EditStep{7000, 5210}));
    // Beside its slope: on the grid alone.
    EXPECT_EQ(snapped(level, bounds, {}, {9511, 4111}), (EditStep{9500, 4100}));
}

TEST(GroundEdit, CornersGoOntoTheGridOrAnywhereWithinTheBoundsOfALevelFile) {
    const Level level = newLevel("own"); // its ledge has its end at (4, 6.2)
    EXPECT_EQ(cornerAt(level, {Real(7.513), Real(4.437)}, false), (GroundPoint{7500, 4450}));
    EXPECT_EQ(cornerAt(level, {Real(7.513), Real(4.437)}, true), (GroundPoint{7513, 4437}));
    EXPECT_EQ(cornerAt(level, {Real(4.1), Real(6.1)}, false), (GroundPoint{4000, 6200}));
    EXPECT_EQ(cornerAt(level, {-14, 1}, true), (GroundPoint{-13000, 3000}));
    EXPECT_EQ(cornerAt(level, {14, 19}, true), (GroundPoint{13000, 18000}));
}

TEST(GroundEdit, PartsAreFollowedIntoTheOrderOfTheFile) {
    EditDocument document(valley());
    const Level wanted = withLedge(*document.level(), {5, 9}, 2000);
    const LevelParts ground = {{Of::Obstruction, 1}};
    ASSERT_EQ(document.apply(wanted), "");
    const LevelParts after = followed(ground, wanted, *document.level());
    EXPECT_EQ(after, (LevelParts{{Of::Obstruction, 2}}));
    EXPECT_EQ(document.level()->obstructions[2].points, kValley);
}

} // namespace
} // namespace apart
