// SPDX-License-Identifier: MIT
// A pointer from its press to its release.
#include <gtest/gtest.h>

#include <hand_use.hpp>

namespace {

using namespace destructoooor;

// A second finger or a cancelled touch: the first one meant the view.
TEST(Stroke, AnAbandonedPointerDoesNotAct) {
    for (std::size_t hand = 0; hand < kHands.size(); ++hand) {
        Sandbox sandbox; // with a pyramid
        const std::vector<BodyId> bodies = sandbox.world().bodies();
        const std::size_t joints = sandbox.world().joints().size();
        const Vec2 from = sandbox.world()[bodies[1]].center();
        const Vec2 to = sandbox.world()[bodies.back()].center();
        Stroke stroke;
        stroke.press(sandbox, static_cast<Hand>(hand), from);
        stroke.move(sandbox, to);
        EXPECT_TRUE(stroke.isDown());
        stroke.abandon(sandbox);
        EXPECT_FALSE(stroke.isDown());
        EXPECT_EQ(stroke.release(sandbox, {}, to), "") << kHands[hand].name;
        EXPECT_EQ(sandbox.world().bodies(), bodies) << kHands[hand].name;
        EXPECT_EQ(sandbox.world().joints().size(), joints) << kHands[hand].name;
        EXPECT_EQ(sandbox.world()[bodies.back()].velocity(), (Vec2{})) << kHands[hand].name;
    }
}

TEST(Stroke, AStrokeActsByTheHandOfItsPress) {
    Sandbox sandbox;
    const std::size_t before = sandbox.world().bodyCount();
    Stroke stroke;
    stroke.press(sandbox, Hand::Drop, {0, 12});
    EXPECT_EQ(stroke.release(sandbox, {}, {1, 12}), "");
    EXPECT_EQ(sandbox.world().bodyCount(), before + 1);
    EXPECT_FALSE(stroke.isDown());
}

} // namespace
