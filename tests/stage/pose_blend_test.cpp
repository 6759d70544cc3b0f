// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/pose_blend.hpp>

#include <gtest/gtest.h>

namespace apart {
namespace {

using kodo::Vec2;

TEST(PoseBlend, ShowsABodyHalfWayBetweenTwoTicks) {
    kodo::World world;
    const kodo::BodyId ball = world.add({.shape = kodo::Circle{0.5f}, .position = {1, 2}});
    PoseBlend poses;
    poses.remember(world);
    world[ball].setPosition({1.5f, 2});
    EXPECT_EQ(poses.center(world[ball], 0), (Vec2{1, 2}));
    EXPECT_EQ(poses.center(world[ball], 0.5f), (Vec2{1.25f, 2}));
    EXPECT_EQ(poses.center(world[ball], 1), (Vec2{1.5f, 2}));
}

TEST(PoseBlend, ShowsANewBodyAtItsPose) {
    kodo::World world;
    PoseBlend poses;
    poses.remember(world);
    const kodo::BodyId ball = world.add({.shape = kodo::Circle{0.5f}, .position = {4, 4}});
    EXPECT_EQ(poses.center(world[ball], 0), (Vec2{4, 4}));
}

TEST(PoseBlend, DoesNotInterpolateATeleport) {
    kodo::World world;
    const kodo::BodyId ball = world.add({.shape = kodo::Circle{0.5f}, .position = {0, 0}});
    PoseBlend poses;
    poses.remember(world);
    world[ball].setPosition({10, 0});
    EXPECT_EQ(poses.center(world[ball], 0.5f), (Vec2{10, 0}));
}

TEST(PoseBlend, AReusedSlotIsAnotherBody) {
    kodo::World world;
    const kodo::BodyId first = world.add({.shape = kodo::Circle{0.5f}, .position = {0, 0}});
    PoseBlend poses;
    poses.remember(world);
    world.remove(first);
    const kodo::BodyId second = world.add({.shape = kodo::Circle{0.5f}, .position = {1, 0}});
    ASSERT_EQ(first.index, second.index);
    EXPECT_EQ(poses.center(world[second], 0), (Vec2{1, 0}));
}

// A weld moves the centre of mass but no corner, so the picture must stay continuous.
TEST(PoseBlend, AWeldMovesNoCorner) {
    kodo::World world;
    const kodo::BodyId paddle =
        world.add({.shape = kodo::Box{4, 1}, .position = {0, 0}, .type = kodo::BodyType::Static});
    const kodo::BodyId part = world.add({.shape = kodo::Box{1, 1}, .position = {2, 1}});
    const auto corner = [&](const PoseBlend& poses) {
        const kodo::BodyView body = world[paddle];
        return poses.massFrame(body, 0.5f) * body.part(0).convex.vertices[0];
    };
    PoseBlend poses;
    poses.remember(world);
    const Vec2 before = corner(poses);
    world.weld(paddle, part);
    const Vec2 after = corner(poses);
    EXPECT_NEAR(after.x, before.x, 1e-5f); // rounding of coordinates of a few metres
    EXPECT_NEAR(after.y, before.y, 1e-5f);
}

} // namespace
} // namespace apart
