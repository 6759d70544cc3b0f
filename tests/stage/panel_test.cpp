// SPDX-License-Identifier: MIT
// What the panel and the questions of a game say.
#include <apart/core/endless.hpp>
#include <apart/stage/daily.hpp>
#include <apart/stage/palette.hpp>

#include <gtest/gtest.h>

#include "stage_rig.hpp"

namespace apart {
namespace {

// Regression: the balls in reserve were rings, which look like lost ones.
TEST(Panel, HasAFilledDotForEachBall) {
    StageRig rig(StageRig::playing());
    const auto inRow = [&](Stroke::Kind kind) {
        const auto& strokes = rig.picture().strokes();
        return std::count_if(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
            return stroke.kind == kind && stroke.place.y == Real(10.8) &&
                   stroke.color.r == palette::kBall.r;
        });
    };
    ASSERT_EQ(rig.stage.game().lives(), 3);
    EXPECT_EQ(inRow(Stroke::Kind::Disc), 3);
    EXPECT_EQ(inRow(Stroke::Kind::Ring), 0);
}

} // namespace
} // namespace apart
